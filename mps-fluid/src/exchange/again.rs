//! Sub-steps taken more than once: what a coupling needs that iterates.
//!
//! The pressure at the interface follows the motion of the structures *against the water*, whose velocity during the sub-steps has to
//! be supposed. The first supposition is that of the start of the step; the reaction to the sub-steps says what it will be at the
//! end. All that an iteration repeats are the sub-steps of the structures; no sweep over the fluid is among it.

use super::Exchange;
use crate::Fluid;
use crate::terms::Viscosity;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::Domain;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Velocities that the particles at the interface are supposed to have during the sub-steps \[m/s\], to be changed
    /// between [`begin_step`](Fluid::begin_step) and the first sub-step.
    pub fn supposed_velocities(&mut self) -> &mut [Vector<T, D>] {
        &mut self.exchange.supposed
    }

    /// Velocities that the same particles get by a step of `dt` \[s\], given the sub-steps that have been taken \[m/s\].
    pub fn velocities_found(&self, dt: T, found: &mut Vec<Vector<T, D>>) {
        let factor = self.reaction_factor();
        found.clear();
        found.extend(self.exchange.wetted.iter().enumerate().map(|(k, &i)| {
            let acceleration = self.exchange.pushed(k, self.rates.acceleration[i as usize], factor);
            self.particles.velocity[i as usize] + acceleration * dt
        }));
    }

    /// Forgets the sub-steps that have been taken in this step, so that they can be taken again.
    pub fn restart_exchange(&mut self) {
        self.exchange.restart();
    }
}

impl<T: Real, const D: usize> Exchange<T, D> {
    fn restart(&mut self) {
        for field in [&mut self.rise, &mut self.change, &mut self.sum] {
            field.fill(T::zero());
        }
        self.slide.fill(Vector::zeros());
        self.substeps = 0;
    }
}
