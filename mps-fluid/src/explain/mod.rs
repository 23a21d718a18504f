//! Why a particle moves as it does: every term of its acceleration and of its density rate, and its neighbours.
//!
//! The sweeps of a step keep only sums. [`Fluid::explain`] forms them once more for a single particle, term by term and pair by
//! pair, from what [`begin_step`](Fluid::begin_step) has found, also when that ended in an error. A run that does not ask pays nothing.
//!
//! | file | what it does |
//! |---|---|
//! | `acceleration` | the terms of the momentum sweep, and who contributes what |
//! | `density` | the terms of the density sweep, with the velocities the step will end with |
//! | `changes` | what happens to a particle before the sweeps: shift, relaxation, collisions |
//! | `step` | the limits of the step and the particles that set them |

mod acceleration;
mod changes;
mod density;
mod step;

pub use acceleration::{AccelerationTerms, Neighbor, Other};
pub use changes::Changes;
pub(crate) use changes::Starts;
pub use density::DensityTerms;
pub use step::StepExplanation;

use crate::Fluid;
use crate::terms::Viscosity;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::Domain;

/// What acts on one particle in a step that has begun.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation<T: Real, const D: usize> {
    /// Number of the particle in the order of creation.
    pub id: u32,
    /// Position \[m\].
    pub position: Vector<T, D>,
    /// Velocity at the start of the step, collisions done \[m/s\].
    pub velocity: Vector<T, D>,
    /// Density ratio `n/n0` \[-\].
    pub density: T,
    /// Pressure \[Pa\].
    pub pressure: T,
    /// The terms of its acceleration.
    pub acceleration: AccelerationTerms<T, D>,
    /// The terms of its density rate.
    pub density_rate: DensityTerms<T>,
    /// What happened to it before; `None` unless [`Fluid::remember_changes`] was called before the step.
    pub changes: Option<Changes<T, D>>,
    /// Who is within the effective radius, nearest first.
    pub neighbors: Vec<Neighbor<T, D>>,
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// What acts on particle `i`, its present index, in the step of `dt` \[s\] that has begun and is not finished.
    ///
    /// `None` where there is no such particle, or no step whose accelerations are known: between steps, or after a
    /// [`begin_step`](Self::begin_step) that failed before its sweeps.
    pub fn explain(&self, i: usize, dt: T) -> Option<Explanation<T, D>> {
        let particles = &self.particles;
        if !self.turn.stage.is_known() || i >= particles.position.len() {
            return None;
        }
        let (acceleration, mut neighbors) = self.acceleration_terms(i);
        neighbors.sort_by(|a, b| a.distance.to_double().total_cmp(&b.distance.to_double()));
        Some(Explanation {
            id: particles.id[i],
            position: particles.position[i],
            velocity: particles.velocity[i],
            density: particles.density[i],
            pressure: particles.pressure[i],
            acceleration,
            density_rate: self.density_terms(i, dt),
            changes: self.changes_of(i),
            neighbors,
        })
    }
}
