//! How much of its neighbourhood each particle has for the viscosity to work with.

use crate::Fluid;
use crate::boundary::Shear;
use crate::gather::Gather;
use crate::terms::Viscosity;
use fearless_simd::Simd;
use mps_kernel::operators::CentralLaplacian;
use mps_kernel::{Kernel, Lanes, Neighborhood, Real, Vector};
use mps_neighbors::{Domain, Parallel, RowView, Sweep};

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// `1/k_i` of all particles for their present positions; none for a viscosity that does not ask.
    pub(crate) fn sweep_completion(&mut self, parallel: &Parallel) {
        if !V::COMPLETED {
            return;
        }
        let mut completion = core::mem::take(&mut self.rates.completion);
        completion.resize(self.particles.position.len(), T::one());
        let sweep = Completion {
            neighbors: self.view(&self.search.fluid),
            walls: self.boundary_view(),
            volume: &self.boundary.volume,
            shear: &self.boundary.shear,
            inverse_n0: T::one() / self.reference.n0,
        };
        parallel.sweep(completion.as_mut_slice(), &sweep);
        self.rates.completion = completion;
    }
}

/// Adds the viscous accelerations of `i` by several neighbours, completed with what [`Fluid::sweep_completion`] has measured.
#[inline(always)]
pub(crate) fn add_viscosity<T: Real, const D: usize, V: Viscosity<T, D>, S: Simd, A>(
    viscosity: &V,
    completion: &[T],
    sum: &mut Vector<T::Lanes<S>, D>,
    i: usize,
    pair: &mps_kernel::Pair<T::Lanes<S>, D, T::LaneIndices>,
    (ui, uj): (&Vector<T, D>, &Vector<T::Lanes<S>, D>),
    other: &Gather<'_, S, A>,
) {
    if V::COMPLETED {
        let mean = (other.of(completion).scalar(|there| *there) + completion[i]) * T::of(0.5);
        viscosity.add_completed(sum, pair, ui, uj, mean);
    } else {
        viscosity.add(sum, pair, ui, uj);
    }
}

/// What [`Fluid::sweep_completion`] does to one particle.
struct Completion<'a, T: Real, const D: usize, K, P> {
    neighbors: RowView<'a, T, D, K, P>,
    walls: RowView<'a, T, D, K, P>,
    /// Volumes of the boundary points over that of a particle \[-\].
    volume: &'a [T],
    shear: &'a [Shear],
    inverse_n0: T,
}

impl<'b, T: Real, const D: usize, K, P> Sweep<&'b mut [T]> for Completion<'_, T, D, K, P>
where
    K: Kernel<T>,
    P: Domain<T, D>,
{
    #[inline(always)]
    fn visit<S: Simd>(&self, simd: S, i: usize, completion: &'b mut T) {
        let mut weights = T::Lanes::splat(simd, T::zero());
        for pair in self.neighbors.packs(simd, i) {
            weights += pair.weight;
        }
        let mut weights = weights.sum();
        // Walls with free slip are to the viscosity as if they were not there.
        if !self.volume.is_empty() {
            self.walls.for_each(i, |pair| {
                if self.shear[pair.j] != Shear::Free {
                    weights += pair.weight * self.volume[pair.j];
                }
            });
        }
        *completion = CentralLaplacian::completion(weights * self.inverse_n0);
    }
}
