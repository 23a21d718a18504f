//! The plate at several resolutions, as a table with the orders of convergence.

use crate::Ended;
use crate::options::Options;
use mps_examples::Failure;
use mps_examples::solid::plate::{AMPLITUDE, PERIOD_EXTRAPOLATED};
use mps_io::{CurvePlot, Summary};
use std::fmt::Write;
use std::path::Path;

/// Particles across: two series that double.
const ACROSS: [usize; 5] = [4, 5, 8, 10, 20];

/// Runs all of them below `dir` and writes `convergence.md` after each, so that an interrupted comparison keeps what it
/// has, and `convergence.png`.
pub(crate) fn compare(
    options: &Options,
    dir: &Path,
    run: impl Fn(usize, &Path) -> Result<Ended, Failure>,
) -> Result<(), Failure> {
    let mut text = format!(
        "# The vibrating plate, {} law\n\n\
         Reference: T c_s/L = {PERIOD_EXTRAPOLATED}, A/L = {AMPLITUDE}; the order is that from half as many across.\n\n\
         | across | particles | T c_s/L | error | order | A/L | error | energy drift | particle-steps/s |\n\
         |---|---|---|---|---|---|---|---|---|\n",
        format!("{:?}", options.material).to_lowercase()
    );
    let mut errors: Vec<(usize, f64)> = Vec::new();
    for across in ACROSS {
        let below = dir.join(across.to_string());
        mps_io::prepare_output(&below)?;
        let (summary, done) = run(across, &below)?;
        summary.write(&below)?;
        done?;
        let value = |name: &str| summary.metrics.get(name).map_or(f64::NAN, |metric| metric.value);
        let error = value("period") / PERIOD_EXTRAPOLATED - 1.0;
        let half = errors.iter().find(|(n, _)| 2 * n == across);
        let order = half.map_or(String::new(), |(_, coarse)| format!("{:.1}", (coarse / error).abs().log2()));
        row(&mut text, across, &summary, error, &order);
        std::fs::write(dir.join("convergence.md"), &text)?;
        errors.push((across, error));
    }
    let (across, error): (Vec<f64>, Vec<f64>) =
        errors.iter().map(|(n, e)| (*n as f64, 100.0 * e.abs())).unzip();
    let slope =
        |order: i32| across.iter().map(|n| error[0] * (across[0] / n).powi(order)).collect::<Vec<_>>();
    CurvePlot::new("Period of the vibrating plate", "particles across [–]", "error of the period [%]")
        .log_x()
        .log_y()
        .points("this run", &across, &error)
        .dashed("order 1", &across, &slope(1))
        .dashed("order 2", &across, &slope(2))
        .write_png(dir.join("convergence.png"))?;
    Ok(())
}

fn row(text: &mut String, across: usize, summary: &Summary, error: f64, order: &str) {
    let value = |name: &str| summary.metrics.get(name).map_or(f64::NAN, |metric| metric.value);
    let amplitude = value("amplitude");
    // Writing into a String cannot fail.
    let _ = writeln!(
        text,
        "| {across} | {} | {:.3} | {:+.2} % | {order} | {amplitude:.4} | {:+.2} % | {:.1e} | {:.1e} |",
        summary.particles.values().sum::<u64>(),
        value("period"),
        100.0 * error,
        100.0 * (amplitude / AMPLITUDE - 1.0),
        value("energy_drift"),
        value("particle_steps_per_second"),
    );
}
