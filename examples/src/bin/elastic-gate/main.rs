//! Case 4: a dam break through an elastic gate, from geometry to a film and a curve against the
//! experiment.

mod beside;
mod describe;
mod fields;
mod observe;
mod options;
mod reference;
mod report;
mod run;
mod setup;

use beside::Earlier;
use fields::Fields;
use mps_examples::scene::print_scene;
use mps_examples::{
    Cost, Failure, Precision, Watch, Weight, conclude, exit_code, parse_with_presets, record,
    remove_leftovers,
};
use mps_kernel::weights::{Rational, WendlandGradient};
use mps_kernel::{Kernel, Real};
use observe::Observer;
use options::Options;
use run::Run;
use std::process::ExitCode;

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

/// What a run writes beside its table and its log, which it begins anew in any case (`remove_leftovers`).
const WRITTEN: &[&str] = &[
    "summary.json",
    "gate.png",
    "film.png",
    "snapshot_#ms.png",
    "fields/walls.pvd",
    "fields/water.pvd",
    "fields/gate.pvd",
];

fn main() -> ExitCode {
    let options = parse_with_presets::<Options>(options::preset);
    let done = match options.common.precision {
        _ if options.print_scene => print(&options),
        Precision::F32 => run_with_weight::<f32>(&options),
        Precision::F64 => run_with_weight::<f64>(&options),
    };
    exit_code(done)
}

fn print(options: &Options) -> Result<(), Failure> {
    let scene = describe::scene(options, &options.settings()?)?;
    print_scene("elastic-gate", scene, &options.common)
}

fn run_with_weight<T: Real>(options: &Options) -> Result<(), Failure> {
    match options.weight {
        Weight::Smooth => run::<T, _>(options, WendlandGradient),
        Weight::Rational => run::<T, _>(options, Rational),
    }
}

fn run<T: Real, K: Kernel<T>>(options: &Options, weight: K) -> Result<(), Failure> {
    let settings = options.settings()?;
    let earlier = options.beside.iter().map(|dir| Earlier::read(dir)).collect::<Result<Vec<_>, _>>()?;
    let parallel = options.common.parallel()?;
    let dir = options.common.output("elastic-gate")?;
    let mut scene = setup::build::<T, K>(&settings, weight, &parallel)?;
    remove_leftovers(&dir, WRITTEN)?;
    let mut observer = Observer::new(&dir, &scene, settings.across, &parallel)?;
    let fields = if options.common.no_fields {
        None
    } else {
        let title = format!("Dam break through an elastic gate, {}", options.material.name());
        Some(Fields::new(&dir, title, &scene)?)
    };
    let (end, watch, mut seconds) = (settings.end_time, Watch::begin(&dir, &options.common)?, 0.0);
    // Inside the pool the loops of a step need no hand-over between threads.
    let done = parallel.install(|| {
        record(&mut Run::new(&mut scene, &mut observer, fields, &parallel), end, &watch, &mut seconds)
    });

    // Whatever happened, what has been computed is kept.
    report::plot(&dir, options, &observer, &earlier)?;
    let cost = Cost {
        threads: parallel.threads(),
        steps: scene.fluid().steps(),
        seconds,
        simulated: scene.fluid().time().to_double(),
        particles: scene.fluid().particles().position.len(),
    };
    let summary = report::summary(options, &settings, &scene, &observer, &cost, done.as_ref().err());
    conclude(&dir, &summary, &options.common, done.is_ok())?;
    done
}
