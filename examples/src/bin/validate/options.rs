//! The command line: what is validated, how thoroughly, and where the results go.

use clap::{Args, Parser, Subcommand};
use mps_examples::{Failure, Refused};
use mps_neighbors::Parallel;
use std::path::PathBuf;

/// Small exact problems over several resolutions: error and observed order of each.
///
/// Writes validation.json, validation.md, and curves against the exact solutions as PNG.
#[derive(Parser, Clone, Debug)]
#[command(version, rename_all = "kebab-case")]
pub(crate) struct Options {
    #[command(subcommand)]
    pub(crate) part: Part,
}

/// What is validated.
#[derive(Subcommand, Clone, Debug)]
pub(crate) enum Part {
    /// The fluid alone: tanks, channels, waves, drops
    Fluid(Run),
    /// The solid alone: rotations, patches, waves, beams
    Solid(Run),
    /// Fluid and structure together: exchange, added mass, static loads
    Coupling(Run),
}

/// How a part is run.
#[derive(Args, Clone, Debug)]
pub(crate) struct Run {
    /// Coarse and short: minutes become seconds, targets are out of reach
    #[arg(long)]
    pub(crate) quick: bool,
    /// Only this case; may be given several times
    #[arg(long, value_name = "CASE")]
    pub(crate) only: Vec<String>,
    /// Leave out resolutions finer than this
    #[arg(long, value_name = "N")]
    pub(crate) finest: Option<usize>,
    /// Threads; the results do not depend on it
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) threads: usize,
    /// Directory for the results; created if missing
    #[arg(long, value_name = "DIR", default_value = "out/validate")]
    pub(crate) out: PathBuf,
    /// No words while running
    #[arg(long)]
    pub(crate) quiet: bool,
}

impl Part {
    /// Name as on the command line.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Fluid(_) => "fluid",
            Self::Solid(_) => "solid",
            Self::Coupling(_) => "coupling",
        }
    }

    pub(crate) fn run(&self) -> &Run {
        match self {
            Self::Fluid(run) | Self::Solid(run) | Self::Coupling(run) => run,
        }
    }
}

impl Run {
    /// Refuses names of no case.
    pub(crate) fn check(&self, names: &[&str]) -> Result<(), Refused> {
        for name in &self.only {
            let known = format!("give one of {}", names.join(", "));
            Refused::unless(names.contains(&name.as_str()), "--only", name, known)?;
        }
        Ok(())
    }

    pub(crate) fn parallel(&self) -> Result<Parallel, Failure> {
        Ok(Parallel::new(self.threads)?)
    }
}
