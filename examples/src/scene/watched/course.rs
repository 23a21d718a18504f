//! What is stepped, and the whole state of a run.

use super::output::Output;
use crate::Failure;
use crate::scene::World;
use crate::scene::watch::Guard;
use mps_kernel::{Kernel, Real, Transfer};
use mps_neighbors::Parallel;

/// What is stepped, and who watches over it.
pub(super) struct Course<'a, T: Real, const D: usize, K: Kernel<T>> {
    pub(super) world: &'a mut World<T, D, K>,
    pub(super) guard: &'a mut Guard,
    pub(super) parallel: &'a Parallel,
    /// Length of the step that led here \[s\].
    pub(super) last_step: f64,
}

impl<T: Real, const D: usize, K: Kernel<T>> Course<'_, T, D, K> {
    pub(super) fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { world, guard, parallel, last_step } = self;
        world.transfer(parallel, transfer);
        transfer.within("watch", |transfer| guard.transfer(transfer));
        transfer.value("last step", last_step);
    }

    /// One step, and a look at what has become of it.
    pub(super) fn step(&mut self) -> Result<f64, Failure> {
        let dt = self.world.step(self.parallel)?;
        self.guard.look(self.world, self.parallel, dt)?;
        Ok(dt)
    }
}

/// The state of a run.
pub(super) fn transfer_run<T: Real, const D: usize, K: Kernel<T>>(
    course: &mut Course<'_, T, D, K>,
    output: &mut Output<'_, T, D>,
    stepping: &mut f64,
    transfer: &mut Transfer<'_>,
) {
    course.transfer(transfer);
    transfer.within("output", |transfer| output.transfer(transfer));
    transfer.value("wall time", stepping);
}
