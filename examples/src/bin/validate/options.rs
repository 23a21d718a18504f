//! The command line: what is validated, how thoroughly, and where the results go.

use clap::{Args, Parser, Subcommand};
use mps_examples::exact::{Case, Pace};
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
    /// Directory for the results, out/validate/PART if left out; created if missing
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
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

    /// Where the results go.
    pub(crate) fn out(&self) -> PathBuf {
        self.run().out.clone().unwrap_or_else(|| PathBuf::from("out/validate").join(self.name()))
    }
}

impl Run {
    /// Refuses names of no case, and a finest resolution that leaves nothing to run.
    pub(crate) fn check(&self, cases: &[Box<dyn Case>]) -> Result<(), Refused> {
        let names: Vec<&str> = cases.iter().map(|case| case.name()).collect();
        for name in &self.only {
            let known = format!("give one of {}", names.join(", "));
            Refused::unless(names.contains(&name.as_str()), "--only", name, known)?;
        }
        let chosen = cases.iter().filter(|case| self.takes(case.name()));
        let coarsest = chosen.flat_map(|case| case.resolutions(self.pace())).min().unwrap_or_default();
        let finest = self.finest.unwrap_or(usize::MAX);
        let remedy = format!("the coarsest run of these cases has {coarsest}: give at least that");
        Refused::unless(finest >= coarsest, "--finest", finest, remedy)
    }

    /// Whether a case of this name is run.
    pub(crate) fn takes(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|only| only == name)
    }

    /// The resolutions of a case that are run.
    pub(crate) fn resolutions(&self, case: &dyn Case) -> Vec<usize> {
        let finest = self.finest.unwrap_or(usize::MAX);
        case.resolutions(self.pace()).into_iter().filter(|n| *n <= finest).collect()
    }

    pub(crate) fn pace(&self) -> Pace {
        if self.quick { Pace::Quick } else { Pace::Full }
    }

    pub(crate) fn parallel(&self) -> Result<Parallel, Failure> {
        Ok(Parallel::new(self.threads)?)
    }
}
