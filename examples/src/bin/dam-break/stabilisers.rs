//! Each stabiliser switched in turn: what it brings and what it costs.

use crate::Ended;
use crate::options::Options;
use mps_examples::{Failure, Precision, Stopped, Weight};
use mps_io::Summary;
use std::fmt::Write;
use std::path::Path;

/// Name of a run and what differs from the options given: everything its name says, whatever these are.
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
    ("smooth weight, radius 3", |o| (o.weight, o.radius) = (Weight::Smooth, Some(3.0))),
    ("smooth weight, radius 3.5", |o| (o.weight, o.radius) = (Weight::Smooth, Some(3.5))),
    ("rational weight, radius 3", |o| (o.weight, o.radius) = (Weight::Rational, Some(3.0))),
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
/// it has. One that breaks off has its row as well, and the others go on; one that is stopped ends them all.
///
/// # Errors
/// If one was stopped or broke off, at the end: which.
pub(crate) fn compare(
    options: &Options,
    dir: &Path,
    run: impl Fn(&Options) -> Result<Ended, Failure>,
) -> Result<(), Failure> {
    mps_io::prepare_output(dir)?;
    let mut text = format!(
        "# Stabilisers of the dam break at l0 = {} mm\n\n| run | {} | ns |\n|---|{}---|\n",
        options.spacing * 1e3,
        COLUMNS.iter().map(|c| c.0).collect::<Vec<_>>().join(" | "),
        "---|".repeat(COLUMNS.len())
    );
    let mut failed = Vec::new();
    for (name, change) in VARIANTS {
        let mut changed = options.clone();
        changed.common.no_fields = true;
        // The price of a step is that of the step alone.
        changed.no_books = true;
        changed.common.out = Some(dir.join(name.replace([' ', ',', '='], "-")));
        change(&mut changed);
        let (summary, done) = run(&changed)?;
        let failure = done.err();
        let stopped = failure.as_ref().is_some_and(|failure| failure.is::<Stopped>());
        let mark = match (stopped, &failure) {
            (true, _) => " (stopped)",
            (false, Some(_)) => " (failed)",
            (false, None) => "",
        };
        row(&mut text, &format!("{name}{mark}"), &summary);
        std::fs::write(dir.join("stabilisers.md"), &text)?;
        if let Some(failure) = failure {
            if stopped {
                return Err(failure);
            }
            failed.push(format!("{name}: {failure}"));
        }
    }
    if failed.is_empty() {
        return Ok(());
    }
    let (count, all) = (failed.len(), VARIANTS.len());
    Err(format!("{count} of {all} runs broke off; the rest is in {}: {}", dir.display(), failed.join("; "))
        .into())
}

fn row(text: &mut String, name: &str, summary: &Summary) {
    let value = |metric: &str| summary.metrics.get(metric).map(|m| m.value);
    let words = |metric: &(&str, &str)| value(metric.1).map_or("-".to_owned(), |v| format!("{v:.2e}"));
    let columns: Vec<_> = COLUMNS.iter().map(words).collect();
    // Time of the processors for one particle and step, whatever the number of threads.
    let price = 1e9 * summary.threads as f64 / summary.particle_steps_per_second;
    let _ = writeln!(text, "| {name} | {} | {price:.0} |", columns.join(" | "));
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    fn options(arguments: &[&str]) -> Options {
        Options::parse_from([&["dam-break"], arguments].concat())
    }

    /// Whatever was given beside `--stabilisers`.
    #[test]
    fn a_run_with_a_weight_in_its_name_has_that_weight_and_radius() {
        let mut found = 0;
        for (name, change) in VARIANTS {
            let Some((weight, radius)) = name.split_once(" weight, radius ") else { continue };
            for given in [&["--weight", "rational", "--radius", "5"][..], &["--weight", "smooth"], &[]] {
                let mut changed = options(given);
                change(&mut changed);
                let wanted = if weight == "smooth" { Weight::Smooth } else { Weight::Rational };
                assert_eq!((changed.weight, changed.radius), (wanted, radius.parse().ok()), "{name}");
            }
            found += 1;
        }
        assert_eq!(found, 4);
    }

    #[test]
    fn what_breaks_off_is_told_and_the_others_go_on() {
        let dir = std::env::temp_dir().join(format!("mps-stabilisers-{}", std::process::id()));
        let run = |options: &Options| -> Result<Ended, Failure> {
            let done = if options.no_dpc { Err("it burst".into()) } else { Ok(()) };
            Ok((Summary::new("dam-break", "0"), done))
        };
        let said = compare(&options(&[]), &dir, run).unwrap_err().to_string();
        assert!(
            said.starts_with("1 of 20 runs broke off") && said.ends_with("no collisions: it burst"),
            "{said}"
        );
        let table = std::fs::read_to_string(dir.join("stabilisers.md")).unwrap();
        assert!(table.contains("| no collisions (failed) |") && table.contains("| f32 |"), "{table}");
        std::fs::remove_dir_all(&dir).unwrap();
    }
}
