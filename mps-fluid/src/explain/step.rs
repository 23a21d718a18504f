//! The limits of a step, and who sets them.

use crate::terms::Viscosity;
use crate::{Fluid, Limit, StepLimits};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Domain, Parallel};

/// What the length of a step follows from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepExplanation<T> {
    /// The limits \[s\].
    pub limits: StepLimits<T>,
    /// The one that acts.
    pub limit: Limit,
    /// The fastest particle, its number and speed \[m/s\]. A boundary point may be faster.
    pub fastest: (u32, T),
    /// The particle with the largest acceleration, and that \[m/s^2\].
    pub most_accelerated: (u32, T),
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// What the length of the step that has begun follows from, and which particles set it. A value that is no number counts as the
    /// largest. `None` as in [`explain`](Self::explain), and without particles.
    pub fn explain_step(&self) -> Option<StepExplanation<T>> {
        if !self.turn.stage.is_known() {
            return None;
        }
        let (fastest, v) = largest(&self.particles.velocity)?;
        let (driven, a) = largest(&self.rates.acceleration)?;
        let wall = self.boundary_speed(&Parallel::serial());
        // Not `max`, which would hide a speed that is no number.
        let limits = self.step_limits(if wall > v { wall } else { v }, a);
        let id = &self.particles.id;
        Some(StepExplanation {
            limits,
            limit: limits.shortest().0,
            fastest: (id[fastest], v),
            most_accelerated: (id[driven], a),
        })
    }
}

/// The longest vector, the first one of several: its index and length.
fn largest<T: Real, const D: usize>(vectors: &[Vector<T, D>]) -> Option<(usize, T)> {
    let mut largest: Option<(usize, T)> = None;
    for (i, vector) in vectors.iter().enumerate() {
        let size = vector.norm();
        let is_number = size.partial_cmp(&size).is_some();
        if largest.is_none_or(|(_, most)| size > most || !is_number) {
            largest = Some((i, size));
        }
        if !is_number {
            break;
        }
    }
    largest
}
