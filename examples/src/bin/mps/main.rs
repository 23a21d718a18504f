//! Runs scenes that are written down in files.

mod options;

use clap::Parser;
use mps_examples::scene::{Drawing, Examined, Window, converge, harmonics, plot, resume};
use mps_examples::{Common, Failure, Precision, Refused, exit_code};
use mps_io::scene_file;
use options::{Begin, Command, Converge, Harmonics, Options, Plot, Resume, Run, Way};
use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let done = match Options::parse().command {
        Command::Run(options) => begin(options),
        Command::Resume(options) => go_on(&options),
        Command::Plan(options) => examined(&options, None).and_then(|good| {
            good.short_of_disk(&options.common, name(&options.scene)).iter().for_each(|short| warn(short));
            say(&good.plan(&options.common)?);
            Ok(())
        }),
        Command::Check { scene } => read(&scene, None, None).map(|good| {
            let [fluid, walls, solids] = good.counts();
            say(&format!(
                "{}: good, {fluid} particles of fluid, {walls} of walls, {solids} of bodies\n",
                scene.display()
            ));
        }),
        Command::Plot(Plot { directory, columns, over, picture }) => {
            plot(&directory, &Drawing { columns, over, picture }).map(|drawn| say(&format!("{drawn}\n")))
        }
        Command::Harmonics(Harmonics { directory, columns, from, to, count }) => {
            let window = Window { from, to, count: usize::from(count) };
            harmonics(&directory, &columns, window).map(|table| say(&table))
        }
        Command::Converge(Converge { directories, columns, from, to }) => {
            converge(&directories, &columns, [from, to]).map(|table| say(&table))
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

fn begin(Begin { run: options, keep, on_failure }: Begin) -> Result<(), Failure> {
    let good = examined(&options, on_failure)?;
    let name = name(&options.scene);
    good.short_of_disk(&options.common, name).iter().for_each(|short| warn(short));
    good.run(name, &options.common, keep.interval()?)
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

fn examined(options: &Run, on_failure: Option<Way>) -> Result<Examined, Failure> {
    options.common.check()?;
    read(&options.scene, options.end_time, on_failure)
}

/// Reads a scene and examines it, warns, and refuses what cannot be run.
fn read(path: &Path, end_time: Option<f64>, on_failure: Option<Way>) -> Result<Examined, Failure> {
    let (mut scene, source) = scene_file::read(path)?;
    if let Some(end) = end_time {
        let good = end.is_finite() && end > 0.0;
        Refused::unless(good, "--end-time", end, "give the simulated time in seconds")?;
        scene.end_time = end;
    }
    if let Some(way) = on_failure {
        scene.watch.on_failure = way.with_numbers_of(scene.watch.on_failure);
    }
    let examined = Examined::new(scene, &source)?;
    examined.diagnosis().warnings.iter().for_each(|warning| warn(&warning.to_string()));
    Ok(examined.without_refusals()?)
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
