//! What a program says to its user at the end.

use crate::Failure;
use mps_io::Summary;
use std::path::Path;

/// Why the run has not come to its end, on standard error.
#[allow(clippy::print_stderr, reason = "a program talks to its user")]
pub fn report_failure(failure: &Failure) {
    eprintln!("error: {failure}");
}

/// The results, how far they are from what they are compared with, and where everything lies.
#[allow(clippy::print_stdout, reason = "a program talks to its user")]
pub fn closing_words(dir: &Path, summary: &Summary) {
    for (name, metric) in &summary.metrics {
        let compared = match (&metric.error, &metric.reference_source) {
            (Some(error), Some(source)) if metric.reference != Some(0.0) => {
                format!("  ({:+.1} % against {source})", error * 100.0)
            }
            _ => String::new(),
        };
        println!("{name:36} {:.4e} {}{compared}", metric.value, metric.unit);
    }
    println!("results in {}", dir.display());
}
