//! A run of a scene, from its beginning or from a checkpoint.

use super::dimension::AnyLayout;
use super::fields::Fields;
use super::keeper::Keeper;
use super::lock::Lock;
use super::observer::Observer;
use super::probes::Probe;
use super::resume::checkpoints;
use super::watch::{Guard, PostMortem};
use super::watched::Watched;
use super::{Layout, World, leftovers, report};
use crate::{Common, Cost, Failure, Precision, Watch, conclude, enter_compressibility, record};
use mps_io::checkpoint::{Identity, Rotation};
use mps_io::scene_file::{SceneFile, Weight};
use mps_kernel::weights::{Rational, WendlandC2, WendlandGradient};
use mps_kernel::{Kernel, Real, State};
use std::path::Path;

/// Name and version that a checkpoint has to be of.
pub(super) const PROGRAM: &str = concat!("mps ", env!("CARGO_PKG_VERSION"));

/// The scene as it is run, beside its results.
const KEPT: &str = "scene.toml";

/// What is to be run, and how.
pub(super) struct Plan<'a> {
    pub(super) scene: &'a SceneFile,
    pub(super) name: &'a str,
    /// With the directory of the results.
    pub(super) common: &'a Common,
    /// The simulated time at which it ends \[s\].
    pub(super) end: f64,
    /// Wall time between two checkpoints \[s\], 0 for none.
    pub(super) interval: f64,
    pub(super) rotation: Rotation,
}

/// A state to go on from, and the file it was in.
pub(super) type Origin<'a> = Option<(&'a State, &'a Path)>;

/// As [`Examined::run`](super::Examined::run).
pub(super) fn begin(
    (scene, file): (&SceneFile, &Path),
    layout: &AnyLayout,
    name: &str,
    common: &Common,
    interval: f64,
) -> Result<(), Failure> {
    let mut common = common.clone();
    common.out = common.out.or_else(|| scene.output.directory.as_ref().map(Into::into));
    let dir = common.output(name)?;
    spare(file, &dir)?;
    let rotation = Rotation::new(checkpoints(&dir));
    layout.run_plan(Plan { scene, name, common: &common, end: scene.end_time, interval, rotation }, None)
}

/// Refuses to write the scene as it is run over the one that somebody wrote, with comments and a layout of its own.
fn spare(file: &Path, dir: &Path) -> Result<(), Failure> {
    let kept = dir.join(KEPT);
    match (file.canonicalize(), kept.canonicalize()) {
        (Ok(file), Ok(kept)) if file == kept => Err(format!(
            "the run would replace its scene {} by the same with every default written out: give another --out, or another name \
             to the scene",
            kept.display()
        )
        .into()),
        _ => Ok(()),
    }
}

/// Makes room for a run that begins, which has nothing to do with what an earlier one has left here. Returns the scene as it is
/// beside its results.
fn anew(scene: &SceneFile, dir: &Path, rotation: &Rotation) -> Result<SceneFile, Failure> {
    rotation.clear()?;
    PostMortem::clear(dir)?;
    leftovers::remove(dir)?;
    Ok(scene.write_to(dir)?)
}

pub(super) fn run_plan<const D: usize>(
    plan: Plan<'_>,
    layout: &Layout<D>,
    from: Origin<'_>,
) -> Result<(), Failure> {
    match plan.common.precision {
        Precision::F32 => with_weight::<f32, D>(plan, layout, from),
        Precision::F64 => with_weight::<f64, D>(plan, layout, from),
    }
}

fn with_weight<T: Real, const D: usize>(
    plan: Plan<'_>,
    layout: &Layout<D>,
    from: Origin<'_>,
) -> Result<(), Failure> {
    match plan.scene.fluid.as_ref().map(|fluid| fluid.numerics.weight) {
        Some(Weight::Rational) => whole::<T, D, _>(plan, layout, Rational, from),
        Some(Weight::Wendland) => whole::<T, D, _>(plan, layout, WendlandC2, from),
        // Without a fluid any weight will do.
        Some(Weight::Smooth) | None => whole::<T, D, _>(plan, layout, WendlandGradient, from),
    }
}

fn whole<T: Real, const D: usize, K: Kernel<T>>(
    plan: Plan<'_>,
    layout: &Layout<D>,
    weight: K,
    from: Origin<'_>,
) -> Result<(), Failure> {
    let Plan { scene, name, common, end, interval, rotation } = plan;
    let parallel = common.parallel()?;
    // As at the start of the run also where it goes on: what pictures show is found from there.
    let mut world = World::<T, D, K>::new(scene, layout, weight, &parallel)?;
    let probes = Probe::all(scene, &world)?;
    let dir = common.output(name)?;
    let _lock = Lock::take(&dir)?;
    // Only what has come about so far may take the place of an earlier run.
    let scene = &if from.is_some() { scene.clone() } else { anew(scene, &dir, &rotation)? };
    let mut observer = Observer::new(&dir, scene, probes, from.is_some())?;
    let fields = if common.no_fields { None } else { Some(Fields::new(&dir, scene, &world)?) };
    let identity = Identity::new(PROGRAM, common.precision.name(), &scene.to_toml()?);
    let settings = [("name", name), ("fields", if common.no_fields { "no" } else { "yes" })];
    let settings = settings.map(|(key, value)| (key.to_owned(), value.to_owned())).into();
    let mut keeper = Keeper::new(&dir, rotation, identity, settings, interval)?;
    let (watch, mut seconds) = (Watch::kept(&dir, common, from.is_some())?, 0.0);
    let mut guard = Guard::new(&scene.watch);
    // Inside the pool the loops of a step need no hand-over between threads.
    let done = parallel.install(|| -> Result<Result<(), Failure>, Failure> {
        let (stepped, written) = ((&mut world, &parallel), (&mut observer, fields));
        let mut watched = Watched::new(scene, end, stepped, written, &mut keeper, &mut guard);
        // What does not fit leaves the results there are alone.
        if let Some((state, path)) = from {
            let unfit = |error| format!("{} cannot be gone on from: {error}", path.display());
            seconds = watched.restore(state).map_err(unfit)?;
        }
        Ok(record(&mut watched, end, &watch, &mut seconds))
    })?;

    // Whatever happened, what has been computed is kept; a plot that cannot be drawn hides no failure.
    let drawn = report::plots(&dir, &scene.title, &observer.table(), observer.measured);
    let cost = Cost {
        threads: parallel.threads(),
        steps: world.steps(),
        seconds,
        simulated: world.time(),
        particles: world.fluid().map_or(0, |fluid| fluid.particles().position.len()) + layout.solids_len(),
    };
    let mut summary = report::summary(name, scene, layout, &observer);
    summary.notes.extend(guard.notes());
    if let Some(fluid) = world.fluid() {
        enter_compressibility(&mut summary, fluid);
    }
    cost.enter(&mut summary, common, done.as_ref().err());
    conclude(&dir, &summary, common, done.is_ok())?;
    done.and(drawn)
}
