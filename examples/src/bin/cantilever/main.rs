//! Case 1: the free vibration of a clamped plate, from geometry to a curve against beam theory and finite elements.

mod convergence;
mod describe;
mod options;
mod report;

use mps_examples::scene::print_scene;
use mps_examples::solid::plate::{LENGTH, PERIOD, THICKNESS, moduli, plate, unit_of_time};
use mps_examples::solid::{Look, Motion, Pictures};
use mps_examples::{
    Failure, Precision, Watch, conclude, exit_code, parse_with_presets, record, remove_leftovers,
};
use mps_io::{Summary, View};
use mps_kernel::{Real, Vector};
use mps_solid::ConstitutiveModel;
use mps_solid::materials::{CorotationalHooke, NeoHookean, SaintVenantKirchhoff};
use options::{Material, Options};
use std::path::Path;
use std::process::ExitCode;

/// Rows of probes.csv in a period.
const SAMPLES: f64 = 400.0;
/// Frames of the film in a period.
const FRAMES: f64 = 40.0;

/// What a run writes beside its table and its log, which it begins anew in any case (`remove_leftovers`).
const WRITTEN: &[&str] = &[
    "summary.json",
    "tip.png",
    "energy.png",
    "energy_error.png",
    "film.png",
    "stress_up.png",
    "stress_down.png",
    "stress_wreck.png",
    "fields/body.pvd",
];

fn main() -> ExitCode {
    exit_code(run_all(&parse_with_presets::<Options>(options::preset)))
}

fn run_all(options: &Options) -> Result<(), Failure> {
    let across = options.check()?;
    if options.print_scene {
        return print_scene("cantilever", describe::scene(options, across)?, &options.common);
    }
    let dir = options.common.output("cantilever")?;
    if options.convergence {
        return convergence::compare(options, &dir, |across, dir| run_with_precision(options, across, dir));
    }
    let (summary, done) = run_with_precision(options, across, &dir)?;
    conclude(&dir, &summary, &options.common, done.is_ok())?;
    done
}

/// The results of a run and how it ended.
type Ended = (Summary, Result<(), Failure>);

fn run_with_precision(options: &Options, across: usize, dir: &Path) -> Result<Ended, Failure> {
    match options.common.precision {
        Precision::F32 => run_with_material::<f32>(options, across, dir),
        Precision::F64 => run_with_material::<f64>(options, across, dir),
    }
}

fn run_with_material<T: Real>(options: &Options, across: usize, dir: &Path) -> Result<Ended, Failure> {
    let moduli = moduli::<T>()?;
    match options.material {
        Material::Corotational => run(options, across, dir, CorotationalHooke::from(moduli)),
        Material::SaintVenant => run(options, across, dir, SaintVenantKirchhoff::from(moduli)),
        Material::NeoHookean => run(options, across, dir, NeoHookean::from(moduli)),
    }
}

fn run<T: Real, M: ConstitutiveModel<T, 2>>(
    options: &Options,
    across: usize,
    dir: &Path,
    material: M,
) -> Result<Ended, Failure> {
    let parallel = options.common.parallel()?;
    let (solid, tip) = plate(across, material, options.config(), &parallel)?;
    remove_leftovers(dir, WRITTEN)?;
    let pictures = if options.common.no_fields { None } else { Some(Pictures::new(dir, look(across))?) };
    let interval = PERIOD * unit_of_time() / SAMPLES;
    let mut motion = Motion::new(solid, tip, Vector::zeros(), interval, &parallel)?
        .with_table(dir)?
        .with_pictures(pictures);
    let (end, watch, mut seconds) = (options.end_time(), Watch::begin(dir, &options.common)?, 0.0);
    // Inside the pool the loops of a step need no hand-over between threads.
    let done = parallel.install(|| record(&mut motion, end, &watch, &mut seconds));

    // Whatever happened, what has been computed is kept.
    report::plot(dir, across, motion.samples())?;
    let cost = motion.cost(seconds);
    let summary = report::summary(options, across, &motion, &cost, done.as_ref().err());
    Ok((summary, done))
}

/// The film, and pictures of the first two extremes.
fn look(across: usize) -> Look {
    let period = PERIOD * unit_of_time();
    Look {
        title: format!("Vibrating plate, {across} particles across"),
        view: View::new([-0.01, -0.025], [LENGTH + 0.01, THICKNESS + 0.025]),
        outline: vec![[0.0, -0.025], [0.0, THICKNESS + 0.025]],
        stress: 100.0,
        frame: period / FRAMES,
        stills: vec![("up", 0.25 * period), ("down", 0.75 * period)],
    }
}
