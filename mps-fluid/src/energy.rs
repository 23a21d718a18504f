//! Energies and momenta of the fluid.

use crate::Fluid;
use crate::compressibility::bounded;
use crate::eos::EquationOfState;
use crate::terms::Viscosity;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Domain, Parallel};

/// Energies \[J\] (per metre of depth in 2D).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FluidEnergy<T> {
    /// `sum m u^2/2`.
    pub kinetic: T,
    /// `-sum m g . r`, relative to the origin. Gravity along periodic axes is not in it: it has no potential there, and is work of a field
    /// ([`EnergyBudget::field`](crate::EnergyBudget::field)).
    pub potential: T,
    /// Energy stored by compression, from the equation of state. Where the density is so low that [`Tension::Clip`](crate::Tension::Clip)
    /// leaves no pressure it is what it was when the pressure ended.
    pub compression: T,
}

impl<T: Real> FluidEnergy<T> {
    /// Sum of the parts \[J\].
    pub fn total(&self) -> T {
        self.kinetic + self.potential + self.compression
    }
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// The present energies.
    pub fn energy(&self, parallel: &Parallel) -> FluidEnergy<T> {
        let particles = &self.particles;
        let (m, volume) = (self.config.particle_mass(), self.config.particle_volume());
        let (loosest, gravity) = (self.loosest(), self.gravity_with_potential());
        let half = T::of(0.5);
        let [kinetic, potential, compression] = parallel.fold(
            particles.position.len(),
            [T::zero(); 3],
            &|i| {
                [
                    particles.velocity[i].norm_squared() * half,
                    -gravity.dot(&particles.position[i]),
                    self.eos.energy(bounded(particles.density[i], loosest)),
                ]
            },
            &|a, b| [a[0] + b[0], a[1] + b[1], a[2] + b[2]],
        );
        FluidEnergy { kinetic: m * kinetic, potential: m * potential, compression: volume * compression }
    }

    /// Gravity without its components along periodic axes \[m/s^2\]: going round there, a particle would fall for ever.
    pub(crate) fn gravity_with_potential(&self) -> Vector<T, D> {
        let gravity = &self.config.gravity;
        Vector::from_fn(|axis, _| if self.domain.period(axis).is_some() { T::zero() } else { gravity[axis] })
    }

    /// Total momentum \[kg m/s\].
    pub fn momentum(&self, parallel: &Parallel) -> Vector<T, D> {
        let u = &self.particles.velocity;
        parallel.fold(u.len(), Vector::zeros(), &|i| u[i], &|a, b| a + b) * self.config.particle_mass()
    }
}
