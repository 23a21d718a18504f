//! What becomes of a run that fails: it goes back, or it is examined.

use super::Watched;
use super::course::{Course, transfer_run};
use super::output::Output;
use crate::Failure;
use crate::scene::observer::Observer;
use crate::scene::probes::Probe;
use crate::scene::watch::{Dissected, Good, PostMortem, Setbacks};
use mps_kernel::{Kernel, Real, State};
use std::path::Path;

impl<T: Real, const D: usize, K: Kernel<T>> Watched<'_, T, D, K> {
    /// Goes back and on with shorter steps, if the scene says so; else the run stops.
    pub(super) fn go_back(&mut self, failure: Failure) -> Result<f64, Failure> {
        let Some(good) = self.course.guard.take_good() else { return Err(failure) };
        let Course { world, guard, .. } = &self.course;
        let Some(setbacks) = guard.setback(&failure, world, good.steps) else {
            return Err(self.stop(failure, &good));
        };
        self.return_to(good, setbacks, &failure).map_err(|error| {
            format!("{failure}\nGoing back to a good state has failed as well: {error}").into()
        })
    }

    /// Brings a good state back and goes on from it with shorter steps.
    fn return_to(&mut self, good: Good, setbacks: Setbacks, failure: &Failure) -> Result<f64, Failure> {
        good.course.restore(|transfer| self.course.transfer(transfer))?;
        good.output.restore(|transfer| self.output.transfer(transfer))?;
        let Course { world, guard, last_step, .. } = &mut self.course;
        guard.begin_again(world, good, setbacks, failure)?;
        let last_step = *last_step;
        // The checkpoint there may be knows of rows that are gone now.
        self.save()?;
        Ok(last_step)
    }

    /// What a run leaves behind that has failed for good. Nothing that goes wrong here may hide the failure.
    fn stop(&mut self, failure: Failure, good: &Good) -> Failure {
        let wreck = self.write_wreck();
        let dir = PostMortem::directory(self.keeper.directory());
        let told = wreck.and_then(|()| self.dissect(&failure, good, &dir));
        if let Err(error) = told {
            return format!("{failure}\nThe post-mortem is not complete: {error}").into();
        }
        let longer = self.end > self.scene.end_time;
        let end = if longer { format!(" --end-time {:e}", self.end) } else { String::new() };
        Dissected { source: failure, dir, end }.into()
    }

    /// The fields and the picture of what has become of it.
    fn write_wreck(&mut self) -> Result<(), Failure> {
        let Course { world, parallel, .. } = &mut self.course;
        if let Some(fields) = &mut self.output.fields {
            fields.write(world, parallel)?;
            fields.draw(world, [false, true])?;
        }
        Ok(())
    }

    /// Writes a checkpoint of the last good state to a directory of its own, where it can be gone on from, and the report.
    fn dissect(&mut self, failure: &Failure, good: &Good, dir: &Path) -> Result<(), Failure> {
        let found = PostMortem::new(failure, self.course.world, self.course.guard);
        let memory = self.course.guard.memory();
        good.course.restore(|transfer| self.course.transfer(transfer))?;
        PostMortem::clear(self.keeper.directory())?;
        mps_io::prepare_output(dir)?;
        self.scene.write_to(dir)?;
        // The repetition has a table of its own, which begins here, and no fields.
        let probes = Probe::all(self.scene, self.course.world)?;
        let mut observer = Observer::new(dir, self.scene, probes, false)?;
        let mut output = Output::new(self.scene, &mut observer, None);
        let (course, stepping) = (&mut self.course, &mut self.stepping);
        let state = State::save(|transfer| transfer_run(course, &mut output, stepping, transfer))?;
        self.keeper.write_apart(dir, state)?;
        let Course { world, guard, parallel, .. } = &mut self.course;
        guard.remember(memory);
        guard.apply_pace(world)?;
        found.write(world, guard, parallel, &self.scene.title, dir)
    }
}
