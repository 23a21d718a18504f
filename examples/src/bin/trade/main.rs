//! The trade of speed for accuracy: runs a program with many settings, and says which of them are worth their cost.

mod front;
mod judge;
mod machine;
mod origin;
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
use sweep::{Setting, Sweep};

/// Runs a program with the settings of a sweep file, one after the other, and compares error and cost.
///
/// Writes trade.csv, trade.json, trade.md and trade.png after every run, and keeps each run in a directory of its own. Started again,
/// it goes on with what is missing, and with --retry-failed makes again what failed. docs/trade.md tells what a sweep file says, and examples/trades has some.
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
    /// Make the runs again that failed
    #[arg(long, conflicts_with_all = ["list", "tables"])]
    retry_failed: bool,
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
    let below = |setting: &Setting| dir.join("runs").join(setting.directory());
    // All that is known, before the first new run: an interruption must not leave tables without runs that are there.
    let known = settings.iter().map(|setting| {
        let record = run::finished(&sweep.program, &below(setting), setting)?;
        Some(judge(&sweep, setting, &record, &below(setting)))
    });
    let again = |row: &Row| options.retry_failed && row.failure.is_some();
    let mut rows: Vec<Option<Row>> = known.collect();
    let update = |rows: &[Option<Row>]| -> Result<Vec<Row>, Failure> {
        let there: Vec<Row> = rows.iter().flatten().cloned().collect();
        write(&sweep, &dir, &there, &options.sweep)?;
        Ok(there)
    };
    if rows.iter().any(Option::is_some) {
        update(&rows)?;
    }
    for (k, setting) in settings.iter().enumerate().filter(|_| !options.tables) {
        if rows[k].as_ref().is_some_and(|row| !again(row)) {
            continue;
        }
        if !options.quiet {
            tell(&format!("{} of {}: {}", k + 1, settings.len(), setting.label));
        }
        let record = run::run(&sweep.program, &program, &below(setting), setting)?;
        rows[k] = Some(judge(&sweep, setting, &record, &below(setting)));
        update(&rows)?;
    }
    let rows = update(&rows)?;
    if !options.quiet {
        say(&format!("{}results in {}\n", table::recommendations(&sweep, &rows), dir.display()));
    }
    match rows.iter().find_map(|row| row.failure.as_deref()) {
        Some(first) if rows.iter().all(|row| row.failure.is_some()) => {
            Err(format!("no run has a result; the first failed: {first}").into())
        }
        _ => Ok(()),
    }
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
