//! Case 3: the flag of Turek and Hron (2006) behind a cylinder in a channel, rigid or elastic, from geometry to drag, lift and
//! the motion of its end.

mod describe;
mod fields;
mod geometry;
mod observe;
mod options;
mod reference;
mod report;
mod run;
mod setup;

use fields::Fields;
use mps_examples::scene::print_scene;
use mps_examples::{
    Cost, Failure, Precision, Watch, conclude, exit_code, parse_with_presets, record, remove_leftovers,
};
use mps_kernel::Real;
use observe::Observer;
use options::Options;
use run::Run;
use std::process::ExitCode;

/// What a run writes beside its table and its log, which it begins anew in any case (`remove_leftovers`).
const WRITTEN: &[&str] = &[
    "summary.json",
    "drag.png",
    "lift.png",
    "ux.png",
    "uy.png",
    "film.png",
    "snapshot_#ms.png",
    "fields/walls.pvd",
    "fields/cylinder.pvd",
    "fields/water.pvd",
    "fields/flag.pvd",
];

fn main() -> ExitCode {
    let options = parse_with_presets::<Options>(options::preset);
    exit_code(match options.common.precision {
        _ if options.print_scene => print(&options),
        Precision::F32 => run::<f32>(&options),
        Precision::F64 => run::<f64>(&options),
    })
}

fn print(options: &Options) -> Result<(), Failure> {
    print_scene("turek-hron", describe::scene(&options.settings()?), &options.common)
}

fn run<T: Real>(options: &Options) -> Result<(), Failure> {
    let settings = options.settings()?;
    let parallel = options.common.parallel()?;
    let dir = options.common.output(&format!("turek-hron-{}", settings.test.name()))?;
    let mut scene = setup::build::<T>(&settings, &parallel)?;
    remove_leftovers(&dir, WRITTEN)?;
    let mut observer = Observer::new(&dir, settings.level(), &scene)?;
    let fields = if options.common.no_fields { None } else { Some(Fields::new(&dir, &settings, &scene)?) };
    let (end, watch, mut seconds) = (settings.end_time, Watch::begin(&dir, &options.common)?, 0.0);
    // Inside the pool the loops of a step need no hand-over between threads.
    let done = parallel.install(|| {
        let mut run = Run::new(&mut scene, &mut observer, fields, &settings, &parallel);
        record(&mut run, end, &watch, &mut seconds)
    });

    // Whatever happened, what has been computed is kept.
    report::plots(&dir, &settings, &observer)?;
    let cost = Cost {
        threads: parallel.threads(),
        steps: scene.fluid().steps(),
        seconds,
        simulated: scene.fluid().time().to_double(),
        particles: scene.fluid().particles().position.len(),
    };
    let mut summary = report::summary(&settings, &scene, &observer);
    cost.enter(&mut summary, &options.common, done.as_ref().err());
    conclude(&dir, &summary, &options.common, done.is_ok())?;
    done
}
