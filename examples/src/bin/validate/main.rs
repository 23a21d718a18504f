//! Small exact problems over three resolutions, with their errors and observed orders as a table.

mod coupling;
mod options;
mod solid;
mod table;

use clap::Parser;
use mps_examples::exact::{self, Case, Outcome, draw};
use mps_examples::{Failure, exit_code};
use options::{Options, Part, Run};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;
use table::Table;

fn main() -> ExitCode {
    exit_code(run(&Options::parse().part))
}

#[allow(clippy::print_stderr, reason = "a program talks to its user")]
fn say(quiet: bool, words: std::fmt::Arguments) {
    if !quiet {
        eprintln!("{words}");
    }
}

fn run(part: &Part) -> Result<(), Failure> {
    let options = part.run();
    let cases = match part {
        Part::Fluid(_) => exact::cases(),
        Part::Solid(_) => solid::cases(),
        Part::Coupling(_) => coupling::cases(),
    };
    options.check(&cases)?;
    let out = part.out();
    mps_io::prepare_output(&out)?;
    let mut table = Table::new(part.name(), options.quick);
    for case in cases.iter().filter(|case| options.takes(case.name())) {
        if options.resolutions(case.as_ref()).is_empty() {
            say(options.quiet, format_args!("{}: all resolutions are finer than --finest", case.name()));
            continue;
        }
        run_case(case.as_ref(), options, &out, &mut table)?;
        // A run that is stopped keeps what it has measured.
        table.write(&out)?;
    }
    say(options.quiet, format_args!("results in {}", out.display()));
    let broken = table.broken();
    if broken.is_empty() {
        return Ok(());
    }
    Err(format!(
        "runs broke off, for reasons that {} has: {}",
        out.join("validation.md").display(),
        broken.join(", ")
    )
    .into())
}

fn run_case(case: &dyn Case, options: &Run, out: &Path, table: &mut Table) -> Result<(), Failure> {
    let (parallel, pace) = (options.parallel()?, options.pace());
    let clock = Instant::now();
    let mut runs = Vec::new();
    for resolution in options.resolutions(case) {
        let clock = Instant::now();
        // Inside the pool the loops of a step need no hand-over between threads.
        let outcome = parallel.install(|| case.run(resolution, pace, &parallel));
        let seconds = clock.elapsed().as_secs_f64();
        say(options.quiet, format_args!("{} at {resolution}: {seconds:.1} s", case.name()));
        for measure in outcome.iter().flat_map(|outcome| &outcome.measures) {
            let (value, error) = (measure.value, measure.error());
            say(options.quiet, format_args!("    {:40} {value:13.5e}  error {error:.3e}", measure.metric));
        }
        if let Err(failure) = &outcome {
            say(options.quiet, format_args!("    {failure}"));
        }
        runs.push((resolution, outcome));
    }
    let outcomes: Vec<&Outcome> = runs.iter().filter_map(|(_, run)| run.as_ref().ok()).collect();
    draw(case, &outcomes, out)?;
    table.add(case, &runs, clock.elapsed().as_secs_f64());
    Ok(())
}
