//! A scene that runs, with all that watches it and keeps its state.

use super::World;
use super::fields::Fields;
use super::keeper::Keeper;
use super::observer::Observer;
use super::watch::{Dissected, Good, Guard, PostMortem, Setbacks, failed};
use crate::{Due, Failure, Recorded};
use mps_io::scene_file::SceneFile;
use mps_kernel::{Kernel, Real, State, Transfer};
use mps_neighbors::Parallel;
use std::fmt;
use std::path::Path;

/// A scene, its observer, and what is drawn and when.
pub(super) struct Watched<'a, T: Real, K: Kernel<T>> {
    scene: &'a SceneFile,
    course: Course<'a, T, K>,
    /// How far the output is.
    output: Output<'a, T>,
    keeper: &'a mut Keeper,
    /// The simulated time at which the run is to end \[s\].
    end: f64,
    /// What all steps have taken \[s\].
    stepping: f64,
}

/// What is stepped, and who watches over it.
struct Course<'a, T: Real, K: Kernel<T>> {
    world: &'a mut World<T, K>,
    guard: &'a mut Guard,
    parallel: &'a Parallel,
    /// Length of the step that led here \[s\].
    last_step: f64,
}

impl<T: Real, K: Kernel<T>> Course<'_, T, K> {
    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { world, guard, parallel, last_step } = self;
        world.transfer(parallel, transfer);
        transfer.within("watch", |transfer| guard.transfer(transfer));
        transfer.value("last step", last_step);
    }

    /// One step, and a look at what has become of it.
    fn step(&mut self) -> Result<f64, Failure> {
        let dt = self.world.step(self.parallel)?;
        self.guard.look(self.world, self.parallel, dt)?;
        Ok(dt)
    }
}

/// The state of a run.
fn transfer_run<T: Real, K: Kernel<T>>(
    course: &mut Course<'_, T, K>,
    output: &mut Output<'_, T>,
    stepping: &mut f64,
    transfer: &mut Transfer<'_>,
) {
    course.transfer(transfer);
    transfer.within("output", |transfer| output.transfer(transfer));
    transfer.value("wall time", stepping);
}

/// What is written, and when the next of it is due.
struct Output<'a, T: Real> {
    observer: &'a mut Observer<T>,
    fields: Option<Fields>,
    /// Rows, frames of the film, fields, pictures.
    due: [Due; 4],
}

impl<T: Real> Output<'_, T> {
    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { observer, fields, due } = self;
        transfer.within("table", |transfer| observer.transfer(transfer));
        transfer.same("fields", usize::from(fields.is_some()));
        if let Some(fields) = fields {
            transfer.within("fields", |transfer| fields.transfer(transfer));
        }
        due.iter_mut().for_each(|due| due.transfer(transfer));
    }

    /// What has been written outlasts a loss of power, if a checkpoint counts on it.
    fn sync(&self) -> Result<(), Failure> {
        self.observer.sync()?;
        self.fields.as_ref().map_or(Ok(()), Fields::sync)
    }
}

impl<'a, T: Real> Output<'a, T> {
    fn new(scene: &SceneFile, observer: &'a mut Observer<T>, fields: Option<Fields>) -> Self {
        // Never is later than every end.
        let due = |interval: f64| if interval > 0.0 { Due::every(interval) } else { Due::never() };
        Self { observer, fields, due: scene.output.intervals(scene.end_time).map(due) }
    }
}

impl<'a, T: Real, K: Kernel<T>> Watched<'a, T, K> {
    pub(super) fn new(
        scene: &'a SceneFile,
        end: f64,
        (world, parallel): (&'a mut World<T, K>, &'a Parallel),
        (observer, fields): (&'a mut Observer<T>, Option<Fields>),
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

    /// Goes back and on with shorter steps, if the scene says so; else the run stops.
    fn go_back(&mut self, failure: Failure) -> Result<f64, Failure> {
        let Some(good) = self.course.guard.take_good() else { return Err(failure) };
        let Course { world, guard, .. } = &self.course;
        let Some(setbacks) = guard.setback(failed(&failure, world), good.steps, world.substeps()) else {
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
        std::fs::write(dir.join("scene.toml"), self.scene.to_toml()?)?;
        // The repetition has a table of its own, which begins here, and no fields.
        let mut observer = Observer::new(dir, self.scene, self.course.world, false)?;
        let mut output = Output::new(self.scene, &mut observer, None);
        let (course, stepping) = (&mut self.course, &mut self.stepping);
        let state = State::save(|transfer| transfer_run(course, &mut output, stepping, transfer))?;
        self.keeper.write_apart(dir, state)?;
        let Course { world, guard, parallel, .. } = &mut self.course;
        guard.remember(memory);
        guard.apply_pace(world)?;
        found.write(world, guard, parallel, &self.scene.title, dir)
    }

    fn write(&mut self, time: f64, dt: f64, last: bool) -> Result<(), Failure> {
        let Output { observer, fields, due: [probe, frame, field, picture] } = &mut self.output;
        if probe.is_due(time) || last {
            observer.record(self.course.world, self.course.parallel, dt)?;
        }
        if let Some(fields) = fields {
            if field.is_due(time) {
                fields.write(self.course.world, self.course.parallel)?;
            }
            let due = [frame.is_due(time), picture.is_due(time)];
            if due.contains(&true) {
                fields.draw(self.course.world, due)?;
            }
        }
        Ok(())
    }
}

impl<T: Real, K: Kernel<T>> Recorded for Watched<'_, T, K> {
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
        self.write(time, dt, last).map_err(|failure| {
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
        write!(f, "{} sub-steps, energy {energy:.4e} J/m", world.substeps())
    }
}
