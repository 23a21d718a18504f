//! Case 2: the dam break of Lobovsky et al. (2014), from the column of water to the pressure on the wall
//! against a hundred experiments.

mod fields;
mod metrics;
mod observe;
mod options;
mod outline;
mod reference;
mod report;
mod sensors;
mod setup;
mod stabilisers;

use clap::Parser;
use fields::Fields;
use mps_examples::{Due, Failure, Moments, Precision, closing_words, report_failure};
use mps_io::{Progress, Summary};
use mps_kernel::weights::{Rational, WendlandGradient};
use mps_kernel::{Kernel, Real};
use mps_neighbors::Parallel;
use observe::Observer;
use options::{Options, Weight};
use setup::{DamBreak, Settings, TIME};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

/// Steps between two looks at energy and leaks.
const WATCH_EVERY: u64 = 10;
/// Simulated time between two rows of probes.csv \[s\].
const PROBE_INTERVAL: f64 = 5e-4;
/// Between two frames of the film, and of the fields for ParaView \[s\].
const FRAME_INTERVAL: f64 = 2e-2;
/// Times of the snapshots over `sqrt(H/g)`: the fall, the run along the bed, the impact, the jet up
/// the wall, its fall, and the returning wave.
const SNAPSHOTS: [f64; 10] = [0.0, 1.0, 2.0, 2.5, 3.0, 4.0, 5.0, 5.5, JET, 7.0];
/// When the paper shows the returning jet (its Fig. 12), over `sqrt(H/g)`.
const JET: f64 = 6.0;

fn main() -> ExitCode {
    match run_all(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            report_failure(&failure);
            ExitCode::FAILURE
        }
    }
}

fn run_all(options: &Options) -> Result<(), Failure> {
    if !options.stabilisers {
        let (_, done) = run_with_precision(options)?;
        return done;
    }
    options.settings()?;
    let dir = options.common.out.clone().unwrap_or_else(|| "out/stabilisers".into());
    // One that ends early has its row as well.
    stabilisers::compare(options, &dir, |options| Ok(run_with_precision(options)?.0))
}

/// The results of a run and how it ended.
type Ended = (Summary, Result<(), Failure>);

fn run_with_precision(options: &Options) -> Result<Ended, Failure> {
    match options.common.precision {
        Precision::F32 => run_with_weight::<f32>(options),
        Precision::F64 => run_with_weight::<f64>(options),
    }
}

fn run_with_weight<T: Real>(options: &Options) -> Result<Ended, Failure> {
    match options.weight {
        Weight::Smooth => run::<T, _>(options, WendlandGradient),
        Weight::Rational => run::<T, _>(options, Rational),
    }
}

fn run<T: Real, K: Kernel<T>>(options: &Options, weight: K) -> Result<Ended, Failure> {
    let settings = options.settings()?;
    let parallel = options.common.parallel()?;
    let dir = options.common.output("dam-break")?;
    let mut dam = DamBreak::<T, K>::new(&settings, weight)?;
    if !options.no_books {
        dam.fluid_mut().keep_books();
    }
    let mut observer = Observer::new(&dir, &mut dam, &parallel)?;
    let mut stepping = 0.0;
    // Inside the pool the loops of a step need no hand-over between threads.
    let done = parallel
        .install(|| advance(options, &settings, &dir, &mut dam, &mut observer, &parallel, &mut stepping));

    // Whatever happened, what has been computed is kept.
    report::plot(&dir, options, &observer)?;
    let threads = parallel.threads();
    let summary =
        report::summary(options, &settings, &dam, &observer, threads, stepping, done.as_ref().err());
    summary.write(&dir)?;
    if done.is_ok() && !options.common.quiet {
        closing_words(&dir, &summary);
    }
    Ok((summary, done))
}

/// The time loop with everything that watches it.
fn advance<T: Real, K: Kernel<T>>(
    options: &Options,
    settings: &Settings,
    dir: &Path,
    dam: &mut DamBreak<T, K>,
    observer: &mut Observer,
    parallel: &Parallel,
    stepping: &mut f64,
) -> Result<(), Failure> {
    let end = settings.end_time;
    let mut progress = Progress::new(options.common.quiet, end);
    let mut fields = if options.common.no_fields { None } else { Some(Fields::new(dir, dam)?) };
    let [mut probe, mut frame] = [PROBE_INTERVAL, FRAME_INTERVAL].map(Due::every);
    let mut snapshots = Moments::at(SNAPSHOTS.map(|t| t * TIME).to_vec());
    let mut dt = 0.0;
    loop {
        let time = dam.fluid().time().to_double();
        let finished = time >= end;
        if probe.is_due(time) || finished {
            observer.record(dam, parallel, dt)?;
        }
        if dam.fluid().steps().is_multiple_of(WATCH_EVERY) || finished {
            observer.watch(dam, parallel);
        }
        if let Some(fields) = &mut fields {
            if frame.is_due(time) || finished {
                fields.write(dam, parallel)?;
                fields.frame(dam)?;
            }
            if let Some(moment) = snapshots.due(time) {
                fields.snapshot(dam, moment / TIME)?;
            }
        }
        if finished {
            observer.finish(dam, parallel)?;
            progress.finish(time, dam.fluid().steps());
            return Ok(());
        }
        let clock = Instant::now();
        let step = dam.step(parallel);
        *stepping += clock.elapsed().as_secs_f64();
        match step {
            Ok(taken) => dt = taken.to_double(),
            Err(failure) => {
                if let Some(fields) = &mut fields {
                    fields.write(dam, parallel)?;
                    fields.snapshot(dam, time / TIME)?;
                }
                return Err(failure.into());
            }
        }
        progress.update(time, dam.fluid().steps(), dt, format_args!("t √(g/H) = {:.2}", time / TIME));
    }
}
