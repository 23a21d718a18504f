//! A scene that runs, with all that watches it and keeps its state.

use super::World;
use super::fields::Fields;
use super::keeper::Keeper;
use super::observer::Observer;
use crate::{Due, Failure, Recorded};
use mps_io::scene_file::SceneFile;
use mps_kernel::{Kernel, Real, State, StateError, Transfer};
use mps_neighbors::Parallel;
use std::fmt;

/// A scene, its observer, and what is drawn and when.
pub(super) struct Watched<'a, T: Real, K: Kernel<T>> {
    world: &'a mut World<T, K>,
    /// How far the output is.
    output: Output<'a, T>,
    parallel: &'a Parallel,
    keeper: &'a mut Keeper,
    /// Length of the step that led here \[s\].
    last_step: f64,
    /// What all steps have taken \[s\].
    stepping: f64,
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

impl<'a, T: Real, K: Kernel<T>> Watched<'a, T, K> {
    pub(super) fn new(
        scene: &SceneFile,
        world: &'a mut World<T, K>,
        observer: &'a mut Observer<T>,
        fields: Option<Fields>,
        parallel: &'a Parallel,
        keeper: &'a mut Keeper,
    ) -> Self {
        // Never is later than every end.
        let due = |interval: f64| if interval > 0.0 { Due::every(interval) } else { Due::never() };
        let due = scene.output.intervals(scene.end_time).map(due);
        let output = Output { observer, fields, due };
        Self { world, output, parallel, keeper, last_step: 0.0, stepping: 0.0 }
    }

    /// Brings back what was saved, and says what all steps until then have taken \[s\].
    pub(super) fn restore(&mut self, state: &State) -> Result<f64, StateError> {
        state.restore(|transfer| self.transfer(transfer))?;
        self.keeper.went_on_from(self.world.time());
        Ok(self.stepping)
    }

    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { world, output, parallel, keeper: _, last_step, stepping } = self;
        world.transfer(parallel, transfer);
        transfer.within("output", |transfer| output.transfer(transfer));
        transfer.value("last step", last_step);
        transfer.value("wall time", stepping);
    }

    /// Writes a checkpoint. The state is that before anything has been written of it.
    fn save(&mut self) -> Result<(), Failure> {
        self.output.sync()?;
        let state = State::save(|transfer| self.transfer(transfer))?;
        let time = self.world.time();
        self.keeper.write(state, time)
    }

    fn write(&mut self, time: f64, dt: f64, last: bool) -> Result<(), Failure> {
        let Output { observer, fields, due: [probe, frame, field, picture] } = &mut self.output;
        if probe.is_due(time) || last {
            observer.record(self.world, self.parallel, dt)?;
        }
        if let Some(fields) = fields {
            if field.is_due(time) {
                fields.write(self.world, self.parallel)?;
            }
            let due = [frame.is_due(time), picture.is_due(time)];
            if due.contains(&true) {
                fields.draw(self.world, due)?;
            }
        }
        Ok(())
    }
}

impl<T: Real, K: Kernel<T>> Recorded for Watched<'_, T, K> {
    fn time(&self) -> f64 {
        self.world.time()
    }

    fn steps(&self) -> u64 {
        self.world.steps()
    }

    fn last_step(&self) -> f64 {
        self.last_step
    }

    fn keep(&mut self, dt: f64, stepping: f64, last: bool) -> Result<(), Failure> {
        (self.last_step, self.stepping) = (dt, stepping);
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
        self.world.step(self.parallel).map_err(|failure| self.keeper.failed(failure))
    }

    fn keep_wreck(&mut self) -> Result<(), Failure> {
        if let Some(fields) = &mut self.output.fields {
            fields.write(self.world, self.parallel)?;
            fields.draw(self.world, [false, true])?;
        }
        Ok(())
    }

    fn remark(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (fluid, bodies) = self.world.energy(self.parallel);
        let energy = (fluid.total() + bodies.total()).to_double();
        write!(f, "{} sub-steps, energy {energy:.4e} J/m", self.world.substeps())
    }
}
