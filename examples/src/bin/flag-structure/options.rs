//! The command line of the program.

use crate::Settings;
use clap::{Parser, ValueEnum};
use mps_examples::solid::flag::{Clamp, THICKNESS};
use mps_examples::{Common, Precision, Refused};

/// Structural tests of Turek and Hron (2006): a flag behind a cylinder under its own weight.
///
/// CSM1 is the flag at rest, CSM3 its motion from the undeformed state, without damping. Writes probes.csv, plots
/// against the reference, summary.json, and unless told otherwise fields for ParaView, pictures of the stress and, of
/// CSM3, a film.
#[derive(Parser, Clone, Debug)]
#[command(version, rename_all = "kebab-case", allow_negative_numbers = true)]
pub(crate) struct Options {
    /// Which test
    #[arg(long, value_enum, default_value_t = Test::Csm3)]
    pub(crate) test: Test,
    /// Particles across the flag; 8 if neither this nor --spacing is given
    #[arg(long, value_name = "N", conflicts_with = "spacing")]
    across: Option<usize>,
    /// Spacing of the particles (m), instead of --across; rounded to a whole number across
    #[arg(long, value_name = "M")]
    spacing: Option<f64>,
    /// Where the flag is held
    #[arg(long, value_enum, default_value_t = Clamp::Arc)]
    clamp: Clamp,
    /// Simulated time of CSM3 (s)
    #[arg(long, value_name = "S", default_value_t = 10.0)]
    end_time: f64,
    /// Forces that may be left in CSM1, over the load
    #[arg(long, value_name = "SHARE", default_value_t = 1e-6)]
    tolerance: f64,
    /// Print the scene file that is this run instead of running it, for `mps run`, which writes checkpoints to go on from
    #[arg(long)]
    pub(crate) print_scene: bool,
    #[command(flatten)]
    pub(crate) common: Common,
}

/// The tests of the structure alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Test {
    /// At rest under gravity
    Csm1,
    /// Let go from the undeformed state
    Csm3,
}

impl Test {
    /// As in the flag and in summaries.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Csm1 => "csm1",
            Self::Csm3 => "csm3",
        }
    }

    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Csm1 => "CSM1",
            Self::Csm3 => "CSM3",
        }
    }
}

impl Options {
    /// Refuses what cannot be run, before anything is built.
    pub(crate) fn settings(&self) -> Result<Settings, Refused> {
        let across = match self.spacing {
            None => self.across.unwrap_or(8),
            Some(l0) => {
                let usual = "give the distance between particles in metres, e.g. 2.5e-3";
                Refused::unless(l0.is_finite() && l0 > 0.0, "--spacing", l0, usual)?;
                let needed = "the flag needs 2 to 100 particles across its 0.02 m";
                Refused::unless((1.5..100.5).contains(&(THICKNESS / l0)), "--spacing", l0, needed)?;
                (THICKNESS / l0).round() as usize
            }
        };
        let needed = "the flag needs 2 to 100 particles across, e.g. 8";
        Refused::unless((2..=100).contains(&across), "--across", across, needed)?;
        let usual = "give the simulated time in seconds, at most 1000, e.g. 10";
        Refused::unless(self.end_time > 0.0 && self.end_time <= 1000.0, "--end-time", self.end_time, usual)?;
        let usual = "give a share of the load between 1e-11 and 0.01, e.g. 1e-6";
        let good = (1e-11..=0.01).contains(&self.tolerance);
        Refused::unless(good, "--tolerance", self.tolerance, usual)?;
        Refused::unless(
            self.test != Test::Csm1 || self.common.precision == Precision::F64,
            "--precision",
            self.common.precision.name(),
            "the forces of a flag at rest are smaller than what f32 rounds off; use f64 for csm1",
        )?;
        self.common.check()?;
        let Self { clamp, end_time, tolerance, .. } = *self;
        Ok(Settings { across, clamp, end_time, tolerance })
    }
}
