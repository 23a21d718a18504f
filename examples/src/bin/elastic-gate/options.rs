//! The command line of the program, and the settings it stands for.

use crate::reference::{EXPERIMENT_MAXIMUM, KHAYYER_2018, Maximum, NG_2020, SPHINXSYS};
use crate::setup::{GATE_THICKNESS, RESERVOIR_WIDTH, Rubber, Settings};
use clap::{Parser, ValueEnum};
use mps_examples::{Common, Preset, PresetFlag, Refused, Weight};
use mps_fluid::PressureForm;
use std::path::PathBuf;

/// Particles across the gate with which a cantilever swings within 0.3 % of its period; with 4 it is 1.1 % fast, and a gate in fine water opens 2 to 3 % less.
const ENOUGH_ACROSS: usize = 8;

/// Dam break through an elastic gate (Antoci, Gallati, Sibilla 2007; case 4 of the paper).
///
/// Water 0.1 m wide and 0.14 m deep is held by a rubber gate that hangs from the wall and is free
/// below. Writes probes.csv, gate.png, summary.json, and unless told otherwise fields for ParaView,
/// snapshots and a film.
#[derive(Parser, Clone, Debug)]
#[command(version, rename_all = "kebab-case", allow_negative_numbers = true)]
pub(crate) struct Options {
    /// Spacing of the fluid particles (m)
    #[arg(long, value_name = "M", default_value_t = 1.25e-3)]
    pub(crate) spacing: f64,
    /// Weight of the particle sums
    #[arg(long, value_enum, default_value_t = Weight::Smooth)]
    pub(crate) weight: Weight,
    /// Effective radius over the spacing
    #[arg(long, value_name = "RATIO", default_value_t = 3.0)]
    radius: f64,
    /// Simulated time (s)
    #[arg(long, value_name = "S", default_value_t = 0.4)]
    pub(crate) end_time: f64,
    /// The rubber: density 1100 kg/m3 with Young's modulus (MPa) and Poisson's ratio, or the paper's set
    #[arg(long, value_enum, default_value_t = Material::E78Nu47)]
    pub(crate) material: Material,
    /// Structure particles across the gate; as fine as the fluid if left out, and at least 8
    #[arg(long, value_name = "N")]
    pub(crate) across: Option<usize>,
    /// Least number of sub-steps of the gate in a step of the water; what stability asks for if that is more
    #[arg(long, value_name = "N", default_value_t = 1)]
    min_substeps: usize,
    /// Numerical sound speed over the speed of free fall from the surface
    #[arg(long, value_name = "RATIO", default_value_t = 10.0)]
    pub(crate) sound_ratio: f64,
    /// Courant number of the fluid
    #[arg(long, value_name = "C", default_value_t = 0.5)]
    pub(crate) cfl: f64,
    /// Strength of the density diffusion; 0 switches it off
    #[arg(long, value_name = "DELTA", default_value_t = 0.5)]
    diffusion: f64,
    /// No collisions between close particles
    #[arg(long)]
    no_dpc: bool,
    /// Strength of the artificial viscosity
    #[arg(long, value_name = "ALPHA", default_value_t = 0.02)]
    pub(crate) alpha: f64,
    /// Parts of the particle shifting (icPS) in a step, 5 in the paper; 0 for no shifting
    #[arg(long, value_name = "K", default_value_t = 0)]
    pub(crate) shifting: u32,
    /// Correct pressure gradient and divergence by the moment matrix of each particle: for smooth flows; violent
    /// ones tear with it so far
    #[arg(long)]
    pub(crate) corrected: bool,
    /// Directory of an earlier run, to draw its curve beside this one; may be repeated
    #[arg(long, value_name = "DIR")]
    pub(crate) beside: Vec<PathBuf>,
    /// Print the scene file that is this run instead of running it: for runs that have to outlast interruptions. `mps run` of that file writes
    /// checkpoints, from which `mps resume` goes on with the same bits
    #[arg(long)]
    pub(crate) print_scene: bool,
    #[command(flatten)]
    _preset: PresetFlag,
    #[command(flatten)]
    pub(crate) common: Common,
}

/// The rubber, as different authors set it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Material {
    /// 600 kg/m3, 12 MPa, 0.4: as printed in the paper
    Paper1,
    /// 1100 kg/m3, 12 MPa, 0.4
    #[value(name = "e12-nu40")]
    E12Nu40,
    /// 1100 kg/m3, 7.8 MPa, 0.4
    #[value(name = "e7.8-nu40")]
    E78Nu40,
    /// 1100 kg/m3, 7.8 MPa, 0.47
    #[value(name = "e7.8-nu47")]
    E78Nu47,
}

impl Material {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Paper1 => "paper1",
            Self::E12Nu40 => "e12-nu40",
            Self::E78Nu40 => "e7.8-nu40",
            Self::E78Nu47 => "e7.8-nu47",
        }
    }

    pub(crate) fn rubber(self) -> Rubber {
        let (density, youngs_modulus, poissons_ratio) = match self {
            Self::Paper1 => (600.0, 12.0e6, 0.4),
            Self::E12Nu40 => (1100.0, 12.0e6, 0.4),
            Self::E78Nu40 => (1100.0, 7.8e6, 0.4),
            Self::E78Nu47 => (1100.0, 7.8e6, 0.47),
        };
        Rubber { density, youngs_modulus, poissons_ratio }
    }

    /// The published run with the same rubber; for the paper's set, the experiment.
    pub(crate) fn published(self) -> Maximum {
        match self {
            Self::Paper1 => EXPERIMENT_MAXIMUM,
            Self::E12Nu40 => NG_2020,
            Self::E78Nu40 => KHAYYER_2018,
            Self::E78Nu47 => SPHINXSYS,
        }
    }
}

/// What the presets stand for; their errors are in `docs/trade.md`; those of the cheap ones are held by `examples/tests/presets.rs`.
pub(crate) fn preset(preset: Preset) -> mps_examples::Settings {
    match preset {
        Preset::Fast => &[
            ("spacing", "2.5e-3"),
            ("across", "4"),
            ("weight", "rational"),
            ("radius", "2.5"),
            ("cfl", "0.8"),
            ("sound-ratio", "5"),
            ("precision", "f32"),
        ],
        Preset::Balanced => &[("spacing", "2.5e-3"), ("across", "5")],
        Preset::Accurate => &[("spacing", "1.25e-3")],
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
            "give the distance between particles in metres, e.g. 1.25e-3",
        )?;
        let thickness = GATE_THICKNESS / l0;
        let thick_enough = format!(
            "the gate would be {thickness:.2} particles thick and needs at least 2; give at most {:e} m",
            GATE_THICKNESS / 2.0
        );
        Refused::unless(thickness >= 2.0 - 1e-9, "--spacing", l0, thick_enough)?;
        Refused::unless(
            l0 >= 5e-5,
            "--spacing",
            l0,
            "more than five million particles would be needed; give at least 5e-5 m",
        )?;
        // Otherwise the water begins inside the gate, or away from it. Its surface may lie where it comes to lie.
        Refused::unless_whole(RESERVOIR_WIDTH, l0, "the width of the reservoir")?;
        Refused::unless(
            positive(self.end_time),
            "--end-time",
            self.end_time,
            "give the simulated time in seconds, e.g. 0.4",
        )?;
        Refused::unless(
            self.end_time <= 10.0,
            "--end-time",
            self.end_time,
            "the reservoir is empty long before; give at most 10 s",
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
            self.alpha.is_finite() && self.alpha >= 0.0,
            "--alpha",
            self.alpha,
            "give a strength of 0 or more, e.g. 0.02",
        )?;
        Refused::unless_few_shifts(self.shifting)?;
        let usual = "give an effective radius between 2 and 6 spacings, e.g. 3";
        Refused::unless((2.0..=6.0).contains(&self.radius), "--radius", self.radius, usual)?;
        let usual = "give a strength between 0 and 2, e.g. 0.5";
        Refused::unless((0.0..=2.0).contains(&self.diffusion), "--diffusion", self.diffusion, usual)?;
        let usual = "give at least 1 and at most 1000";
        Refused::unless((1..=1000).contains(&self.min_substeps), "--min-substeps", self.min_substeps, usual)?;
        let across = self.across.unwrap_or_else(|| (thickness.round() as usize).max(ENOUGH_ACROSS));
        Refused::unless(across >= 2, "--across", across, "the gate needs at least 2 particles across")?;
        Refused::unless(
            across <= 200,
            "--across",
            across,
            "the gate alone would need more than half a million particles; give at most 200",
        )?;
        self.common.check()?;
        Ok(Settings {
            spacing: l0,
            across,
            rubber: self.material.rubber(),
            end_time: self.end_time,
            radius: self.radius,
            min_substeps: self.min_substeps,
            diffusion: self.diffusion,
            collisions: !self.no_dpc,
            sound_ratio: self.sound_ratio,
            cfl: self.cfl,
            alpha: self.alpha,
            shifting: self.shifting,
            pressure_form: if self.corrected { PressureForm::Corrected } else { PressureForm::Plain },
        })
    }
}
