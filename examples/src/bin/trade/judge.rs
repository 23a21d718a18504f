//! From a run to its row: errors, and how far beyond the tolerances they are.

use crate::run::Record;
use crate::sweep::{Setting, Sweep};
use mps_io::Summary;
use serde::Serialize;
use std::path::Path;

/// One run in the table.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Row {
    /// What is special about it.
    pub(crate) label: String,
    /// Where it belongs in the plot.
    #[serde(skip)]
    pub(crate) group: String,
    /// Arguments of the program.
    pub(crate) arguments: Vec<String>,
    /// Cost \[s\], see [`Record::cost`].
    pub(crate) cost_seconds: f64,
    /// From start to end of the process \[s\].
    pub(crate) wall_seconds: f64,
    /// Largest memory \[bytes\].
    pub(crate) peak_memory_bytes: Option<u64>,
    /// Time steps.
    pub(crate) steps: u64,
    /// Error of each result that counts, with its sign; empty if the run failed.
    pub(crate) errors: Vec<f64>,
    /// Values of the results that are shown beside.
    pub(crate) also: Vec<Option<f64>>,
    /// The largest error over its tolerance; `None` if the run failed.
    pub(crate) error_over_tolerance: Option<f64>,
    /// Why it failed, if so.
    pub(crate) failure: Option<String>,
    /// The day it was made.
    pub(crate) date: Option<String>,
    /// The machine it was made on.
    pub(crate) machine: Option<String>,
}

/// The row of a run whose files are in `dir`.
pub(crate) fn judge(sweep: &Sweep, setting: &Setting, record: &Record, dir: &Path) -> Row {
    let summary = Summary::read(dir.join("summary.json")).ok();
    let metric = |name: &str| summary.as_ref().and_then(|summary| summary.metrics.get(name));
    let mut failure = record.failure.clone();
    let mut errors = Vec::new();
    for count in sweep.counts.iter().filter(|_| record.failure.is_none()) {
        match metric(&count.metric).and_then(|metric| metric.error).filter(|error| error.is_finite()) {
            Some(error) => errors.push(error),
            None => failure = Some(format!("summary.json has no error of {}", count.metric)),
        }
    }
    if failure.is_some() {
        errors.clear();
    }
    let shares = errors.iter().zip(&sweep.counts);
    let worst =
        shares.map(|(error, count)| error.abs().max(count.uncertainty) / count.tolerance).reduce(f64::max);
    Row {
        label: setting.label.clone(),
        group: setting.group.clone(),
        arguments: setting.arguments.clone(),
        cost_seconds: record.cost(),
        wall_seconds: record.wall_seconds,
        peak_memory_bytes: summary.as_ref().and_then(|summary| summary.peak_memory_bytes),
        steps: summary.as_ref().map_or(0, |summary| summary.steps),
        also: sweep.also.iter().map(|name| Some(metric(name)?.value)).collect(),
        errors,
        error_over_tolerance: worst,
        failure,
        date: record.date.clone(),
        machine: record.machine.clone(),
    }
}
