//! Free-surface detection: number density and the largest angular gap (paper, section 2.2.6).

use mps_kernel::{Real, Vector};

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
/// `beta_2`: and a gap between neighbours of more than this share of the full angle.
pub const GAP_LIMIT: f64 = 0.25;
/// A particle with less than this share of `n0` is spray.
pub const SPRAY_LIMIT: f64 = 0.35;

/// Whether directions to the neighbours leave a gap of more than `share` of the full angle.
///
/// In 2D this is the largest angle between neighbours next to each other, as in the paper. In 3D
/// it is the cone that has the same opening: some of 26 directions (faces, edges, corners of the
/// cube) and `-lean` has no neighbour within half the gap of it.
pub fn has_gap<T: Real, const D: usize>(neighbors: &[Vector<T, D>], lean: &Vector<T, D>, share: f64) -> bool {
    let half = share * core::f64::consts::PI;
    if D == 2 {
        return largest_gap(neighbors) > 2.0 * half;
    }
    let limit = T::of(half.cos());
    let open = |direction: &Vector<T, D>| {
        let norm = direction.norm();
        norm > T::zero() && !neighbors.iter().any(|r| r.dot(direction) > limit * r.norm() * norm)
    };
    let steps = 3_usize.pow(D as u32);
    open(&-lean)
        || (0..steps).any(|index| {
            let mut rest = index;
            open(&Vector::from_fn(|_, _| {
                let step = (rest % 3) as f64 - 1.0;
                rest /= 3;
                T::of(step)
            }))
        })
}

/// Largest angle \[rad\] between neighbours next to each other, seen from the particle (2D).
/// Without neighbours it is the full angle.
pub fn largest_gap<T: Real, const D: usize>(neighbors: &[Vector<T, D>]) -> f64 {
    const MOST: usize = 128;
    let mut angles = [0.0_f64; MOST];
    let mut len = 0;
    for r in neighbors.iter().take(MOST) {
        angles[len] = r[1].to_double().atan2(r[0].to_double());
        len += 1;
    }
    let full = 2.0 * core::f64::consts::PI;
    let angles = &mut angles[..len];
    angles.sort_unstable_by(f64::total_cmp);
    match (angles.first(), angles.last()) {
        (Some(first), Some(last)) => {
            let around = first + full - last;
            angles.windows(2).map(|w| w[1] - w[0]).fold(around, f64::max)
        }
        _ => full,
    }
}

use crate::terms::Viscosity;
use crate::{Fluid, FluidError};
use mps_kernel::{Kernel, Neighborhood};
use mps_neighbors::{Domain, Parallel};

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
        const MOST: usize = 256;
        let mut around = [Vector::<T, D>::zeros(); MOST];
        let mut len = 0;
        let mut collect = |pair: &mps_kernel::Pair<T, D>| {
            if len < MOST && pair.weight > T::zero() {
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
