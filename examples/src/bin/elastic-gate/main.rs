//! Case 4: a dam break through an elastic gate, from geometry to a film and a curve against the
//! experiment.

mod beside;
mod fields;
mod observe;
mod options;
mod reference;
mod report;
mod setup;

use beside::Earlier;
use clap::Parser;
use fields::Fields;
use mps_examples::{Due, Failure, Precision, closing_words, report_failure};
use mps_io::Progress;
use mps_kernel::Real;
use mps_neighbors::Parallel;
use observe::Observer;
use options::Options;
use setup::{GateScene, Settings};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

/// Steps between two looks at energy and leaks.
const WATCH_EVERY: u64 = 10;
/// Simulated time between two rows of probes.csv \[s\].
const PROBE_INTERVAL: f64 = 5e-4;
/// Between two frames of the film \[s\].
const FRAME_INTERVAL: f64 = 5e-3;
/// Between two frames of the fields for ParaView \[s\].
const FIELD_INTERVAL: f64 = 1e-2;
/// Between two snapshots \[s\].
const SNAPSHOT_INTERVAL: f64 = 4e-2;

fn main() -> ExitCode {
    let options = Options::parse();
    let done = match options.common.precision {
        Precision::F32 => run::<f32>(&options),
        Precision::F64 => run::<f64>(&options),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            report_failure(&failure);
            ExitCode::FAILURE
        }
    }
}

fn run<T: Real>(options: &Options) -> Result<(), Failure> {
    let settings = options.settings()?;
    let earlier = options.beside.iter().map(|dir| Earlier::read(dir)).collect::<Result<Vec<_>, _>>()?;
    let parallel = options.common.parallel()?;
    let dir = options.common.output("elastic-gate")?;
    let mut scene = setup::build::<T>(&settings, &parallel)?;
    let mut observer = Observer::new(&dir, &scene, settings.across, &parallel)?;
    let mut stepping = 0.0;
    // Inside the pool the loops of a step need no hand-over between threads.
    let done = parallel
        .install(|| advance(options, &settings, &dir, &mut scene, &mut observer, &parallel, &mut stepping));

    // Whatever happened, what has been computed is kept.
    report::plot(&dir, options, &observer, &earlier)?;
    let threads = parallel.threads();
    let summary =
        report::summary(options, &settings, &scene, &observer, threads, stepping, done.as_ref().err());
    summary.write(&dir)?;
    if done.is_ok() && !options.common.quiet {
        closing_words(&dir, &summary);
    }
    done
}

/// The time loop with everything that watches it.
fn advance<T: Real>(
    options: &Options,
    settings: &Settings,
    dir: &Path,
    scene: &mut GateScene<T>,
    observer: &mut Observer<T>,
    parallel: &Parallel,
    stepping: &mut f64,
) -> Result<(), Failure> {
    let end = settings.end_time;
    let mut progress = Progress::new(options.common.quiet, end);
    let mut fields = if options.common.no_fields {
        None
    } else {
        let title = format!("Dam break through an elastic gate, {}", options.material.name());
        Some(Fields::new(dir, title, scene)?)
    };
    let [mut probe, mut frame, mut field, mut snapshot] =
        [PROBE_INTERVAL, FRAME_INTERVAL, FIELD_INTERVAL, SNAPSHOT_INTERVAL].map(Due::every);
    let mut dt = 0.0;
    loop {
        let time = scene.fluid().time().to_double();
        let finished = time >= end;
        if probe.is_due(time) || finished {
            observer.record(scene, parallel, dt)?;
        }
        if scene.fluid().steps().is_multiple_of(WATCH_EVERY) || finished {
            observer.watch(scene, parallel);
        }
        if let Some(fields) = &mut fields {
            if field.is_due(time) || finished {
                fields.write(scene, parallel)?;
            }
            let picture = snapshot.is_due(time) || finished;
            if frame.is_due(time) || picture {
                fields.draw(scene, picture)?;
            }
        }
        if finished {
            progress.finish(time, scene.fluid().steps());
            return Ok(());
        }
        let clock = Instant::now();
        // Whole steps to the end: a shortened one would show as a jump of the energy, whose value
        // at the ends of a symplectic step depends on the length of the step.
        let step = scene.step(parallel, T::of(f64::INFINITY));
        *stepping += clock.elapsed().as_secs_f64();
        match step {
            Ok(taken) => dt = taken.to_double(),
            Err(failure) => {
                if let Some(fields) = &mut fields {
                    fields.write(scene, parallel)?;
                    fields.draw(scene, true)?;
                }
                return Err(failure.into());
            }
        }
        progress.update(time, scene.fluid().steps(), dt, format_args!("{} sub-steps", scene.substeps()));
    }
}
