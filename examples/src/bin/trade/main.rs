//! The trade of speed for accuracy: runs a program with many settings, and says which of them are worth their cost.

mod front;
mod judge;
mod machine;
mod picture;
mod recommend;
mod run;
mod sweep;
mod table;

use clap::Parser;
use judge::{Row, judge};
use mps_examples::{Failure, exit_code};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use sweep::Sweep;

/// Runs a program with the settings of a sweep file, one after the other, and compares error and cost.
///
/// Writes trade.csv, trade.json, trade.md and trade.png after every run, and keeps each run in a directory of its own. Started again,
/// it goes on with what is missing. docs/trade.md tells what a sweep file says, and examples/trades has some.
#[derive(Parser, Clone, Debug)]
#[command(version, rename_all = "kebab-case")]
struct Options {
    /// The sweep file
    sweep: PathBuf,
    /// Directory for the results; out/trade/NAME of the sweep file if left out
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print the command of every run instead of running it
    #[arg(long)]
    list: bool,
    /// Run nothing: write the tables again of what is there
    #[arg(long)]
    tables: bool,
    /// Do not say how far it is
    #[arg(long)]
    quiet: bool,
}

fn main() -> ExitCode {
    exit_code(trade(&Options::parse()))
}

fn trade(options: &Options) -> Result<(), Failure> {
    let sweep = Sweep::read(&options.sweep)?;
    let settings = sweep.settings()?;
    if options.list {
        say(&settings
            .iter()
            .map(|s| format!("{} {}\n", sweep.program, s.arguments.join(" ")))
            .collect::<String>());
        return Ok(());
    }
    let dir = options.out.clone().unwrap_or_else(|| default_directory(&options.sweep));
    mps_io::prepare_output(&dir)?;
    let program = run::program(&sweep.program)?;
    let mut rows: Vec<Row> = Vec::new();
    for (k, setting) in settings.iter().enumerate() {
        let below = dir.join("runs").join(setting.directory());
        let known = run::finished(&sweep.program, &below, setting);
        if known.is_none() && options.tables {
            continue;
        }
        let is_new = known.is_none();
        let record = match known {
            Some(record) => record,
            None => {
                if !options.quiet {
                    tell(&format!("{} of {}: {}", k + 1, settings.len(), setting.label));
                }
                run::run(&sweep.program, &program, &below, setting)?
            }
        };
        rows.push(judge(&sweep, setting, &record, &below));
        if is_new {
            write(&sweep, &dir, &rows, &options.sweep)?;
        }
    }
    write(&sweep, &dir, &rows, &options.sweep)?;
    if !options.quiet {
        say(&format!("{}results in {}\n", table::recommendations(&sweep, &rows), dir.display()));
    }
    Ok(())
}

/// Everything that follows from the runs so far.
fn write(sweep: &Sweep, dir: &Path, rows: &[Row], file: &Path) -> Result<(), Failure> {
    let command = format!("cargo run --release -p mps-examples --bin trade -- {}", file.display());
    table::write(sweep, dir, rows, &command)?;
    picture::write(sweep, dir, rows)
}

fn default_directory(sweep: &Path) -> PathBuf {
    Path::new("out/trade").join(sweep.file_stem().unwrap_or_default())
}

#[allow(clippy::print_stdout, reason = "a program talks to its user")]
fn say(text: &str) {
    print!("{text}");
}

#[allow(clippy::print_stderr, reason = "a program talks to its user")]
fn tell(text: &str) {
    eprintln!("{text}");
}
