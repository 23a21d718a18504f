//! Case 2: the dam break of Lobovsky et al. (2014), from the column of water to the pressure on the wall
//! against a hundred experiments.

mod describe;
mod fields;
mod metrics;
mod observe;
mod options;
mod outline;
mod reference;
mod report;
mod run;
mod sensors;
mod setup;
mod stabilisers;

use fields::Fields;
use mps_examples::scene::print_scene;
use mps_examples::{
    Cost, Failure, Precision, Watch, Weight, conclude, exit_code, parse_with_presets, record,
    remove_leftovers,
};
use mps_io::Summary;
use mps_kernel::weights::{Rational, WendlandGradient};
use mps_kernel::{Kernel, Real};
use observe::Observer;
use options::Options;
use run::Run;
use setup::DamBreak;
use std::process::ExitCode;

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

/// What a run writes beside its table and its log, which it begins anew in any case (`remove_leftovers`).
const WRITTEN: &[&str] = &[
    "summary.json",
    "front.png",
    "energy.png",
    "pressure_#.png",
    "film.png",
    "snapshot_t#.png",
    "jet_t#.png",
    "fields/walls.pvd",
    "fields/water.pvd",
];

fn main() -> ExitCode {
    exit_code(run_all(&parse_with_presets::<Options>(options::preset)))
}

fn run_all(options: &Options) -> Result<(), Failure> {
    if options.print_scene {
        let scene = describe::scene(options, &options.settings()?)?;
        return print_scene("dam-break", scene, &options.common);
    }
    if !options.stabilisers {
        let (_, done) = run_with_precision(options)?;
        return done;
    }
    options.settings()?;
    let dir = options.common.out.clone().unwrap_or_else(|| "out/stabilisers".into());
    stabilisers::compare(options, &dir, run_with_precision)
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
    remove_leftovers(&dir, WRITTEN)?;
    let mut observer = Observer::new(&dir, &mut dam, &parallel)?;
    let fields = if options.common.no_fields { None } else { Some(Fields::new(&dir, &dam)?) };
    let (end, watch, mut seconds) = (settings.end_time, Watch::begin(&dir, &options.common)?, 0.0);
    // Inside the pool the loops of a step need no hand-over between threads.
    let done = parallel.install(|| {
        record(&mut Run::new(&mut dam, &mut observer, fields, &parallel), end, &watch, &mut seconds)
    });

    // Whatever happened, what has been computed is kept.
    report::plot(&dir, options, &observer)?;
    let cost = Cost {
        threads: parallel.threads(),
        steps: dam.fluid().steps(),
        seconds,
        simulated: dam.fluid().time().to_double(),
        particles: dam.fluid().particles().position.len(),
    };
    let summary = report::summary(options, &settings, &dam, &observer, &cost, done.as_ref().err());
    conclude(&dir, &summary, &options.common, done.is_ok())?;
    Ok((summary, done))
}
