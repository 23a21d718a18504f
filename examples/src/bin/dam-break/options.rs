//! The command line of the program, and the settings it stands for.

use crate::setup::{HEIGHT, Release, Settings, Smoothing, Walls};
use clap::Parser;
use mps_examples::{Common, Preset, PresetFlag, Refused, Weight};
use mps_fluid::{PressureForm, Tension};

/// Dam break onto a dry bed and against a wall (Lobovsky et al. 2014; case 2 of the paper).
///
/// A column of water 0.6 m high and 1.2 m long is let go in a tank 3.22 m long. Writes probes.csv, front.png,
/// a plot of each pressure sensor against the experiment, summary.json, and unless told otherwise fields for
/// ParaView, snapshots and a film.
#[derive(Parser, Clone, Debug)]
#[command(version, rename_all = "kebab-case", allow_negative_numbers = true)]
pub(crate) struct Options {
    /// Spacing of the particles (m)
    #[arg(long, value_name = "M", default_value_t = 5e-3)]
    pub(crate) spacing: f64,
    /// Weight of the particle sums
    #[arg(long, value_enum, default_value_t = Weight::Smooth)]
    pub(crate) weight: Weight,
    /// Effective radius over the spacing; by default 4 with the smooth weight and 3 with the rational one
    #[arg(long, value_name = "RATIO")]
    pub(crate) radius: Option<f64>,
    /// Simulated time (s); the unit of the plots, sqrt(H/g), is 0.247 s
    #[arg(long, value_name = "S", default_value_t = 1.75)]
    pub(crate) end_time: f64,
    /// How the column is let go
    #[arg(long, value_enum, default_value_t = Release::Instant)]
    pub(crate) release: Release,
    /// How the water moves along bed and walls
    #[arg(long, value_enum, default_value_t = Walls::Law)]
    pub(crate) walls: Walls,
    /// Numerical sound speed over the speed of free fall from the surface
    #[arg(long, value_name = "RATIO", default_value_t = 10.0)]
    pub(crate) sound_ratio: f64,
    /// Courant number
    #[arg(long, value_name = "C", default_value_t = 1.0)]
    pub(crate) cfl: f64,
    /// Strength of the density diffusion; 0 switches it off
    #[arg(long, value_name = "DELTA", default_value_t = 0.5)]
    pub(crate) diffusion: f64,
    /// The density diffusion without a strength that removes the hydrostatic part (Amaro et al. 2022) instead
    #[arg(long, conflicts_with = "diffusion")]
    pub(crate) hydrostatic_diffusion: bool,
    /// Strength of the artificial viscosity
    #[arg(long, value_name = "ALPHA", default_value_t = 0.02)]
    pub(crate) alpha: f64,
    /// Keep pressures below zero instead of cutting them off
    #[arg(long)]
    pub(crate) keep_tension: bool,
    /// No collisions between close particles
    #[arg(long)]
    pub(crate) no_dpc: bool,
    /// Shift the particles towards an even distribution, in K parts a step (the paper has 5); 0 does not
    #[arg(long, value_name = "K", default_value_t = 0)]
    pub(crate) shifting: u32,
    /// Correct pressure gradient and divergence by the moment matrix of each particle: for smooth flows; violent
    /// ones tear with it so far
    #[arg(long)]
    pub(crate) corrected: bool,
    /// Do not split the energy by cause, which costs a third of a step
    #[arg(long)]
    pub(crate) no_books: bool,
    /// Run with each stabiliser switched in turn, and write a table of what it brings and costs
    #[arg(long)]
    pub(crate) stabilisers: bool,
    /// Print the scene file that is this run instead of running it: for runs that have to outlast interruptions. `mps run` of that file writes
    /// checkpoints, from which `mps resume` goes on with the same bits
    #[arg(long)]
    pub(crate) print_scene: bool,
    #[command(flatten)]
    _preset: PresetFlag,
    #[command(flatten)]
    pub(crate) common: Common,
}

/// What the presets stand for; their errors are in `docs/trade.md`; those of the cheap ones are held by `examples/tests/presets.rs`.
pub(crate) fn preset(preset: Preset) -> mps_examples::Settings {
    match preset {
        Preset::Fast => &[("spacing", "0.03"), ("sound-ratio", "5")],
        Preset::Balanced => &[
            ("spacing", "0.02"),
            ("radius", "3"),
            ("cfl", "0.8"),
            ("sound-ratio", "5"),
            ("precision", "f32"),
        ],
        Preset::Accurate => &[("spacing", "0.01"), ("sound-ratio", "5")],
    }
}

impl Options {
    /// Effective radius over the spacing.
    fn radius(&self) -> f64 {
        self.radius.unwrap_or_else(|| self.weight.radius())
    }

    /// Refuses what cannot be run, before anything is built.
    pub(crate) fn settings(&self) -> Result<Settings, Refused> {
        let positive = |x: f64| x.is_finite() && x > 0.0;
        let l0 = self.spacing;
        Refused::unless(
            positive(l0),
            "--spacing",
            l0,
            "give the distance between particles in metres, e.g. 5e-3",
        )?;
        let high_enough = format!(
            "the column would be {:.1} particles high and needs at least 20; give at most {:e} m",
            HEIGHT / l0,
            HEIGHT / 20.0
        );
        Refused::unless(HEIGHT / l0 >= 20.0 - 1e-9, "--spacing", l0, high_enough)?;
        Refused::unless(
            l0 >= 4e-4,
            "--spacing",
            l0,
            "more than four million particles would be needed; give at least 4e-4 m",
        )?;
        // The unit of all results, and half of the length of the column, which ends at the gate.
        Refused::unless_whole(HEIGHT, l0, "the height of the column")?;
        Refused::unless(
            (2.0..=6.0).contains(&self.radius()),
            "--radius",
            self.radius(),
            "give an effective radius between 2 and 6 spacings, e.g. 4",
        )?;
        Refused::unless(
            positive(self.end_time),
            "--end-time",
            self.end_time,
            "give the simulated time in seconds, e.g. 1.75",
        )?;
        Refused::unless(
            self.end_time <= 60.0,
            "--end-time",
            self.end_time,
            "the water has come to rest before; give at most 60 s",
        )?;
        Refused::unless(
            self.sound_ratio.is_finite() && (1.0..=1000.0).contains(&self.sound_ratio),
            "--sound-ratio",
            self.sound_ratio,
            "the numerical sound must be faster than the water and not so fast that steps vanish; usual is 10",
        )?;
        Refused::unless(
            positive(self.cfl) && self.cfl <= 2.0,
            "--cfl",
            self.cfl,
            "give a Courant number between 0 and 2, e.g. 0.5",
        )?;
        Refused::unless(
            (0.0..=2.0).contains(&self.diffusion),
            "--diffusion",
            self.diffusion,
            "give a strength between 0 and 2, e.g. 0.5",
        )?;
        Refused::unless(
            (0.0..=10.0).contains(&self.alpha),
            "--alpha",
            self.alpha,
            "give a strength between 0 and 10, e.g. 0.02",
        )?;
        Refused::unless_few_shifts(self.shifting)?;
        self.common.check()?;
        Ok(Settings {
            spacing: l0,
            radius: self.radius(),
            end_time: self.end_time,
            release: self.release,
            walls: self.walls,
            sound_ratio: self.sound_ratio,
            cfl: self.cfl,
            diffusion: if self.hydrostatic_diffusion {
                Smoothing::Hydrostatic
            } else {
                Smoothing::Filter(self.diffusion)
            },
            alpha: self.alpha,
            tension: if self.keep_tension { Tension::Keep } else { Tension::Clip },
            collisions: !self.no_dpc,
            shifting: self.shifting,
            pressure_form: if self.corrected { PressureForm::Corrected } else { PressureForm::Plain },
        })
    }
}
