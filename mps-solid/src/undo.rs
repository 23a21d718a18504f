//! What a step that fails must not cost: the state before it.

use crate::{ConstitutiveModel, Solid, SolidError};
use mps_kernel::{Clock, Kernel, Pod, Real, Vector};
use mps_neighbors::Parallel;

/// The state at the start of a call of [`Solid::advance`].
#[derive(Clone, Debug)]
pub(crate) struct Before<T: Real, const D: usize, H> {
    pub(crate) position: Vec<Vector<T, D>>,
    pub(crate) remainder: Vec<Vector<T, D>>,
    velocity: Vec<Vector<T, D>>,
    history: Vec<H>,
    time: Clock<T>,
}

impl<T: Real, const D: usize, H: Pod + Default> Before<T, D, H> {
    /// Room for `len` particles.
    pub(crate) fn with_room(len: usize) -> Self {
        Self {
            position: vec![Vector::zeros(); len],
            remainder: vec![Vector::zeros(); len],
            velocity: vec![Vector::zeros(); len],
            history: vec![H::default(); len],
            time: Clock::default(),
        }
    }
}

impl<T, const D: usize, M, K> Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    /// Keeps the present state for [`take_back`](Self::take_back). Copies into room that is there already.
    pub(crate) fn keep(&mut self) {
        self.before.position.copy_from_slice(&self.particles.position);
        self.before.remainder.copy_from_slice(&self.remainder);
        self.before.velocity.copy_from_slice(&self.particles.velocity);
        self.before.history.copy_from_slice(&self.history);
        self.before.time = self.time;
    }

    /// Brings back the state that was kept, with its deformations and forces, and hands on the `error` that made this
    /// necessary.
    pub(crate) fn take_back(&mut self, parallel: &Parallel, error: SolidError) -> SolidError {
        self.particles.position.copy_from_slice(&self.before.position);
        self.remainder.copy_from_slice(&self.before.remainder);
        self.particles.velocity.copy_from_slice(&self.before.velocity);
        self.history.copy_from_slice(&self.before.history);
        self.time = self.before.time;
        self.place_supports(self.time.now());
        // Where even these positions have no deformation (they were set from outside) the next step says so again.
        match self.refresh(parallel) {
            Ok(()) | Err(_) => error,
        }
    }
}
