//! The envelope of the method: every number is turned until something breaks. Where, how, and what to do.

mod bending;
mod border;
mod contact;
mod coupling;
mod drift;
mod fluid_step;
mod map;
mod motion;
mod openings;
mod options;
mod precision;
mod search;
mod solid_material;
mod solid_step;
mod strays;
mod table;
mod tank;
mod viscous_step;
mod water;
mod waves;

use border::Border;
use clap::Parser;
use mps_examples::{Failure, exit_code};
use options::Options;
use std::process::ExitCode;
use std::time::Instant;
use table::Table;

fn main() -> ExitCode {
    exit_code(run(&Options::parse()))
}

#[allow(clippy::print_stderr, reason = "a program talks to its user")]
fn say(quiet: bool, words: std::fmt::Arguments) {
    if !quiet {
        eprintln!("{words}");
    }
}

/// All borders, by family.
fn borders() -> Vec<Border> {
    [
        fluid_step::borders(),
        viscous_step::borders(),
        solid_step::borders(),
        solid_material::borders(),
        contact::borders(),
        coupling::borders(),
        drift::borders(),
        water::borders(),
        motion::borders(),
        openings::borders(),
        strays::borders(),
        precision::borders(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn run(options: &Options) -> Result<(), Failure> {
    let borders = borders();
    let names: Vec<_> = borders.iter().map(|border| border.name).collect();
    if let Some(name) = map::without_scene(&names) {
        return Err(format!("map.rs has the border {name}, and there is no scene of it").into());
    }
    options.check(&names)?;
    let wanted = borders.iter().filter(|border| options.wants(border.name));
    if !options.at.is_empty() {
        for (border, value) in wanted.flat_map(|border| options.at.iter().map(move |value| (border, value))) {
            let clock = Instant::now();
            let words = border.words(&border.run(*value));
            say(
                false,
                format_args!("{} at {value}: {words} ({:.2} s)", border.name, clock.elapsed().as_secs_f64()),
            );
        }
        return Ok(());
    }
    mps_io::prepare_output(&options.out)?;
    let mut table = Table::new(options.quick);
    for border in wanted {
        let clock = Instant::now();
        let known = map::known(border.name).ok_or_else(|| format!("map.rs has no border {}", border.name))?;
        let found = if options.quick { search::check(border, known) } else { search::locate(border, known) };
        for trial in found.fine.iter().chain(&found.broken) {
            say(
                options.quiet,
                format_args!("{} at {:.4e}: {}", border.name, trial.value, border.words(trial)),
            );
        }
        say(options.quiet, format_args!("    {:.1} s", clock.elapsed().as_secs_f64()));
        table.add(border, found)?;
        // A run that is stopped keeps what it has measured.
        table.write(&options.out)?;
    }
    say(options.quiet, format_args!("results in {}", options.out.display()));
    match table.moved() {
        [] => Ok(()),
        moved => Err(format!(
            "not where the program says: {}; run them with --at to see where they are now, and enter it in map.rs once the reason is known",
            moved.join(", ")
        )
        .into()),
    }
}
