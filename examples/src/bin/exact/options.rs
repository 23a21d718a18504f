//! The command line: which problem, how finely, with which numerics.

use clap::Parser;
use mps_examples::exact::{Case, Numerics};
use mps_examples::{Common, Refused};

/// One exact problem with numerics of one's own.
///
/// Writes summary.json with the errors against the exact solution, and curves over the exact ones as PNG. What each problem is,
/// docs/validation.md tells; what settings cost and bring, docs/trade.md.
#[derive(Parser, Clone, Debug)]
#[command(version, rename_all = "kebab-case")]
pub(crate) struct Options {
    /// The problem: poiseuille, drop, taylor-green, standing-wave or hydrostatic
    #[arg(long, value_name = "NAME")]
    pub(crate) problem: String,
    /// Particles along the length of the problem: its width, radius, side, wavelength or depth
    #[arg(long, value_name = "N")]
    pub(crate) resolution: usize,
    #[command(flatten)]
    pub(crate) numerics: Numerics,
    #[command(flatten)]
    pub(crate) common: Common,
}

impl Options {
    /// Refuses what cannot be run; else the problem that is asked for.
    pub(crate) fn check<'a>(&self, problems: &'a [Box<dyn Case>]) -> Result<&'a dyn Case, Refused> {
        let (n, remedy) = (self.resolution, "give between 8 and 1000 particles, e.g. 20");
        Refused::unless((8..=1000).contains(&n), "--resolution", n, remedy)?;
        self.numerics.check()?;
        self.common.check()?;
        let named = problems.iter().find(|problem| problem.name() == self.problem);
        let names: Vec<&str> = problems.iter().map(|problem| problem.name()).collect();
        let problem = named.map(AsRef::as_ref).ok_or_else(|| Refused {
            flag: "--problem",
            value: self.problem.clone(),
            remedy: format!("give one of {}", names.join(", ")),
        })?;
        problem.check(n)?;
        Ok(problem)
    }
}
