//! How evenly the particles are packed: measured where it is needed, not in every step.

use crate::terms::Viscosity;
use crate::{Fluid, FluidError};
use fearless_simd::Simd;
use mps_kernel::small::{accumulate, components, vector};
use mps_kernel::{Kernel, Lanes, Neighborhood, Real, Vector, by_axis};
use mps_neighbors::{Domain, Parallel, RowView, Sweep};

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
        if !self.search.is_of(&self.particles, &self.boundary) {
            self.search.rebuild(
                parallel,
                &self.domain,
                &mut self.particles,
                &mut self.rates,
                &self.boundary,
            )?;
        }
        self.rates.resize_packing(self.particles.position.len());
        let mut packing = core::mem::take(&mut self.rates.packing);
        let mut asymmetry = core::mem::take(&mut self.rates.asymmetry);
        let sweep = Packing {
            neighbors: self.view(&self.search.fluid),
            walls: self.boundary_view(),
            volume: &self.boundary.volume,
            inverse_n0: T::one() / self.reference.n0,
            factor: self.reference.gradient_factor::<D>(),
        };
        parallel.sweep((packing.as_mut_slice(), asymmetry.as_mut_slice()), &sweep);
        self.rates.packing = packing;
        self.rates.asymmetry = asymmetry;
        Ok(())
    }
}

/// What [`Fluid::measure_packing`] does to one particle.
struct Packing<'a, T: Real, const D: usize, K, P> {
    neighbors: RowView<'a, T, D, K, P>,
    walls: RowView<'a, T, D, K, P>,
    /// Volumes of the boundary points over that of a particle \[-\].
    volume: &'a [T],
    inverse_n0: T,
    /// `D/n0`.
    factor: T,
}

impl<'b, T: Real, const D: usize, K, P> Sweep<(&'b mut [T], &'b mut [Vector<T, D>])>
    for Packing<'_, T, D, K, P>
where
    K: Kernel<T>,
    P: Domain<T, D>,
{
    #[inline(always)]
    fn visit<S: Simd>(&self, simd: S, i: usize, (packing, asymmetry): (&'b mut T, &'b mut Vector<T, D>)) {
        let zero = T::Lanes::splat(simd, T::zero());
        let (mut weights, mut lean) = (zero, vector([zero; D]));
        for pair in self.neighbors.packs(simd, i) {
            weights += pair.weight;
            accumulate(&mut lean, &pair.gradient_vector());
        }
        let mut weights = weights.sum();
        let mut lean: Vector<T, D> = by_axis!(axis => components(&lean)[axis].sum());
        if !self.volume.is_empty() {
            self.walls.for_each(i, |pair| {
                let volume = self.volume[pair.j];
                weights += pair.weight * volume;
                lean += pair.gradient_vector() * volume;
            });
        }
        *packing = weights * self.inverse_n0;
        *asymmetry = lean * self.factor;
    }
}
