//! Counts the instructions of every sweep and of whole steps, and says what each physics costs.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program that prints")]

mod check;
mod memory;
mod prices;

use clap::{Parser, Subcommand};
use fearless_simd::Level;
use mps_benches::counting::{Entry, entries, per_step};
use std::error::Error;
use std::process::ExitCode;

type Failure = Box<dyn Error>;

/// Instructions of every sweep and of whole steps, counted by valgrind, and what each physics costs.
#[derive(Parser)]
#[command(version)]
struct Options {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// The names of what is counted
    List,
    /// The vector instructions the sweeps choose here
    Level,
    /// Does one of them so many times: for valgrind, or any other profiler
    Run {
        /// Its name
        name: String,
        /// How many steps
        steps: usize,
    },
    /// Its instructions a particle and step, and in which files they are spent
    Show {
        /// Its name
        name: String,
    },
    /// Counts everything and fails if something differs by more than 2 % from benches/counts.csv
    Check,
    /// Counts everything and writes benches/counts.csv, the column of this profile
    Store,
    /// Measures the time of everything and writes the tables of docs/performance.md
    Prices,
}

fn main() -> ExitCode {
    match obey(Options::parse().task) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("error: {failure}");
            ExitCode::FAILURE
        }
    }
}

fn obey(task: Task) -> Result<(), Failure> {
    match task {
        Task::List => entries().iter().for_each(|entry| println!("{}", entry.name)),
        Task::Level => println!("{}", level()),
        Task::Run { name, steps } => run(&name, steps)?,
        Task::Show { name } => show(&name)?,
        Task::Check => check::check()?,
        Task::Store => check::store()?,
        Task::Prices => prices::write()?,
    }
    Ok(())
}

/// The vector instructions the sweeps choose on this processor.
fn level() -> &'static str {
    #[cfg(target_arch = "x86_64")]
    match Level::new() {
        Level::Avx512(_) => return "AVX-512",
        Level::Avx2(_) => return "AVX2",
        _ => {}
    }
    std::env::consts::ARCH
}

fn entry(name: &str) -> Result<Entry, Failure> {
    let found = entries().into_iter().find(|entry| entry.name == name);
    found.ok_or_else(|| format!("nothing is called '{name}'; `count list` says what is").into())
}

fn run(name: &str, steps: usize) -> Result<(), Failure> {
    let mut subject = (entry(name)?.make)();
    for _ in 0..steps {
        (subject.step)();
    }
    Ok(())
}

fn show(name: &str) -> Result<(), Failure> {
    let particles = (entry(name)?.make)().particles as f64;
    let count = per_step(&std::env::current_exe()?, name)?;
    println!("{:10.2} instructions a particle and step", count.total / particles);
    println!("{:10.2} of them in sweeps, and of all in", count.sweeps / particles);
    let mut files: Vec<_> = count.by_file.iter().filter(|(_, n)| **n > 0.0).collect();
    files.sort_by(|a, b| b.1.total_cmp(a.1));
    for (file, n) in files {
        println!("{:10.2} {file}", n / particles);
    }
    Ok(())
}
