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
    /// Of a state that is [remembered](Solid::remember); nothing is kept of it otherwise.
    mean_velocity: Vec<Vector<T, D>>,
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
            mean_velocity: Vec::new(),
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

    /// Keeps the present state for [`go_back`](Self::go_back), beside that which every step keeps for itself. Makes room the first time.
    pub(crate) fn remember(&mut self) {
        let Before { position, remainder, velocity, history, mean_velocity, time } = &mut self.remembered;
        again(position, &self.particles.position);
        again(remainder, &self.remainder);
        again(velocity, &self.particles.velocity);
        again(history, &self.history);
        again(mean_velocity, &self.mean_velocity);
        *time = self.time;
    }

    /// Brings back the state that was remembered, if there is one.
    pub(crate) fn go_back(&mut self, parallel: &Parallel) {
        if self.remembered.position.is_empty() {
            return;
        }
        core::mem::swap(&mut self.before, &mut self.remembered);
        self.restore(parallel);
        self.mean_velocity.copy_from_slice(&self.before.mean_velocity);
        core::mem::swap(&mut self.before, &mut self.remembered);
    }

    /// Brings back the state that was kept, with its deformations and forces, and hands on the `error` that made this
    /// necessary.
    pub(crate) fn take_back(&mut self, parallel: &Parallel, error: SolidError) -> SolidError {
        self.restore(parallel);
        error
    }

    fn restore(&mut self, parallel: &Parallel) {
        self.particles.position.copy_from_slice(&self.before.position);
        self.remainder.copy_from_slice(&self.before.remainder);
        self.particles.velocity.copy_from_slice(&self.before.velocity);
        self.history.copy_from_slice(&self.before.history);
        self.time = self.before.time;
        self.place_supports(self.time.now());
        // Where even these positions have no deformation (they were set from outside) the next step says so again.
        match self.refresh(parallel) {
            Ok(()) | Err(_) => (),
        }
    }
}

/// Fills `kept` with `now`.
fn again<X: Copy>(kept: &mut Vec<X>, now: &[X]) {
    kept.clear();
    kept.extend_from_slice(now);
}
