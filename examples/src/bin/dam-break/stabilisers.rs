//! Each stabiliser switched in turn: what it brings and what it costs.

use crate::options::Options;
use mps_examples::{Failure, Precision, Weight};
use mps_io::Summary;
use std::fmt::Write;
use std::path::Path;

/// Name of a run and what differs from the options given.
type Variant = (&'static str, fn(&mut Options));

const VARIANTS: &[Variant] = &[
    ("as given", |_| ()),
    ("no density diffusion", |o| o.diffusion = 0.0),
    ("filter, delta 0.2", |o| o.diffusion = 0.2),
    ("filter, delta 1", |o| o.diffusion = 1.0),
    ("hydrostatic diffusion", |o| o.hydrostatic_diffusion = true),
    ("no collisions", |o| o.no_dpc = true),
    ("shifting, k = 1", |o| o.shifting = 1),
    ("shifting, k = 3", |o| o.shifting = 3),
    ("shifting, k = 5", |o| o.shifting = 5),
    ("corrected sums", |o| o.corrected = true),
    ("corrected sums, shifting, k = 1", |o| (o.corrected, o.shifting) = (true, 1)),
    ("suction kept", |o| o.keep_tension = true),
    ("walls without friction", |o| o.walls = crate::setup::Walls::Free),
    ("alpha 0", |o| o.alpha = 0.0),
    ("alpha 0.1", |o| o.alpha = 0.1),
    ("smooth weight, radius 3", |o| o.radius = Some(3.0)),
    ("smooth weight, radius 3.5", |o| o.radius = Some(3.5)),
    ("rational weight, radius 3", |o| o.weight = Weight::Rational),
    ("rational weight, radius 4", |o| (o.weight, o.radius) = (Weight::Rational, Some(4.0))),
    ("f32", |o| o.common.precision = Precision::F32),
];

/// Columns of the table: heading and metric.
const COLUMNS: &[(&str, &str)] = &[
    ("disorder", "particle_disorder"),
    ("noise", "pressure_noise"),
    ("peak 1", "peak_sensor1"),
    ("band 1", "band_fraction_sensor1"),
    ("energy lost", "energy_dissipated"),
    ("energy rise", "energy_rise"),
    ("volume", "volume_drift"),
    ("leaked", "leaked_particles"),
];

/// Runs all variants below `dir` and writes `stabilisers.md` after each, so that an interrupted comparison keeps what
/// it has.
pub(crate) fn compare(
    options: &Options,
    dir: &Path,
    run: impl Fn(&Options) -> Result<Summary, Failure>,
) -> Result<(), Failure> {
    mps_io::prepare_output(dir)?;
    let mut text = format!(
        "# Stabilisers of the dam break at l0 = {} mm\n\n| run | {} | ns |\n|---|{}---|\n",
        options.spacing * 1e3,
        COLUMNS.iter().map(|c| c.0).collect::<Vec<_>>().join(" | "),
        "---|".repeat(COLUMNS.len())
    );
    for (name, change) in VARIANTS {
        let mut changed = options.clone();
        changed.common.no_fields = true;
        // The price of a step is that of the step alone.
        changed.no_books = true;
        changed.common.out = Some(dir.join(name.replace([' ', ',', '='], "-")));
        change(&mut changed);
        row(&mut text, name, &run(&changed)?);
        std::fs::write(dir.join("stabilisers.md"), &text)?;
    }
    Ok(())
}

fn row(text: &mut String, name: &str, summary: &Summary) {
    let value = |metric: &str| summary.metrics.get(metric).map(|m| m.value);
    let words = |metric: &(&str, &str)| value(metric.1).map_or("-".to_owned(), |v| format!("{v:.2e}"));
    let columns: Vec<_> = COLUMNS.iter().map(words).collect();
    // Time of the processors for one particle and step, whatever the number of threads.
    let price = 1e9 * summary.threads as f64 / summary.particle_steps_per_second;
    let failed = if summary.status == "completed" { "" } else { " (failed)" };
    let _ = writeln!(text, "| {name}{failed} | {} | {price:.0} |", columns.join(" | "));
}
