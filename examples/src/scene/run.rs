//! A run of a scene, with everything that watches it.

use super::fields::Fields;
use super::observer::Observer;
use super::{Layout, World, report};
use crate::{Common, Cost, Due, Failure, Precision, Recorded, conclude, record};
use mps_io::scene_file::{SceneFile, Weight};
use mps_kernel::weights::{Rational, WendlandGradient};
use mps_kernel::{Kernel, Real};
use mps_neighbors::Parallel;
use std::fmt;

/// Runs a scene that has been found good, and writes its results to the directory of `common`, else to that of the
/// scene, else to `out/<name>`.
///
/// # Errors
/// What breaks the run off. What has been computed until then is kept.
pub fn run(scene: &SceneFile, layout: &Layout, name: &str, common: &Common) -> Result<(), Failure> {
    match common.precision {
        Precision::F32 => with_weight::<f32>(scene, layout, name, common),
        Precision::F64 => with_weight::<f64>(scene, layout, name, common),
    }
}

fn with_weight<T: Real>(
    scene: &SceneFile,
    layout: &Layout,
    name: &str,
    common: &Common,
) -> Result<(), Failure> {
    match scene.fluid.as_ref().map(|fluid| fluid.numerics.weight) {
        Some(Weight::Rational) => whole::<T, _>(scene, layout, name, common, Rational),
        // Without a fluid any weight will do.
        Some(Weight::Smooth) | None => whole::<T, _>(scene, layout, name, common, WendlandGradient),
    }
}

fn whole<T: Real, K: Kernel<T>>(
    scene: &SceneFile,
    layout: &Layout,
    name: &str,
    common: &Common,
    weight: K,
) -> Result<(), Failure> {
    let parallel = common.parallel()?;
    let mut world = World::<T, K>::new(scene, layout, weight, &parallel)?;
    let mut common = common.clone();
    common.out = common.out.or_else(|| scene.output.directory.as_ref().map(Into::into));
    let dir = common.output(name)?;
    // The scene as it is run, beside its results.
    std::fs::write(dir.join("scene.toml"), scene.to_toml()?)?;
    let mut observer = Observer::new(&dir, scene, &world)?;
    let fields = if common.no_fields { None } else { Some(Fields::new(&dir, scene, &world)?) };
    let (end, quiet, mut seconds) = (scene.end_time, common.quiet, 0.0);
    // Inside the pool the loops of a step need no hand-over between threads.
    let done = parallel.install(|| {
        let mut watched = Watched::new(scene, &mut world, &mut observer, fields, &parallel);
        record(&mut watched, end, quiet, &mut seconds)
    });

    // Whatever happened, what has been computed is kept.
    report::plots(&dir, scene, &observer)?;
    let cost = Cost {
        threads: parallel.threads(),
        steps: world.steps(),
        seconds,
        simulated: world.time(),
        particles: layout.fluid_len() + layout.solids_len(),
    };
    let mut summary = report::summary(name, scene, layout, &observer);
    cost.enter(&mut summary, &common, done.as_ref().err());
    conclude(&dir, &summary, &common, done.is_ok())?;
    done
}

/// A scene, its observer, and what is drawn and when.
struct Watched<'a, T: Real, K: Kernel<T>> {
    world: &'a mut World<T, K>,
    observer: &'a mut Observer<T>,
    fields: Option<Fields>,
    parallel: &'a Parallel,
    probe: Due,
    frame: Due,
    field: Due,
    picture: Due,
}

impl<'a, T: Real, K: Kernel<T>> Watched<'a, T, K> {
    fn new(
        scene: &SceneFile,
        world: &'a mut World<T, K>,
        observer: &'a mut Observer<T>,
        fields: Option<Fields>,
        parallel: &'a Parallel,
    ) -> Self {
        // Never is later than every end.
        let due = |interval: f64| if interval > 0.0 { Due::every(interval) } else { Due::never() };
        let [probe, frame, field, picture] = scene.output.intervals(scene.end_time).map(due);
        Self { world, observer, fields, parallel, probe, frame, field, picture }
    }
}

impl<T: Real, K: Kernel<T>> Recorded for Watched<'_, T, K> {
    fn time(&self) -> f64 {
        self.world.time()
    }

    fn steps(&self) -> u64 {
        self.world.steps()
    }

    fn look(&mut self, dt: f64, last: bool) -> Result<(), Failure> {
        let time = self.time();
        if self.probe.is_due(time) || last {
            self.observer.record(self.world, self.parallel, dt)?;
        }
        if let Some(fields) = &mut self.fields {
            if self.field.is_due(time) {
                fields.write(self.world, self.parallel)?;
            }
            let due = [self.frame.is_due(time), self.picture.is_due(time)];
            if due.contains(&true) {
                fields.draw(self.world, due)?;
            }
        }
        Ok(())
    }

    fn step(&mut self) -> Result<f64, Failure> {
        self.world.step(self.parallel)
    }

    fn keep_wreck(&mut self) -> Result<(), Failure> {
        if let Some(fields) = &mut self.fields {
            fields.write(self.world, self.parallel)?;
            fields.draw(self.world, [false, true])?;
        }
        Ok(())
    }

    fn remark(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} sub-steps", self.world.substeps())
    }
}
