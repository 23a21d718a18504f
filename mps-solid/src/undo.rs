//! The state of a body, kept and brought back: what a step that fails must not cost, and what a coupling needs that
//! takes a step more than once.

use crate::{ConstitutiveModel, Solid, SolidError};
use mps_kernel::{Kernel, Pod, Real, Vector};
use mps_neighbors::Parallel;

/// Everything about a body that a step changes. Empty until something is [kept](Solid::save) in it.
#[derive(Clone, Debug, Default)]
pub struct SolidState<T: Real, const D: usize, H> {
    pub(crate) position: Vec<Vector<T, D>>,
    velocity: Vec<Vector<T, D>>,
    mean_velocity: Vec<Vector<T, D>>,
    history: Vec<H>,
    time: T,
}

impl<T: Real, const D: usize, H: Pod + Default> SolidState<T, D, H> {
    /// Room for `len` particles.
    pub(crate) fn with_room(len: usize) -> Self {
        Self {
            position: vec![Vector::zeros(); len],
            velocity: vec![Vector::zeros(); len],
            mean_velocity: vec![Vector::zeros(); len],
            history: vec![H::default(); len],
            time: T::zero(),
        }
    }
}

impl<T, const D: usize, M, K> Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    /// Keeps the present state in `state`, which makes room for it the first time.
    pub fn save(&self, state: &mut SolidState<T, D, M::History>) {
        state.position.clone_from(&self.particles.position);
        state.velocity.clone_from(&self.particles.velocity);
        state.mean_velocity.clone_from(&self.mean_velocity);
        state.history.clone_from(&self.history);
        state.time = self.time;
    }

    /// Brings back a state of this body, with its deformations and forces: the next step is the one that would have
    /// followed, to the last bit.
    ///
    /// # Errors
    /// If the state is that of another body, or is one that has no deformation (positions set from outside).
    pub fn restore(
        &mut self,
        parallel: &Parallel,
        state: &SolidState<T, D, M::History>,
    ) -> Result<(), SolidError> {
        if state.position.len() != self.len() {
            return Err(SolidError::OtherState { found: state.position.len(), needed: self.len() });
        }
        self.particles.position.copy_from_slice(&state.position);
        self.particles.velocity.copy_from_slice(&state.velocity);
        self.mean_velocity.copy_from_slice(&state.mean_velocity);
        self.history.copy_from_slice(&state.history);
        self.time = state.time;
        self.place_supports(self.time);
        self.refresh(parallel)
    }

    /// Keeps the present state for [`take_back`](Self::take_back).
    pub(crate) fn keep(&mut self) {
        let mut before = core::mem::take(&mut self.before);
        self.save(&mut before);
        self.before = before;
    }

    /// Brings back the state that was kept and hands on the `error` that made this necessary.
    pub(crate) fn take_back(&mut self, parallel: &Parallel, error: SolidError) -> SolidError {
        let before = core::mem::take(&mut self.before);
        // Where even these positions have no deformation (they were set from outside) the next step says so again.
        let restored = self.restore(parallel, &before);
        self.before = before;
        match restored {
            Ok(()) | Err(_) => error,
        }
    }
}
