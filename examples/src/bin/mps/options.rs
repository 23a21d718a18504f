//! The command line of the program.

use clap::{Args, Parser, Subcommand, ValueEnum};
use mps_examples::{Common, LogLevel, Refused};
use mps_io::scene_file::{OnFailure, Retry};
use std::path::PathBuf;

/// Particle simulation of flow that meets deforming structures: runs scene files.
///
/// A scene file describes geometry, materials, numerics, probes and output in TOML; docs/scenes.md is a tutorial, and
/// examples/scenes has scenes to start from.
#[derive(Parser, Clone, Debug)]
#[command(name = "mps", version)]
pub(crate) struct Options {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Subcommand, Clone, Debug)]
pub(crate) enum Command {
    /// Run a scene and write its results
    Run(Begin),
    /// Go on with a run from its last checkpoint, in its directory
    Resume(Resume),
    /// Say what is wrong with a scene, without running it
    Check {
        /// The scene file
        scene: PathBuf,
    },
    /// Say what a run will be and cost, measured by its first steps
    Plan(Run),
    /// Draw the plots of a run again from its table of probes, or columns of it in one plot
    Plot(Plot),
    /// Take columns of the table of a run apart into their strongest harmonics
    Harmonics(Harmonics),
    /// Say how far the curves of a series of runs are apart, and of what order they converge
    Converge(Converge),
    /// Print the JSON Schema of scene files, for editors that complete and check them
    Schema {
        /// A table of all keys in Markdown instead
        #[arg(long)]
        reference: bool,
    },
}

#[derive(Args, Clone, Debug)]
pub(crate) struct Begin {
    #[command(flatten)]
    pub(crate) run: Run,
    #[command(flatten)]
    pub(crate) keep: Keep,
    /// What becomes of a run that fails, instead of what its scene says
    #[arg(long, value_enum, value_name = "WAY")]
    pub(crate) on_failure: Option<Way>,
}

#[derive(ValueEnum, Clone, Copy, Debug)]
pub(crate) enum Way {
    /// It stops, with a post-mortem
    Stop,
    /// It goes back and tries with shorter steps; how often and how long, the scene may say
    Retry,
}

impl Way {
    /// The way with the numbers of the scene, where it has some.
    pub(crate) fn with_numbers_of(self, scene: OnFailure) -> OnFailure {
        match (self, scene) {
            (Self::Stop, _) => OnFailure::Stop,
            (Self::Retry, OnFailure::Retry(_)) => scene,
            (Self::Retry, OnFailure::Stop) => OnFailure::Retry(Retry::default()),
        }
    }
}

#[derive(Args, Clone, Debug)]
pub(crate) struct Keep {
    /// Wall time between two checkpoints (s); 0 for none but at a signal and at the end
    #[arg(long, value_name = "S", default_value_t = 300.0, allow_negative_numbers = true)]
    pub(crate) checkpoint: f64,
}

impl Keep {
    pub(crate) fn interval(&self) -> Result<f64, Refused> {
        let good = (0.0..1e9).contains(&self.checkpoint);
        Refused::unless(
            good,
            "--checkpoint",
            self.checkpoint,
            "give seconds, or 0 for no checkpoints at an interval",
        )?;
        Ok(self.checkpoint)
    }
}

#[derive(Args, Clone, Debug)]
pub(crate) struct Resume {
    /// The directory of the run
    pub(crate) directory: PathBuf,
    /// Simulated time at which it ends (s), instead of that of the scene
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    pub(crate) end_time: Option<f64>,
    /// Threads; all cores if left out
    #[arg(long, value_name = "N")]
    pub(crate) threads: Option<usize>,
    /// No progress, no closing words
    #[arg(long)]
    pub(crate) quiet: bool,
    /// How much goes into run.log beside the results
    #[arg(long, value_enum, value_name = "LEVEL", default_value_t)]
    pub(crate) log: LogLevel,
    #[command(flatten)]
    pub(crate) keep: Keep,
}

#[derive(Args, Clone, Debug)]
pub(crate) struct Plot {
    /// The directory of the run: of this program, or of another one with a table
    pub(crate) directory: PathBuf,
    /// A column, by its heading with or without the unit; may be repeated
    #[arg(long = "column", value_name = "NAME")]
    pub(crate) columns: Vec<String>,
    /// The column they are drawn over; the time if left out
    #[arg(long, value_name = "NAME", requires = "columns")]
    pub(crate) over: Option<String>,
    /// The picture; columns.png in the directory of the run if left out
    #[arg(long, value_name = "FILE", requires = "columns")]
    pub(crate) picture: Option<PathBuf>,
}

#[derive(Args, Clone, Debug)]
pub(crate) struct Harmonics {
    /// The directory of the run: of this program, or of another one with a table
    pub(crate) directory: PathBuf,
    /// A column, by its heading with or without the unit; may be repeated; all if left out
    #[arg(long = "column", value_name = "NAME")]
    pub(crate) columns: Vec<String>,
    /// Begin of the part that is taken apart (s); the middle of the run if left out
    #[arg(long, value_name = "S")]
    pub(crate) from: Option<f64>,
    /// Its end (s); that of the run if left out
    #[arg(long, value_name = "S")]
    pub(crate) to: Option<f64>,
    /// How many harmonics of each column
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u8).range(1..=20))]
    pub(crate) count: u8,
}

#[derive(Args, Clone, Debug)]
pub(crate) struct Converge {
    /// The directories of the runs, from the coarsest to the finest: of this program, or of another one with a table
    #[arg(required = true, num_args = 2..)]
    pub(crate) directories: Vec<PathBuf>,
    /// A column, by its heading with or without the unit; may be repeated
    #[arg(long = "column", value_name = "NAME", required = true)]
    pub(crate) columns: Vec<String>,
    /// Begin of the part that is compared (s); that of the runs if left out
    #[arg(long, value_name = "S")]
    pub(crate) from: Option<f64>,
    /// Its end (s); that of the shortest run if left out
    #[arg(long, value_name = "S")]
    pub(crate) to: Option<f64>,
}

#[derive(Args, Clone, Debug)]
pub(crate) struct Run {
    /// The scene file
    pub(crate) scene: PathBuf,
    /// Simulated time (s), instead of that of the scene
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    pub(crate) end_time: Option<f64>,
    #[command(flatten)]
    pub(crate) common: Common,
}
