//! Small exact problems over three resolutions, with their errors and observed orders as a table.

mod coupling;
mod options;
mod solid;
mod table;

use clap::Parser;
use mps_examples::exact::{self, Case, Outcome, Pace, draw};
use mps_examples::{Failure, exit_code};
use options::{Options, Part, Run};
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
    options.check(&cases.iter().map(|case| case.name()).collect::<Vec<_>>())?;
    mps_io::prepare_output(&options.out)?;
    let mut table = Table::new(part.name(), options.quick);
    for case in cases {
        if options.only.is_empty() || options.only.iter().any(|name| name == case.name()) {
            run_case(case.as_ref(), options, &mut table)?;
            // A run that is stopped keeps what it has measured.
            table.write(&options.out)?;
        }
    }
    say(options.quiet, format_args!("results in {}", options.out.display()));
    Ok(())
}

fn run_case(case: &dyn Case, options: &Run, table: &mut Table) -> Result<(), Failure> {
    let parallel = options.parallel()?;
    let pace = if options.quick { Pace::Quick } else { Pace::Full };
    let finest = options.finest.unwrap_or(usize::MAX);
    let clock = Instant::now();
    let mut runs = Vec::new();
    for resolution in case.resolutions(pace).into_iter().filter(|n| *n <= finest) {
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
    draw(case, &outcomes, &options.out)?;
    table.add(case, &runs, clock.elapsed().as_secs_f64());
    Ok(())
}
