//! One exact problem with numerics of one's own: its errors and its cost. The sweeps of `trade` are made of such runs.

mod options;

use clap::Parser;
use mps_examples::exact::{Case, Choice, Outcome, Pace, draw, tunable};
use mps_examples::{Cost, Failure, Watch, conclude, enter_results, exit_code, remove_leftovers};
use mps_io::Summary;
use options::Options;
use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Instant;

fn main() -> ExitCode {
    exit_code(run(&Options::parse()))
}

fn run(options: &Options) -> Result<(), Failure> {
    options.check(&tunable(&Choice::default()))?;
    let dir = options.common.output("exact")?;
    let watch = Arc::new(Watch::begin(&dir, &options.common)?);
    let problems =
        tunable(&Choice { numerics: options.numerics.clone(), precision: options.common.precision, watch });
    let problem = options.check(&problems)?;
    remove_leftovers(&dir, &pictures(&problems))?;
    remove_leftovers(&dir, &["summary.json".to_owned()])?;
    let parallel = options.common.parallel()?;
    let clock = Instant::now();
    // Inside the pool the loops of a step need no hand-over between threads.
    let done = parallel.install(|| problem.run(options.resolution, Pace::Full, &parallel));
    let seconds = clock.elapsed().as_secs_f64();
    let (outcome, failure) = match done {
        Ok(outcome) => (outcome, None),
        Err(failure) => (Outcome::default(), Some(failure)),
    };
    draw(problem, &[&outcome], &dir)?;
    let summary = summary(options, problem, &outcome, parallel.threads(), seconds, failure.as_ref());
    conclude(Path::new(&dir), &summary, &options.common, failure.is_none())?;
    failure.map_or(Ok(()), Err)
}

/// Pictures of all problems: those of another one would be taken for results of the summary beside them.
fn pictures(problems: &[Box<dyn Case>]) -> Vec<String> {
    let mut names = Vec::new();
    for problem in problems {
        names.extend(problem.plots().iter().map(|plot| format!("{}-{}.png", problem.name(), plot.name)));
    }
    names
}

/// Settings, cost and errors.
fn summary(
    options: &Options,
    problem: &dyn Case,
    outcome: &Outcome,
    threads: usize,
    seconds: f64,
    failure: Option<&Failure>,
) -> Summary {
    let mut summary = Summary::new("exact", env!("CARGO_PKG_VERSION"));
    summary.set("problem", problem.name());
    summary.set("about", problem.about());
    summary.set("resolution", options.resolution);
    summary.set("resolution_is", problem.resolution());
    options.numerics.enter(&mut summary);
    let work = outcome.work;
    summary.particles.insert("fluid".to_owned(), work.particles as u64);
    let (steps, simulated, particles) = (work.steps, work.simulated, work.particles);
    Cost { threads, steps, seconds, simulated, particles }.enter(&mut summary, &options.common, failure);
    let results = outcome.measures.iter().map(|measure| (measure.metric.to_owned(), Some(measure.metric())));
    enter_results(&mut summary, results);
    summary
}
