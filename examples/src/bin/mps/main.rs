//! Runs scenes that are written down in files.

mod options;

use clap::Parser;
use mps_examples::scene::{
    Diagnosis, Drawing, Layout, Window, diagnose, harmonics, plan, plot, resume, run, short_of_disk,
};
use mps_examples::{Common, Failure, Precision, Refused, exit_code};
use mps_io::scene_file::{self, SceneError, SceneFile};
use mps_neighbors::Parallel;
use options::{Begin, Command, Harmonics, Options, Plot, Resume, Run};
use std::path::Path;
use std::process::ExitCode;

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
        Command::Resume(options) => go_on(&options),
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

fn go_on(options: &Resume) -> Result<(), Failure> {
    let common = Common {
        threads: options.threads,
        precision: Precision::F64,
        out: None,
        no_fields: false,
        quiet: options.quiet,
        log: options.log,
    };
    common.check()?;
    resume(&options.directory, options.end_time, &common, options.keep.interval()?)
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
