//! The flags every example has.

use clap::{Args, ValueEnum};
use mps_neighbors::Parallel;
use std::path::PathBuf;
use thiserror::Error;

use crate::{Failure, LogLevel};

/// Flags common to all examples; flatten them into the parser of a program.
#[derive(Args, Clone, Debug)]
pub struct Common {
    /// Threads; all cores if left out
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,
    /// Scalar type of the simulation
    #[arg(long, value_enum, default_value_t = Precision::F64)]
    pub precision: Precision,
    /// Directory for the results; created if missing
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Write neither fields nor pictures nor the film; probes, plots and summary only
    #[arg(long)]
    pub no_fields: bool,
    /// No progress, no closing words
    #[arg(long)]
    pub quiet: bool,
    /// How much goes into run.log beside the results
    #[arg(long, value_enum, value_name = "LEVEL", default_value_t)]
    pub log: LogLevel,
}

/// Scalar type of a simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Precision {
    /// Single precision
    F32,
    /// Double precision
    F64,
}

impl Precision {
    /// As in the flag and in summaries.
    pub fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }
}

/// Input no run can be made of: what it is and what to change.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{flag} is {value}: {remedy}")]
pub struct Refused {
    /// The flag.
    pub flag: &'static str,
    /// Its value.
    pub value: String,
    /// What to do.
    pub remedy: String,
}

impl Refused {
    /// Refuses `flag` unless `good`.
    ///
    /// # Errors
    /// If not `good`.
    pub fn unless(
        good: bool,
        flag: &'static str,
        value: impl ToString,
        remedy: impl Into<String>,
    ) -> Result<(), Self> {
        if good { Ok(()) } else { Err(Self { flag, value: value.to_string(), remedy: remedy.into() }) }
    }

    /// Refuses a `--spacing` \[m\] of which `length` \[m\] is no whole number: `what` would end up to half a particle before or behind where it is
    /// to. A twentieth of a particle is let pass, for numbers that were rounded.
    ///
    /// # Errors
    /// If it is none: the nearest ones that are.
    pub fn unless_whole(length: f64, spacing: f64, what: &str) -> Result<(), Self> {
        let particles = length / spacing;
        let good = (particles - particles.round()).abs() <= 0.05;
        // As short as it can be said, which is near enough.
        let written = |count: f64| {
            (0..9).map(|digits| format!("{:.digits$e}", length / count)).find(|text| {
                text.parse::<f64>().is_ok_and(|spacing| (length / spacing - count).abs() <= 0.01)
            })
        };
        let [finer, coarser] =
            [particles.ceil(), particles.floor()].map(|count| written(count).unwrap_or_default());
        let remedy = format!(
            "{what} of {length} m would be {particles:.2} particles; give a whole number of them, the nearest are {finer} and {coarser}"
        );
        Self::unless(good, "--spacing", spacing, remedy)
    }

    /// Refuses more `--shifting` than anybody wants: each part costs a sweep over all particles.
    ///
    /// # Errors
    /// If it is more than 100 parts.
    pub fn unless_few_shifts(parts: u32) -> Result<(), Self> {
        let remedy = "each part costs a sweep over all particles; give at most 100, usual is 5, none 0";
        Self::unless(parts <= 100, "--shifting", parts, remedy)
    }
}

impl Common {
    /// Refuses numbers of threads that no machine has.
    ///
    /// # Errors
    /// If none or too many were asked for.
    pub fn check(&self) -> Result<(), Refused> {
        let threads = self.threads.unwrap_or(1);
        Refused::unless(
            (1..=1024).contains(&threads),
            "--threads",
            threads,
            "give at least 1 and at most 1024, or leave it out to use all cores",
        )
    }

    /// The threads asked for.
    ///
    /// # Errors
    /// If zero were asked for, or the system refuses.
    pub fn parallel(&self) -> Result<Parallel, Failure> {
        Ok(match self.threads {
            Some(threads) => Parallel::new(threads)?,
            None => Parallel::all_cores()?,
        })
    }

    /// The output directory, `out/<program>` if none was given; exists and is writable afterwards.
    ///
    /// # Errors
    /// If it cannot be created or written to.
    pub fn output(&self, program: &str) -> Result<PathBuf, Failure> {
        let dir = self.out.clone().unwrap_or_else(|| PathBuf::from("out").join(program));
        mps_io::prepare_output(&dir)?;
        Ok(dir)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spacing_has_to_fit_and_the_nearest_that_do_are_named() {
        for fits in [2.5e-3, 1.25e-3, 1e-3, 6.25e-4, 2e-3, 1.667e-3, 5e-5, 0.1 / 1999.0] {
            assert_eq!(Refused::unless_whole(0.1, fits, "the water"), Ok(()), "{fits}");
        }
        for (spacing, near) in [(1.8e-3, ["1.786e-3", "1.818e-3"]), (5.001e-5, ["5e-5", "5.0025e-5"])] {
            let said = Refused::unless_whole(0.1, spacing, "the water").unwrap_err().remedy;
            assert!(said.ends_with(&format!("the nearest are {} and {}", near[0], near[1])), "{said}");
            for near in near {
                assert_eq!(Refused::unless_whole(0.1, near.parse().unwrap(), "the water"), Ok(()), "{near}");
            }
        }
    }
}
