//! Tables of a report, in Markdown.

use mps_kernel::{Real, Vector};
use std::fmt::Write;

/// A table with these headings.
pub(super) fn table(headings: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut text = String::new();
    let mut line = |cells: &[&str]| {
        // Writing into a String cannot fail.
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    };
    line(headings);
    line(&vec!["---"; headings.len()]);
    for row in rows {
        line(&row.iter().map(String::as_str).collect::<Vec<_>>());
    }
    text
}

/// A number for reading; a dash for none.
pub(super) fn number(x: f64) -> String {
    if x == 0.0 {
        "0".to_owned()
    } else if (1e-2..1e4).contains(&x.abs()) {
        format!("{x:.4}")
    } else {
        format!("{x:.4e}")
    }
}

/// A number of a run.
pub(super) fn of<T: Real>(x: T) -> String {
    number(x.to_double())
}

/// The components of a vector and its length, a cell each.
pub(super) fn cells<T: Real, const D: usize>(v: &Vector<T, D>) -> Vec<String> {
    v.iter().copied().chain([v.norm()]).map(of).collect()
}
