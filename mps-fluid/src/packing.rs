//! How evenly the particles are packed: measured where it is needed, not in every step.

use crate::terms::Viscosity;
use crate::{Fluid, FluidError};
use mps_kernel::{Kernel, Neighborhood, Real, Vector};
use mps_neighbors::{Domain, Parallel};

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Measures the packing at the present positions: `sum W_ij / n0`, and its asymmetry
    /// `(D/n0) sum e_ij W_ij/r`, which vanishes on a lattice and points into the fluid at its surface.
    ///
    /// The number density of the equation of state follows the continuity equation; this is the one
    /// positions have. The neighbours are those of the last step, so that looking does not change
    /// what follows; before the first step they are searched.
    ///
    /// # Errors
    /// If a position is not finite.
    pub fn measure_packing(&mut self, parallel: &Parallel) -> Result<(), FluidError> {
        if self.search.fluid.len() != self.particles.position.len() {
            self.search.refresh(parallel, &self.domain, &mut self.particles, &self.boundary)?;
        }
        let mut packing = core::mem::take(&mut self.rates.packing);
        let mut asymmetry = core::mem::take(&mut self.rates.asymmetry);
        let neighbors = self.view(&self.search.fluid);
        let walls = self.boundary_view();
        let factor = self.reference.gradient_factor::<D>();
        let inverse_n0 = T::one() / self.reference.n0;
        let volume = &self.boundary.volume;
        parallel.update((packing.as_mut_slice(), asymmetry.as_mut_slice()), |i, (packing, asymmetry)| {
            let mut weights = T::zero();
            let mut lean = Vector::<T, D>::zeros();
            neighbors.for_each(i, |pair| {
                weights += pair.weight;
                lean += pair.gradient_vector();
            });
            if !volume.is_empty() {
                walls.for_each(i, |pair| {
                    weights += pair.weight * volume[pair.j];
                    lean += pair.gradient_vector() * volume[pair.j];
                });
            }
            *packing = weights * inverse_n0;
            *asymmetry = lean * factor;
        });
        self.rates.packing = packing;
        self.rates.asymmetry = asymmetry;
        Ok(())
    }
}
