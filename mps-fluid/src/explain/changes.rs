//! What happens to a particle in a step before the sweeps.

use crate::Fluid;
use crate::terms::Viscosity;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::Domain;

/// What regularisation has changed since the step began.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Changes<T: Real, const D: usize> {
    /// Way of the shift (icPS) \[m\].
    pub shift: Vector<T, D>,
    /// Change of velocity by collisions (DPC) \[m/s\].
    pub collision: Vector<T, D>,
    /// Change of the density ratio by its relaxation to the packing \[-\].
    pub relaxation: T,
}

/// The particles before regularisation.
#[derive(Clone, Debug, Default)]
pub(crate) struct Starts<T: Real, const D: usize> {
    position: Vec<Vector<T, D>>,
    velocity: Vec<Vector<T, D>>,
    density: Vec<T>,
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// From the next step on keeps what [`explain`](Self::explain) needs to tell shift, collisions and relaxation of a particle: a copy
    /// of three fields in every step.
    pub fn remember_changes(&mut self) {
        self.starts = Some(Box::default());
    }

    pub(crate) fn remember_starts(&mut self) {
        if let Some(starts) = &mut self.starts {
            starts.position.clone_from(&self.particles.position);
            starts.velocity.clone_from(&self.particles.velocity);
            starts.density.clone_from(&self.particles.density);
        }
    }

    pub(super) fn changes_of(&self, i: usize) -> Option<Changes<T, D>> {
        let starts = self.starts.as_ref()?;
        Some(Changes {
            shift: self.domain.separation(starts.position.get(i)?, &self.particles.position[i]),
            collision: self.particles.velocity[i] - starts.velocity.get(i)?,
            relaxation: self.particles.density[i] - *starts.density.get(i)?,
        })
    }
}
