//! Counts the instructions of every sweep and of whole steps, and says what each physics costs.
//!
//! ```text
//! count list                  the names of what is counted
//! count run NAME STEPS        does it so many times: for valgrind, or any other profiler
//! count show NAME             its instructions a particle and step, and in which files they are spent
//! count check                 counts everything and fails if something differs by more than 2 % from benches/counts.csv
//! count store                 counts everything and writes benches/counts.csv, the column of this profile
//! count prices                measures the time of everything and writes the tables of docs/performance.md
//! ```

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program that prints")]

mod check;
mod memory;
mod prices;

use fearless_simd::Level;
use mps_benches::counting::{Entry, entries, per_step};
use std::error::Error;
use std::process::ExitCode;

type Failure = Box<dyn Error>;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match obey(&words) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("error: {failure}");
            ExitCode::FAILURE
        }
    }
}

fn obey(words: &[&str]) -> Result<(), Failure> {
    match *words {
        ["list"] => entries().iter().for_each(|entry| println!("{}", entry.name)),
        ["level"] => println!("{}", level()),
        ["run", name, steps] => run(name, steps.parse()?)?,
        ["show", name] => show(name)?,
        ["check"] => check::check()?,
        ["store"] => check::store()?,
        ["prices"] => prices::write()?,
        _ => return Err("expected list, run NAME STEPS, show NAME, check, store or prices".into()),
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
