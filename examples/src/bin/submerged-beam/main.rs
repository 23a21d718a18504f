//! A clamped beam in a tank of water, bent by its buoyancy until it comes to rest: does the interface carry a static load
//! right?

mod describe;
mod options;
mod report;
mod run;

use clap::Parser;
use mps_examples::scene::print_scene;
use mps_examples::{
    Cost, Failure, Precision, Watch, conclude, exit_code, record, remove_leftovers, submerged,
};
use mps_kernel::Real;
use options::Options;
use run::Run;
use std::process::ExitCode;

/// What a run writes beside its table and its log, which it begins anew in any case (`remove_leftovers`).
const WRITTEN: &[&str] =
    &["summary.json", "deflection.png", "snapshot.png", "fields/water.pvd", "fields/beam.pvd"];

fn main() -> ExitCode {
    let options = Options::parse();
    exit_code(match options.common.precision {
        Precision::F32 => run::<f32>(&options),
        Precision::F64 => run::<f64>(&options),
    })
}

fn run<T: Real>(options: &Options) -> Result<(), Failure> {
    let settings = options.settings()?;
    if options.print_scene {
        let scene = describe::scene(&settings, options.end_time);
        return print_scene("submerged-beam", scene, &options.common);
    }
    let parallel = options.common.parallel()?;
    let dir = options.common.output("submerged-beam")?;
    let mut scene = submerged::build::<T>(&settings, &parallel)?;
    remove_leftovers(&dir, WRITTEN)?;
    let mut run = Run::new(&dir, &mut scene, &settings, &parallel, options.common.no_fields)?;
    let (end, watch, mut seconds) = (options.end_time, Watch::begin(&dir, &options.common)?, 0.0);
    // Inside the pool the loops of a step need no hand-over between threads.
    let done = parallel.install(|| record(&mut run, end, &watch, &mut seconds));

    // Whatever happened, what has been computed is kept.
    let samples = run.into_samples();
    report::plot(&dir, &settings, &samples)?;
    let cost = Cost {
        threads: parallel.threads(),
        steps: scene.fluid().steps(),
        seconds,
        simulated: scene.fluid().time().to_double(),
        particles: scene.fluid().particles().position.len(),
    };
    let summary = |dry: Result<f64, &str>| {
        let mut summary = report::summary(&settings, &scene, &samples, dry);
        summary.set("end_time_s", options.end_time);
        cost.enter(&mut summary, &options.common, done.as_ref().err());
        summary
    };
    if done.is_err() {
        conclude(&dir, &summary(Err("the run ended before")), &options.common, false)?;
        return done;
    }
    // The reference may take as long as the run: whatever becomes of it, the run is kept.
    summary(Err("the program was ended before")).write(&dir)?;
    // In f64: the forces of a beam at rest are smaller than what f32 rounds off.
    let dry = parallel.install(|| submerged::dry_deflection::<f64>(&settings, &parallel, &watch));
    let missing = dry.as_ref().err().map(ToString::to_string);
    let known = dry.as_ref().map_err(|_| missing.as_deref().unwrap_or_default());
    conclude(&dir, &summary(known.copied()), &options.common, true)?;
    dry.map(drop).map_err(|failure| {
        let words =
            "the run is completed and kept; the same beam without water, with which it is compared, is not";
        format!("{words}: {failure}").into()
    })
}
