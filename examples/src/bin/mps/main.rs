//! Runs scenes that are written down in files.

use clap::{Args, Parser, Subcommand, ValueEnum};
use mps_examples::scene::{
    Diagnosis, Drawing, Layout, Window, diagnose, harmonics, plan, plot, resume, run, short_of_disk,
};
use mps_examples::{Common, Failure, LogLevel, Precision, Refused, exit_code};
use mps_io::scene_file::{self, OnFailure, Retry, SceneError, SceneFile};
use mps_neighbors::Parallel;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Particle simulation of flow that meets deforming structures: runs scene files.
///
/// A scene file describes geometry, materials, numerics, probes and output in TOML; docs/scenes.md is a tutorial, and
/// examples/scenes has scenes to start from.
#[derive(Parser, Clone, Debug)]
#[command(name = "mps", version)]
struct Options {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand, Clone, Debug)]
enum Command {
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
    /// Print the JSON Schema of scene files, for editors that complete and check them
    Schema {
        /// A table of all keys in Markdown instead
        #[arg(long)]
        reference: bool,
    },
}

#[derive(Args, Clone, Debug)]
struct Begin {
    #[command(flatten)]
    run: Run,
    #[command(flatten)]
    keep: Keep,
    /// What becomes of a run that fails, instead of what its scene says
    #[arg(long, value_enum, value_name = "WAY")]
    on_failure: Option<Way>,
}

#[derive(ValueEnum, Clone, Copy, Debug)]
enum Way {
    /// It stops, with a post-mortem
    Stop,
    /// It goes back and tries with shorter steps; how often and how long, the scene may say
    Retry,
}

impl Way {
    /// The way with the numbers of the scene, where it has some.
    fn with_numbers_of(self, scene: OnFailure) -> OnFailure {
        match (self, scene) {
            (Self::Stop, _) => OnFailure::Stop,
            (Self::Retry, OnFailure::Retry(_)) => scene,
            (Self::Retry, OnFailure::Stop) => OnFailure::Retry(Retry::default()),
        }
    }
}

#[derive(Args, Clone, Debug)]
struct Keep {
    /// Wall time between two checkpoints (s); 0 for none but at a signal and at the end
    #[arg(long, value_name = "S", default_value_t = 300.0, allow_negative_numbers = true)]
    checkpoint: f64,
}

impl Keep {
    fn interval(&self) -> Result<f64, Refused> {
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
struct Resume {
    /// The directory of the run
    directory: PathBuf,
    /// Simulated time at which it ends (s), instead of that of the scene
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    end_time: Option<f64>,
    /// Threads; all cores if left out
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
    /// No progress, no closing words
    #[arg(long)]
    quiet: bool,
    /// How much goes into run.log beside the results
    #[arg(long, value_enum, value_name = "LEVEL", default_value_t)]
    log: LogLevel,
    #[command(flatten)]
    keep: Keep,
}

impl Resume {
    fn go_on(&self) -> Result<(), Failure> {
        let common = Common {
            threads: self.threads,
            precision: Precision::F64,
            out: None,
            no_fields: false,
            quiet: self.quiet,
            log: self.log,
        };
        common.check()?;
        resume(&self.directory, self.end_time, &common, self.keep.interval()?)
    }
}

#[derive(Args, Clone, Debug)]
struct Plot {
    /// The directory of the run: of this program, or of another one with a table
    directory: PathBuf,
    /// A column, by its heading with or without the unit; may be repeated
    #[arg(long = "column", value_name = "NAME")]
    columns: Vec<String>,
    /// The column they are drawn over; the time if left out
    #[arg(long, value_name = "NAME", requires = "columns")]
    over: Option<String>,
    /// The picture; columns.png in the directory of the run if left out
    #[arg(long, value_name = "FILE", requires = "columns")]
    picture: Option<PathBuf>,
}

#[derive(Args, Clone, Debug)]
struct Harmonics {
    /// The directory of the run: of this program, or of another one with a table
    directory: PathBuf,
    /// A column, by its heading with or without the unit; may be repeated; all if left out
    #[arg(long = "column", value_name = "NAME")]
    columns: Vec<String>,
    /// Begin of the part that is taken apart (s); the middle of the run if left out
    #[arg(long, value_name = "S")]
    from: Option<f64>,
    /// Its end (s); that of the run if left out
    #[arg(long, value_name = "S")]
    to: Option<f64>,
    /// How many harmonics of each column
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u8).range(1..=20))]
    count: u8,
}

#[derive(Args, Clone, Debug)]
struct Run {
    /// The scene file
    scene: PathBuf,
    /// Simulated time (s), instead of that of the scene
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    end_time: Option<f64>,
    #[command(flatten)]
    common: Common,
}

fn main() -> ExitCode {
    let done = match Options::parse().command {
        Command::Run(Begin { run: options, keep, on_failure }) => Loaded::of(&options).and_then(|loaded| {
            let Loaded { mut scene, layout, .. } = loaded.without_refusals()?;
            if let Some(way) = on_failure {
                scene.watch.on_failure = way.with_numbers_of(scene.watch.on_failure);
            }
            let name = name(&options.scene);
            short_of_disk(&scene, &layout, &options.common, name).iter().for_each(|short| warn(short));
            run(&scene, &layout, name, &options.common, keep.interval()?)
        }),
        Command::Resume(options) => options.go_on(),
        Command::Plan(options) => Loaded::of(&options).and_then(|loaded| {
            let loaded = loaded.without_refusals()?;
            let Loaded { scene, layout, diagnosis } = &loaded;
            short_of_disk(scene, layout, &options.common, name(&options.scene))
                .iter()
                .for_each(|short| warn(short));
            say(&plan(scene, layout, diagnosis, &options.common)?);
            Ok(())
        }),
        Command::Check { scene } => {
            Loaded::read(&scene, None).and_then(Loaded::without_refusals).map(|loaded| {
                let layout = &loaded.layout;
                let counts = [layout.fluid_len(), layout.walls_len(), layout.solids_len()];
                let [fluid, walls, solids] = counts;
                say(&format!(
                    "{}: good, {fluid} particles of fluid, {walls} of walls, {solids} of bodies\n",
                    scene.display()
                ));
            })
        }
        Command::Plot(Plot { directory, columns, over, picture }) => {
            plot(&directory, &Drawing { columns, over, picture }).map(|drawn| say(&format!("{drawn}\n")))
        }
        Command::Harmonics(Harmonics { directory, columns, from, to, count }) => {
            let window = Window { from, to, count: usize::from(count) };
            harmonics(&directory, &columns, window).map(|table| say(&table))
        }
        Command::Schema { reference } => {
            let schema =
                if reference { scene_file::reference() } else { format!("{:#}\n", scene_file::schema()) };
            say(&schema);
            Ok(())
        }
    };
    exit_code(done)
}

/// A scene that was read, filled with particles and examined.
struct Loaded {
    scene: SceneFile,
    layout: Layout,
    diagnosis: Diagnosis,
}

impl Loaded {
    fn of(options: &Run) -> Result<Self, Failure> {
        options.common.check()?;
        Self::read(&options.scene, options.end_time)
    }

    fn read(path: &Path, end_time: Option<f64>) -> Result<Self, Failure> {
        let (mut scene, source) = scene_file::read(path)?;
        if let Some(end) = end_time {
            let good = end.is_finite() && end > 0.0;
            Refused::unless(good, "--end-time", end, "give the simulated time in seconds")?;
            scene.end_time = end;
        }
        let layout = Layout::new(&scene, &source)?;
        let diagnosis = diagnose(&scene, &source, &layout, &Parallel::all_cores()?)?;
        Ok(Self { scene, layout, diagnosis })
    }

    /// Warns, and refuses what cannot be run.
    fn without_refusals(self) -> Result<Self, Failure> {
        for warning in &self.diagnosis.warnings {
            warn(&warning.to_string());
        }
        let refusals = &self.diagnosis.refusals;
        if refusals.is_empty() { Ok(self) } else { Err(SceneError::Refused(refusals.clone()).into()) }
    }
}

/// The name of a scene is that of its file.
fn name(path: &Path) -> &str {
    path.file_stem().and_then(|stem| stem.to_str()).unwrap_or("scene")
}

#[allow(clippy::print_stdout, reason = "a program talks to its user")]
fn say(text: &str) {
    print!("{text}");
}

#[allow(clippy::print_stderr, reason = "a program talks to its user")]
fn warn(text: &str) {
    eprintln!("warning: {text}");
}
