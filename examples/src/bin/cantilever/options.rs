//! The command line of the program.

use clap::{Parser, ValueEnum};
use mps_examples::solid::plate::{PERIOD, THICKNESS, unit_of_time};
use mps_examples::{Common, Preset, PresetFlag, Refused};
use mps_kernel::Real;
use mps_solid::SolidConfig;

/// Free vibration of a clamped plate (Gray, Monaghan and Swift 2001; case 1 of the paper).
///
/// A plate 0.2 m long and 0.02 m thick gets the velocities of its first mode and is let swing without damping.
/// Writes probes.csv, tip.png, energy.png, energy_error.png, summary.json, and unless told otherwise fields for
/// ParaView, pictures of the stress and a film.
#[derive(Parser, Clone, Debug)]
#[command(version, rename_all = "kebab-case", allow_negative_numbers = true)]
pub(crate) struct Options {
    /// Particles across the plate; 10 if neither this nor --spacing is given
    #[arg(long, value_name = "N", conflicts_with = "spacing")]
    across: Option<usize>,
    /// Spacing of the particles (m), instead of --across; rounded to a whole number across
    #[arg(long, value_name = "M")]
    spacing: Option<f64>,
    /// Law of the material, always with K = 3.25 MPa and G = 0.715 MPa
    #[arg(long, value_enum, default_value_t = Material::Corotational)]
    pub(crate) material: Material,
    /// Effective radius of the neighbourhood over the spacing
    #[arg(long, value_name = "RATIO", default_value_t = SolidConfig::default().radius_ratio)]
    radius: f64,
    /// Step over the stability limit of the plate
    #[arg(long, value_name = "C", default_value_t = SolidConfig::default().cfl)]
    cfl: f64,
    /// Simulated periods of the first mode
    #[arg(long, value_name = "P", default_value_t = 3.2)]
    periods: f64,
    /// Simulated time (s), instead of --periods; a period is 0.255 s
    #[arg(long, value_name = "S", conflicts_with = "periods")]
    end_time: Option<f64>,
    /// Run with 4, 5, 8, 10 and 20 particles across, and write a table with the orders of convergence
    #[arg(long, conflicts_with_all = ["across", "spacing"])]
    pub(crate) convergence: bool,
    /// Print the scene file that is this run instead of running it: for runs that have to outlast interruptions. `mps run` of that file writes
    /// checkpoints, from which `mps resume` goes on with the same bits
    #[arg(long)]
    pub(crate) print_scene: bool,
    #[command(flatten)]
    _preset: PresetFlag,
    #[command(flatten)]
    pub(crate) common: Common,
}

/// The law of the material.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Material {
    /// Hooke's law in the frame that turns with the material: that of the paper
    Corotational,
    /// Saint Venant and Kirchhoff's: that of the finite elements compared with
    SaintVenant,
    /// The compressible neo-Hookean law
    NeoHookean,
}

/// What the presets stand for; their errors are in `docs/trade.md`; those of the cheap ones are held by `examples/tests/presets.rs`.
pub(crate) fn preset(preset: Preset) -> mps_examples::Settings {
    match preset {
        Preset::Fast => &[("across", "3")],
        Preset::Balanced => &[("across", "6")],
        Preset::Accurate => &[("across", "16")],
    }
}

impl Options {
    /// Particles across the plate. Refuses what cannot be run, before anything is built.
    pub(crate) fn check(&self) -> Result<usize, Refused> {
        let across = match self.spacing {
            None => self.across.unwrap_or(10),
            Some(l0) => {
                let usual = "give the distance between particles in metres, e.g. 2e-3";
                Refused::unless(l0.is_finite() && l0 > 0.0, "--spacing", l0, usual)?;
                let needed = "the plate needs 2 to 200 particles across its 0.02 m";
                Refused::unless((1.5..200.5).contains(&(THICKNESS / l0)), "--spacing", l0, needed)?;
                (THICKNESS / l0).round() as usize
            }
        };
        let needed = "the plate needs 2 to 200 particles across, e.g. 10";
        Refused::unless((2..=200).contains(&across), "--across", across, needed)?;
        match self.end_time {
            Some(end) => {
                let usual = "give the simulated time in seconds, at most 1000, e.g. 0.8";
                Refused::unless(end > 0.0 && end <= 1000.0, "--end-time", end, usual)?;
            }
            None => {
                let usual = "give a number of periods, at most 4000, e.g. 3.2";
                Refused::unless(
                    self.periods > 0.0 && self.periods <= 4000.0,
                    "--periods",
                    self.periods,
                    usual,
                )?;
            }
        }
        let usual = "give the effective radius in spacings, from 1.2 to 6, e.g. 1.6";
        Refused::unless((1.2..=6.0).contains(&self.radius), "--radius", self.radius, usual)?;
        let usual = "give a share of the stability limit, more than 0 and at most 1, e.g. 0.8";
        Refused::unless(self.cfl > 0.0 && self.cfl <= 1.0, "--cfl", self.cfl, usual)?;
        self.common.check()?;
        Ok(across)
    }

    /// Numerics of the plate.
    pub(crate) fn config<T: Real>(&self) -> SolidConfig<T> {
        SolidConfig { radius_ratio: T::of(self.radius), cfl: T::of(self.cfl), ..SolidConfig::default() }
    }

    /// Simulated time \[s\].
    pub(crate) fn end_time(&self) -> f64 {
        self.end_time.unwrap_or(self.periods * PERIOD * unit_of_time())
    }
}
