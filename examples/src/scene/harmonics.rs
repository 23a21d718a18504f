//! What oscillates in a run that was made before.

use super::table::Probes;
use crate::harmonics::strongest;
use crate::{Failure, Refused};
use mps_io::number;
use std::fmt::Write;
use std::path::Path;

/// Most rows of the part: a tenth of a gigabyte.
const MOST: usize = 1 << 18;

/// Which part of a run is taken apart, and how far.
#[derive(Clone, Copy, Debug)]
pub struct Window {
    /// Begin \[s\]; the middle of the run for `None`.
    pub from: Option<f64>,
    /// End \[s\]; that of the run for `None`.
    pub to: Option<f64>,
    /// How many harmonics.
    pub count: usize,
}

/// The mean and the strongest harmonics of columns of the table of probes of the run in `dir`, as a table in Markdown. All columns but the time for none.
///
/// # Errors
/// If there is no such table, it has no such columns, fewer than ten rows in the window or too many, or a time is none.
pub fn harmonics(dir: &Path, columns: &[String], window: Window) -> Result<String, Failure> {
    let probes = Probes::of(dir)?;
    let table = &probes.table;
    let mut chosen = columns.iter().map(|name| probes.column(name)).collect::<Result<Vec<usize>, _>>()?;
    if columns.is_empty() {
        chosen.extend(1..table.names.len());
    }
    let time = &table.columns[0];
    let last = time.last().copied().unwrap_or(0.0);
    let (from, to) = (window.from.unwrap_or(0.5 * last), window.to.unwrap_or(last));
    let rows = time.partition_point(|t| *t < from)..time.partition_point(|t| *t <= to);
    let given = "give a time of the run in seconds, or leave it out";
    Refused::unless(from.is_finite(), "--from", from, given)?;
    Refused::unless(to.is_finite(), "--to", to, given)?;
    let advice =
        format!("the run has {} rows up to {} s: give an earlier time", time.len(), number(last, 4, last));
    Refused::unless(rows.len() >= 10, "--from", from, advice)?;
    let parts = "more than can be taken apart at once: give a part of the run with --from and --to";
    Refused::unless(rows.len() <= MOST, "rows", rows.len(), parts)?;

    let mut text = format!("| {} to {} s | mean |", number(from, 4, to), number(to, 4, to));
    for k in 1..=window.count {
        let _ = write!(text, " amplitude {k} | Hz |");
    }
    let _ = writeln!(text, " rest |\n|---|---|{}---|", "---|---|".repeat(window.count));
    for column in chosen {
        let value = &table.columns[column][rows.clone()];
        let found = strongest(&time[rows.clone()], value, window.count);
        let mean = value.iter().sum::<f64>() / value.len() as f64;
        // The fit of the strongest knows the mean better than a window that cuts periods.
        let mean = found.first().map_or(mean, |strongest| strongest.mean);
        let _ = write!(text, "| {} | {mean:.5e} |", table.names[column]);
        for k in 0..window.count {
            let _ = match found.get(k) {
                Some(harmonic) => write!(text, " {:.4e} | {:.4} |", harmonic.amplitude, harmonic.frequency),
                None => write!(text, " - | - |"),
            };
        }
        let rest = found.last().map_or(0.0, |weakest| weakest.rest);
        let _ = writeln!(text, " {rest:.3e} |");
    }
    Ok(text)
}
