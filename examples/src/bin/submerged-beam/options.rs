//! The command line of the program, and the settings it stands for.

use clap::Parser;
use mps_examples::submerged::{DAMPING, DIFFUSION, Settings, THICKNESS, VISCOSITY};
use mps_examples::{Common, Refused};

/// A clamped beam in water at rest, bent by its buoyancy.
///
/// The beam is let go straight and comes to rest where its stiffness carries the difference of weight and buoyancy. Writes
/// probes.csv, a plot of the deflection against finite elements, summary.json, and unless told otherwise fields for
/// ParaView and a picture.
#[derive(Parser, Clone, Debug)]
#[command(version, rename_all = "kebab-case", allow_negative_numbers = true)]
pub(crate) struct Options {
    /// Density of the beam (kg/m3): below 1000 it rises, above it sinks
    #[arg(long, value_name = "RHO", default_value_t = 500.0)]
    density: f64,
    /// Particles across the beam
    #[arg(long, value_name = "N", default_value_t = 4)]
    across: usize,
    /// Spacing of the water's particles (m): an even part of the beam's thickness of 0.02 m; that of the beam if left out
    #[arg(long, value_name = "M")]
    spacing: Option<f64>,
    /// Simulated time (s)
    #[arg(long, value_name = "S", default_value_t = 15.0)]
    pub(crate) end_time: f64,
    /// Effective radius over spacing; if left out 4, or 3 where the beam is too thin for it
    #[arg(long, value_name = "RATIO")]
    radius: Option<f64>,
    /// Strength of the density diffusion; 0 switches it off
    #[arg(long, value_name = "D", default_value_t = DIFFUSION)]
    diffusion: f64,
    /// Kinematic viscosity of the water (m2/s)
    #[arg(long, value_name = "NU", default_value_t = VISCOSITY)]
    viscosity: f64,
    /// Damping of the beam's velocity (1/s): quickens the way to rest, does not change it
    #[arg(long, value_name = "C", default_value_t = DAMPING)]
    damping: f64,
    /// Numerical sound speed over sqrt(g H)
    #[arg(long, value_name = "RATIO", default_value_t = 10.0)]
    sound_ratio: f64,
    /// Courant number of the water
    #[arg(long, value_name = "C", default_value_t = 0.5)]
    cfl: f64,
    /// Print the scene file that is this run instead of running it, for `mps run`, which writes checkpoints to go on from
    #[arg(long)]
    pub(crate) print_scene: bool,
    #[command(flatten)]
    pub(crate) common: Common,
}

impl Options {
    /// Refuses what cannot be run, before anything is built.
    pub(crate) fn settings(&self) -> Result<Settings, Refused> {
        let within = |flag, value: f64, low: f64, high: f64, remedy: &str| {
            Refused::unless(value >= low && value <= high, flag, value, remedy)
        };
        within("--density", self.density, 50.0, 5000.0, "give the density in kg/m3, 50 to 5000, e.g. 1500")?;
        let across = self.across;
        let needed = "the beam needs 2 to 64 particles across, e.g. 8";
        Refused::unless((2..=64).contains(&across), "--across", across, needed)?;
        let spacing = self.spacing.unwrap_or(THICKNESS / across as f64);
        within(
            "--spacing",
            spacing,
            2e-4,
            0.01,
            "give the distance between particles in metres, 2e-4 to 0.01",
        )?;
        let half = 0.5 * THICKNESS / spacing;
        let even = "half the thickness of the beam (0.01 m) has to be a whole number of it: 0.01, 0.005, 0.0025, ...";
        Refused::unless((half - half.round()).abs() < 1e-6, "--spacing", spacing, even)?;
        within(
            "--end-time",
            self.end_time,
            1e-6,
            1000.0,
            "give the simulated time in seconds, at most 1000",
        )?;
        let widest = Settings::widest(spacing);
        let radius = self.radius.unwrap_or(widest);
        let thick = "give a radius of 3 to 4 spacings, and at most the thickness of the beam and one spacing";
        within("--radius", radius, 3.0, widest, thick)?;
        within("--diffusion", self.diffusion, 0.0, 2.0, "give a strength between 0 and 2, e.g. 0.5")?;
        within("--viscosity", self.viscosity, 0.0, 1.0, "give the kinematic viscosity in m2/s, e.g. 1e-4")?;
        within("--damping", self.damping, 0.0, 1e4, "give the damping in 1/s, e.g. 40, or 0 for none")?;
        let usual = "the numerical sound must be faster than the water; usual is 10";
        within("--sound-ratio", self.sound_ratio, 1.0, 1e4, usual)?;
        within("--cfl", self.cfl, 1e-3, 2.0, "give a Courant number of at most 2, e.g. 0.5")?;
        self.common.check()?;
        let Self { density, diffusion, viscosity, damping, sound_ratio, cfl, .. } = *self;
        Ok(Settings { spacing, across, density, sound_ratio, cfl, radius, diffusion, viscosity, damping })
    }
}
