//! What a run writes, and when.

use crate::scene::World;
use crate::scene::fields::Fields;
use crate::scene::observer::Observer;
use crate::{Due, Failure};
use mps_io::scene_file::SceneFile;
use mps_kernel::{Kernel, Real, Transfer};
use mps_neighbors::Parallel;

/// What is written, and when the next of it is due.
pub(super) struct Output<'a, T: Real, const D: usize> {
    pub(super) observer: &'a mut Observer<T, D>,
    pub(super) fields: Option<Fields>,
    /// Rows, frames of the film, fields, pictures.
    pub(super) due: [Due; 4],
}

impl<T: Real, const D: usize> Output<'_, T, D> {
    pub(super) fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { observer, fields, due } = self;
        transfer.within("table", |transfer| observer.transfer(transfer));
        transfer.same("fields", usize::from(fields.is_some()));
        if let Some(fields) = fields {
            transfer.within("fields", |transfer| fields.transfer(transfer));
        }
        due.iter_mut().for_each(|due| due.transfer(transfer));
    }

    /// What has been written outlasts a loss of power, if a checkpoint counts on it.
    pub(super) fn sync(&self) -> Result<(), Failure> {
        self.observer.sync()?;
        self.fields.as_ref().map_or(Ok(()), Fields::sync)
    }

    /// What is due at `time` \[s\], after a step of `dt` \[s\]; a row in any case if it is the `last`.
    pub(super) fn write<K: Kernel<T>>(
        &mut self,
        world: &mut World<T, D, K>,
        parallel: &Parallel,
        [time, dt]: [f64; 2],
        last: bool,
    ) -> Result<(), Failure> {
        let Self { observer, fields, due: [probe, frame, field, picture] } = self;
        if probe.is_due(time) || last {
            observer.record(world, parallel, dt)?;
        }
        if let Some(fields) = fields {
            if field.is_due(time) {
                fields.write(world, parallel)?;
            }
            let due = [frame.is_due(time), picture.is_due(time)];
            if due.contains(&true) {
                fields.draw(world, due)?;
            }
        }
        Ok(())
    }
}

impl<'a, T: Real, const D: usize> Output<'a, T, D> {
    pub(super) fn new(scene: &SceneFile, observer: &'a mut Observer<T, D>, fields: Option<Fields>) -> Self {
        // Never is later than every end.
        let due = |interval: f64| if interval > 0.0 { Due::every(interval) } else { Due::never() };
        Self { observer, fields, due: scene.output.intervals(scene.end_time).map(due) }
    }
}
