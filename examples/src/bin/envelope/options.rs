//! The command line.

use clap::Parser;
use mps_examples::Refused;
use std::path::PathBuf;

/// The borders of stability and of accuracy: where each is, how the method breaks there, and what to do.
///
/// Writes envelope.json, envelope.csv and envelope.md. Fails if a border is not where the program says.
#[derive(Parser, Clone, Debug)]
#[command(version, rename_all = "kebab-case")]
pub(crate) struct Options {
    /// Only run the two sides of each border that are written down, instead of searching between them
    #[arg(long)]
    pub(crate) quick: bool,
    /// Only this border; may be given several times
    #[arg(long, value_name = "NAME")]
    pub(crate) only: Vec<String>,
    /// Run the scene of the border given by --only at this value and say what is measured; nothing is written
    #[arg(long, value_name = "VALUE")]
    pub(crate) at: Vec<f64>,
    /// Directory for the results; created if missing
    #[arg(long, value_name = "DIR", default_value = "out/envelope")]
    pub(crate) out: PathBuf,
    /// No words while running
    #[arg(long)]
    pub(crate) quiet: bool,
}

impl Options {
    /// Refuses names of no border.
    ///
    /// # Errors
    /// Names those that are known.
    pub(crate) fn check(&self, names: &[&str]) -> Result<(), Refused> {
        for name in &self.only {
            let known = format!("give one of {}", names.join(", "));
            Refused::unless(names.contains(&name.as_str()), "--only", name, known)?;
        }
        let one = self.at.is_empty() || self.only.len() == 1;
        Refused::unless(one, "--at", self.at.len(), "give the one border it is a value of with --only")
    }

    pub(crate) fn wants(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|only| only == name)
    }
}
