//! A scene that runs, with all that watches it and keeps its state.

mod course;
mod failure;
mod output;

use super::fields::Fields;
use super::keeper::Keeper;
use super::observer::Observer;
use super::watch::{Good, Guard};
use super::{World, units};
use crate::{Failure, Recorded};
use course::{Course, transfer_run};
use mps_io::scene_file::SceneFile;
use mps_kernel::{Kernel, Real, State, Transfer};
use mps_neighbors::Parallel;
use output::Output;
use std::fmt;

/// A scene, its observer, and what is drawn and when.
pub(super) struct Watched<'a, T: Real, const D: usize, K: Kernel<T>> {
    scene: &'a SceneFile,
    course: Course<'a, T, D, K>,
    /// How far the output is.
    output: Output<'a, T, D>,
    keeper: &'a mut Keeper,
    /// The simulated time at which the run is to end \[s\].
    end: f64,
    /// What all steps have taken \[s\].
    stepping: f64,
}

impl<'a, T: Real, const D: usize, K: Kernel<T>> Watched<'a, T, D, K> {
    pub(super) fn new(
        scene: &'a SceneFile,
        end: f64,
        (world, parallel): (&'a mut World<T, D, K>, &'a Parallel),
        (observer, fields): (&'a mut Observer<T, D>, Option<Fields>),
        keeper: &'a mut Keeper,
        guard: &'a mut Guard,
    ) -> Self {
        let output = Output::new(scene, observer, fields);
        let course = Course { world, guard, parallel, last_step: 0.0 };
        Self { scene, course, output, keeper, end, stepping: 0.0 }
    }

    /// Brings back what was saved, and says what all steps until then have taken \[s\].
    pub(super) fn restore(&mut self, state: &State) -> Result<f64, Failure> {
        state.restore(|transfer| self.transfer(transfer))?;
        let Course { world, guard, .. } = &mut self.course;
        guard.apply_pace(world)?;
        self.keeper.went_on_from(world.time());
        Ok(self.stepping)
    }

    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { scene: _, course, output, keeper: _, end: _, stepping } = self;
        transfer_run(course, output, stepping, transfer);
    }

    /// Writes a checkpoint. The state is that before anything has been written of it.
    fn save(&mut self) -> Result<(), Failure> {
        self.output.sync()?;
        let state = State::save(|transfer| self.transfer(transfer))?;
        self.keeper.write(state, self.course.world.time())
    }

    /// Keeps the present state in memory, if the guard wants it.
    fn keep_good(&mut self) -> Result<(), Failure> {
        let Course { world, guard, .. } = &mut self.course;
        guard.recover(world)?;
        let steps = world.count();
        if guard.wants_state(steps) {
            let course = State::save(|transfer| self.course.transfer(transfer))?;
            let output = State::save(|transfer| self.output.transfer(transfer))?;
            self.course.guard.keep(Good { course, output, steps });
        }
        Ok(())
    }
}

impl<T: Real, const D: usize, K: Kernel<T>> Recorded for Watched<'_, T, D, K> {
    fn time(&self) -> f64 {
        self.course.world.time()
    }

    fn steps(&self) -> u64 {
        self.course.world.steps()
    }

    fn last_step(&self) -> f64 {
        self.course.last_step
    }

    fn keep(&mut self, dt: f64, stepping: f64, last: bool) -> Result<(), Failure> {
        (self.course.last_step, self.stepping) = (dt, stepping);
        let stop = self.keeper.is_stopped();
        if stop || last || self.keeper.is_due() {
            self.save().map_err(|failure| self.keeper.failed(failure))?;
        }
        if stop && !last { Err(self.keeper.interrupted().into()) } else { Ok(()) }
    }

    /// The state is good whatever becomes of the output: when a disk is full it is kept, if there is room.
    fn look(&mut self, dt: f64, last: bool) -> Result<(), Failure> {
        let time = self.time();
        if !last && !self.output.due.iter().any(|due| due.has_come(time)) {
            return Ok(());
        }
        let before = State::save(|transfer| self.output.transfer(transfer))?;
        let Course { world, parallel, .. } = &mut self.course;
        self.output.write(world, parallel, [time, dt], last).map_err(|failure| {
            let back = before.restore(|transfer| self.output.transfer(transfer));
            if back.is_ok() {
                // What could not be written is the reason to report, not that the checkpoint could not either.
                let _ = self.save();
            }
            self.keeper.failed(failure)
        })
    }

    fn step(&mut self) -> Result<f64, Failure> {
        self.keep_good()?;
        let step = self.course.step().or_else(|failure| self.go_back(failure));
        step.map_err(|failure| self.keeper.failed(failure))
    }

    /// It has been kept where the failure was examined, which leads elsewhere.
    fn keep_wreck(&mut self) -> Result<(), Failure> {
        Ok(())
    }

    fn remark(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let world = &self.course.world;
        let (fluid, bodies) = world.energy(self.course.parallel);
        let energy = (fluid.total() + bodies.total()).to_double();
        write!(f, "{} sub-steps, energy {energy:.4e} {}", world.substeps(), units::energy::<D>())
    }
}
