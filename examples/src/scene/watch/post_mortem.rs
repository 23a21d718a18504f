//! What is found out about a failure, and where it is written.

use super::super::World;
use super::alarm::Alarm;
use super::particle::Particle;
use super::{Guard, picture, report};
use crate::Failure;
use mps_kernel::{Kernel, Real};
use mps_neighbors::Parallel;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// A run that has failed, with its post-mortem.
#[derive(Debug, Error)]
#[error(
    "{source}\nWhat acted on the particle, its neighbours and the last steps are told in {}; `mps resume {}{end}` goes through the failure again",
    dir.join("report.md").display(),
    dir.display()
)]
pub(in crate::scene) struct Dissected {
    pub(in crate::scene) source: Failure,
    /// Of the post-mortem.
    pub(in crate::scene) dir: PathBuf,
    /// The flag that makes the repetition last as long as this run was to, if its scene does not say so.
    pub(in crate::scene) end: String,
}

/// A failure that is being examined.
pub(in crate::scene) struct PostMortem<'a> {
    failure: &'a Failure,
    particle: Particle,
    /// Steps done before the one that failed.
    failed: u64,
}

impl<'a> PostMortem<'a> {
    /// The directory for that of a run.
    pub(in crate::scene) fn directory(run: &Path) -> PathBuf {
        run.join("post-mortem")
    }

    /// Removes what an earlier run has left.
    ///
    /// # Errors
    /// If the system refuses.
    pub(in crate::scene) fn clear(run: &Path) -> Result<(), Failure> {
        let dir = Self::directory(run);
        if dir.exists() {
            std::fs::remove_dir_all(dir)?;
        }
        Ok(())
    }

    /// Of a failure that has left the world as it is now.
    pub(in crate::scene) fn new<T: Real, const D: usize, K: Kernel<T>>(
        failure: &'a Failure,
        world: &World<T, D, K>,
        guard: &Guard,
    ) -> Self {
        let fastest = guard.ring().steps().last().map_or(Particle::Fluid(0), |step| step.fastest.0);
        Self {
            failure,
            particle: Particle::named_by(failure).unwrap_or(fastest),
            failed: failed(failure, world),
        }
    }

    /// Goes through the failure again, from the good state that the world has been brought back to, and writes what is found out.
    /// Afterwards the world is in the step that failed.
    ///
    /// # Errors
    /// If it does not come again, or something cannot be written.
    pub(in crate::scene) fn write<T: Real, const D: usize, K: Kernel<T>>(
        &self,
        world: &mut World<T, D, K>,
        guard: &Guard,
        parallel: &Parallel,
        title: &str,
        dir: &Path,
    ) -> Result<(), Failure> {
        let from = (world.count(), world.time());
        while world.count() < self.failed {
            world.step(parallel)?;
        }
        let (time, place) = (world.time(), picture::place(world, self.particle));
        world.remember_changes();
        if self.failure.is::<Alarm>() {
            // The step itself had no error: what it begins with is what led there.
            world.begin(parallel)?;
        } else if world.step(parallel).is_ok() {
            return Err("the failure did not come again".into());
        }
        if let Some(place) = place {
            picture::draw(world, place, title, &dir.join("picture.png"))?;
        }
        let step = world.fluid().and_then(|fluid| fluid.explain_step());
        let last = guard.ring().steps().last().map_or(0.0, |step| step.dt);
        let dt = step.map_or(last, |step| step.limits.shortest().1.to_double());
        let Self { failure, particle, failed } = self;
        let about = report::particle(world, *particle, dt);
        let limits = step.map_or("There is no fluid.\n".to_owned(), |step| report::limits(&step));
        let steps = report::steps::<D>(guard.ring());
        let text = format!(
            "# Post-mortem: {title}\n\n{failure}\n\n\
             Step {} failed, from t = {time:e} s. The checkpoint beside this file is of step {}, t = {:e} s; from there on everything comes again, to the \
             last bit.\n\n\
             ![The particle and its surroundings before the step](picture.png)\n\n\
             ## The particle: {particle}\n\n{about}\n## What limits the step\n\n{limits}\n## The last steps\n\n{steps}",
            failed + 1,
            from.0,
            from.1
        );
        Ok(std::fs::write(dir.join("report.md"), text)?)
    }
}

/// Steps done before the one that failed and has left the world as it is now.
pub(super) fn failed<T: Real, const D: usize, K: Kernel<T>>(
    failure: &Failure,
    world: &World<T, D, K>,
) -> u64 {
    // An alarm is raised when the step is done.
    world.count() - u64::from(failure.is::<Alarm>())
}
