//! What inlets do in a step: their points travel.

use crate::terms::Viscosity;
use crate::{Fluid, FluidError};
use mps_kernel::{Kernel, Real};
use mps_neighbors::Domain;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Drives the inlets, before forces are found.
    pub(crate) fn drive_inlets(&mut self) -> Result<(), FluidError> {
        let Some(open) = &mut self.open else { return Ok(()) };
        let dt = if self.last_dt > T::zero() {
            self.last_dt
        } else {
            self.config.cfl * self.config.spacing / self.config.sound_speed
        };
        open.inflow = T::zero();
        for inlet in &open.inlets {
            open.inflow += inlet.drive(&mut self.boundary, self.time.now(), dt)?;
        }
        Ok(())
    }

    /// Moves the points of the inlets with the fluid.
    pub(crate) fn advance_inlets(&mut self, dt: T) {
        let Some(open) = &self.open else { return };
        for inlet in &open.inlets {
            inlet.advance(&mut self.boundary, dt);
        }
    }
}
