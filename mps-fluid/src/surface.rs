//! Free-surface detection: number density and the largest gap between neighbours (paper, section 2.2.6).

mod gap;

use crate::terms::Viscosity;
use crate::{Fluid, FluidError};
pub use gap::{has_gap, largest_gap};
use mps_kernel::{Kernel, Neighborhood, Real, Vector};
use mps_neighbors::{Domain, Parallel};

/// Where a particle is with respect to the free surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Surface {
    /// Surrounded by fluid or boundary.
    Inner,
    /// At the free surface.
    Free,
    /// With so few neighbours that it counts as spray.
    Detached,
}

/// `beta_1`: a surface particle has less than this share of `n0`.
pub const DENSITY_LIMIT: f64 = 0.95;
/// `beta_2`: and a gap between neighbours of more than this share of the full angle, in space of the full solid angle.
pub const GAP_LIMIT: f64 = 0.25;
/// A particle with less than this share of `n0` is spray.
pub const SPRAY_LIMIT: f64 = 0.35;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Measures the packing and classifies every particle by it and, where it is low, by the gap
    /// between its fluid and boundary neighbours.
    ///
    /// # Errors
    /// As [`measure_packing`](Self::measure_packing).
    pub fn classify_surface(
        &mut self,
        parallel: &Parallel,
        surface: &mut Vec<Surface>,
    ) -> Result<(), FluidError> {
        self.measure_packing(parallel)?;
        surface.resize(self.particles.position.len(), Surface::Inner);
        let fluid = &*self;
        parallel.update(surface.as_mut_slice(), |i, surface| *surface = fluid.surface_of(i));
        Ok(())
    }

    fn surface_of(&self, i: usize) -> Surface {
        let packing = self.rates.packing[i];
        if packing >= T::of(DENSITY_LIMIT) {
            return Surface::Inner;
        }
        if packing < T::of(SPRAY_LIMIT) {
            return Surface::Detached;
        }
        let mut around = [Vector::<T, D>::zeros(); gap::MOST];
        let mut len = 0;
        let mut collect = |pair: &mps_kernel::Pair<T, D>| {
            if len < gap::MOST && pair.weight > T::zero() {
                around[len] = pair.r_ij;
                len += 1;
            }
        };
        self.view(&self.search.fluid).for_each(i, &mut collect);
        if !self.boundary.is_empty() {
            self.boundary_view().for_each(i, &mut collect);
        }
        if has_gap(&around[..len], &self.rates.asymmetry[i], GAP_LIMIT) {
            Surface::Free
        } else {
            Surface::Inner
        }
    }
}
