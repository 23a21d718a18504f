//! The command line of the program, and the settings it stands for.

use crate::geometry::HEIGHT;
use crate::reference::Test;
use crate::setup::Settings;
use clap::Parser;
use mps_examples::solid::flag::{END, THICKNESS};
use mps_examples::{Common, Preset, PresetFlag, Refused};

/// Flow about a cylinder with a flag in a channel (Turek and Hron 2006; case 3 of the paper).
///
/// The inflow comes up to speed within two seconds. Writes probes.csv, plots of drag, lift and the end of the flag, summary.json,
/// and unless told otherwise fields for ParaView, snapshots and a film.
#[derive(Parser, Clone, Debug)]
#[command(version, rename_all = "kebab-case", allow_negative_numbers = true)]
pub(crate) struct Options {
    /// Which test
    #[arg(long, value_enum, default_value_t = Test::Cfd1)]
    pub(crate) test: Test,
    /// Spacing of the fluid particles (m): an even part of the flag's thickness of 0.02 m
    #[arg(long, value_name = "M", default_value_t = 0.005)]
    pub(crate) spacing: f64,
    /// Simulated time (s); until the flow is what is compared if left out
    #[arg(long, value_name = "S")]
    pub(crate) end_time: Option<f64>,
    /// Structure particles across the flag; as fine as the fluid if left out
    #[arg(long, value_name = "N")]
    pub(crate) across: Option<usize>,
    /// Length of the channel (m)
    #[arg(long, value_name = "M", default_value_t = 2.5)]
    pub(crate) length: f64,
    /// Numerical sound speed over twice the mean inflow, which is the largest speed beside the cylinder
    #[arg(long, value_name = "RATIO", default_value_t = 10.0)]
    pub(crate) sound_ratio: f64,
    /// Courant number of the fluid
    #[arg(long, value_name = "C", default_value_t = 1.0)]
    pub(crate) cfl: f64,
    /// Effective radius over spacing, at least 3
    #[arg(long, value_name = "RATIO", default_value_t = 3.0)]
    pub(crate) radius: f64,
    /// Level of the pressure over that of the mean inflow: keeps the fluid together where vortices would tear it
    #[arg(long, value_name = "RATIO", default_value_t = 2.0)]
    pub(crate) level: f64,
    /// Strength of the density diffusion; 0 switches it off
    #[arg(long, value_name = "DELTA", default_value_t = 0.5)]
    pub(crate) diffusion: f64,
    /// Parts of the particle shifting (icPS) in a step; 0 for no shifting
    #[arg(long, value_name = "K", default_value_t = 1)]
    pub(crate) shifting: u32,
    /// How fast densities follow the packing, as a share in the time in which sound passes a spacing
    #[arg(long, value_name = "SHARE", default_value_t = 0.01)]
    pub(crate) relaxation: f64,
    /// Print the scene file that is this run instead of running it: for runs that have to outlast interruptions. `mps run` of that file writes
    /// checkpoints, from which `mps resume` goes on with the same bits
    #[arg(long)]
    pub(crate) print_scene: bool,
    #[command(flatten)]
    _preset: PresetFlag,
    #[command(flatten)]
    pub(crate) common: Common,
}

/// What the presets stand for; their errors are in `docs/trade.md`; those of the cheap one in slow flow are held by `examples/tests/presets.rs`.
pub(crate) fn preset(preset: Preset) -> mps_examples::Settings {
    match preset {
        Preset::Fast => &[("spacing", "5e-3"), ("length", "1.5"), ("sound-ratio", "5"), ("precision", "f32")],
        Preset::Balanced => &[("spacing", "5e-3"), ("length", "1.5")],
        Preset::Accurate => &[("spacing", "2.5e-3"), ("length", "1.5")],
    }
}

impl Options {
    /// Refuses what cannot be run, before anything is built.
    pub(crate) fn settings(&self) -> Result<Settings, Refused> {
        let positive = |x: f64| x.is_finite() && x > 0.0;
        let l0 = self.spacing;
        Refused::unless(
            positive(l0),
            "--spacing",
            l0,
            "give the distance between particles in metres, e.g. 0.005",
        )?;
        let whole = |length: f64| (length / l0 - (length / l0).round()).abs() < 1e-6;
        Refused::unless(
            whole(HEIGHT) && whole(0.5 * THICKNESS),
            "--spacing",
            l0,
            "half the thickness of the flag (0.01 m) and the height of the channel (0.41 m) have to be whole numbers of it: 0.01, 0.005, 0.0025, ...",
        )?;
        Refused::unless(
            l0 >= 2e-4,
            "--spacing",
            l0,
            "some 26 million particles would be needed; give at least 2e-4 m",
        )?;
        let end_time = self.end_time.unwrap_or_else(|| self.test.settled());
        Refused::unless(
            positive(end_time) && end_time <= 1000.0,
            "--end-time",
            end_time,
            "give the simulated time in seconds, at most 1000",
        )?;
        Refused::unless(
            self.length.is_finite()
                && self.length >= END[0] + 0.4
                && self.length <= 100.0
                && whole(self.length),
            "--length",
            self.length,
            "the wake needs room: give at least 1 m and a whole number of particle spacings, e.g. 2.5",
        )?;
        Refused::unless(
            positive(self.cfl) && self.cfl <= 2.0,
            "--cfl",
            self.cfl,
            "give a Courant number between 0 and 2, e.g. 0.5",
        )?;
        Refused::unless(
            self.sound_ratio.is_finite() && self.sound_ratio >= 1.0,
            "--sound-ratio",
            self.sound_ratio,
            "the numerical sound must be faster than the water; usual is 10",
        )?;
        Refused::unless(
            (3.0..=6.0).contains(&self.radius),
            "--radius",
            self.radius,
            "give a radius of 3 to 6 spacings, e.g. 4",
        )?;
        Refused::unless(
            (0.0..=50.0).contains(&self.level),
            "--level",
            self.level,
            "give a level of 0 to 50, e.g. 2; with too little of it the fluid tears behind the cylinder",
        )?;
        Refused::unless(
            (0.0..=2.0).contains(&self.diffusion),
            "--diffusion",
            self.diffusion,
            "give a strength between 0 and 2, usual is 0.5",
        )?;
        Refused::unless_few_shifts(self.shifting)?;
        Refused::unless(
            (0.0..=0.03).contains(&self.relaxation),
            "--relaxation",
            self.relaxation,
            "give a share of 0 to 0.03, usual is 0.01; more feeds noise",
        )?;
        let across = self.across.unwrap_or((THICKNESS / l0).round() as usize);
        Refused::unless(
            (2..=200).contains(&across),
            "--across",
            across,
            "give 2 to 200 particles across the flag",
        )?;
        self.common.check()?;
        Ok(Settings {
            test: self.test,
            spacing: l0,
            across,
            end_time,
            length: self.length,
            sound_ratio: self.sound_ratio,
            cfl: self.cfl,
            radius: self.radius,
            level: self.level,
            diffusion: self.diffusion,
            shifting: self.shifting,
            relaxation: self.relaxation,
        })
    }
}
