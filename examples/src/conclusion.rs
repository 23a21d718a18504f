//! What every program says about a run: settings all have, cost, how it ended.

use crate::{Common, Failure, closing_words, report_failure};
use mps_fluid::{Compressibility, Fluid, Viscosity};
use mps_io::{Metric, Summary};
use mps_kernel::{Kernel, Real};
use mps_neighbors::Domain;
use std::path::Path;
use std::process::ExitCode;

/// What a run has cost.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    /// Threads used.
    pub threads: usize,
    /// Steps taken.
    pub steps: u64,
    /// What these steps have taken, without watching and writing \[s\].
    pub seconds: f64,
    /// Simulated time \[s\].
    pub simulated: f64,
    /// Particles moved in a step.
    pub particles: usize,
}

impl Cost {
    /// Writes cost, precision and the end of the run into the summary, whose particles are filled in.
    pub fn enter(&self, summary: &mut Summary, common: &Common, failure: Option<&Failure>) {
        summary.threads = self.threads;
        summary.precision = common.precision.name().to_owned();
        summary.measure(self.steps, self.seconds, self.simulated);
        summary.particle_steps_per_second = self.particles as f64 * self.steps as f64 / self.seconds;
        if let Some(failure) = failure {
            summary.status = failure.to_string();
        }
        let wall = Metric::new(summary.wall_seconds_per_simulated_second, "-");
        let speed = Metric::new(summary.particle_steps_per_second, "1/s");
        summary.metrics.insert("wall_seconds_per_simulated_second".to_owned(), wall);
        summary.metrics.insert("particle_steps_per_second".to_owned(), speed);
    }
}

/// Puts results into a summary; where the run has not come so far, a note says so.
pub fn enter_results(summary: &mut Summary, results: impl IntoIterator<Item = (String, Option<Metric>)>) {
    for (name, metric) in results {
        match metric {
            Some(metric) => drop(summary.metrics.insert(name, metric)),
            None => summary.notes.push(format!("{name}: the run ended before")),
        }
    }
}

/// Puts into a summary how compressible a fluid has been at most.
pub fn enter_compressibility<T, const D: usize, K, V, P>(summary: &mut Summary, fluid: &Fluid<T, D, K, V, P>)
where
    T: Real,
    K: Kernel<T>,
    V: Viscosity<T, D>,
    P: Domain<T, D>,
{
    let Compressibility { mach, density } = fluid.largest_compressibility();
    for (name, value) in [("largest_mach_number", mach), ("largest_density_deviation", density)] {
        summary.metrics.insert(name.to_owned(), Metric::new(value.to_double(), "-"));
    }
}

/// Writes `summary.json` and, of a run that was completed, the closing words.
///
/// # Errors
/// If the file cannot be written.
pub fn conclude(dir: &Path, summary: &Summary, common: &Common, completed: bool) -> Result<(), Failure> {
    summary.write(dir)?;
    if completed && !common.quiet {
        closing_words(dir, summary);
    }
    Ok(())
}

/// What `main` returns; a failure is told to the user.
pub fn exit_code(done: Result<(), Failure>) -> ExitCode {
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            report_failure(&failure);
            ExitCode::FAILURE
        }
    }
}
