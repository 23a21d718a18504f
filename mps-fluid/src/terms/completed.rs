//! Viscosity that is whole at free surfaces.

use super::{ArtificialViscosity, Viscosity};
use mps_kernel::small::{accumulate, scale, vector};
use mps_kernel::{Number, Pair, Real, Vector};

/// [`ArtificialViscosity`] with truncated neighbourhoods completed: the mean of `1/k_i` and `1/k_j` times as strong, where `k_i` is what the
/// weights of a particle sum up to, over `n0` (derivation: [`CentralLaplacian`](mps_kernel::operators::CentralLaplacian)).
///
/// Without it, fluid is missing its viscosity in a layer of about a sixth of the radius along free surfaces and along
/// walls with free slip. Momentum and angular momentum are kept as before. Costs one more visit of the neighbours a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompletedViscosity<T>(pub ArtificialViscosity<T>);

impl<T: Real, const D: usize> Viscosity<T, D> for CompletedViscosity<T> {
    const COMPLETED: bool = true;

    #[inline(always)]
    fn add<N: Number<T>, J>(
        &self,
        sum: &mut Vector<N, D>,
        pair: &Pair<N, D, J>,
        ui: &Vector<T, D>,
        uj: &Vector<N, D>,
    ) {
        self.0.add(sum, pair, ui, uj);
    }

    #[inline(always)]
    fn add_completed<N: Number<T>, J>(
        &self,
        sum: &mut Vector<N, D>,
        pair: &Pair<N, D, J>,
        ui: &Vector<T, D>,
        uj: &Vector<N, D>,
        completion: N,
    ) {
        let nothing = completion * T::zero();
        let mut whole = vector([nothing; D]);
        self.0.add(&mut whole, pair, ui, uj);
        accumulate(sum, &scale(&whole, completion));
    }

    fn kinematic(&self) -> T {
        Viscosity::<T, D>::kinematic(&self.0)
    }
}
