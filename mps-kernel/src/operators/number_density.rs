//! The particle number density.
//!
//! Pinned by `tests/properties/reference_density.rs`: the same sum over the full lattice is `n0`.

use crate::{Pair, PairOperator, Real};

/// `n_i = sum_j W_ij` (eq. 13). The field is not used.
#[derive(Clone, Copy, Debug, Default)]
pub struct NumberDensity;

impl<T: Real, const D: usize, F: Copy> PairOperator<T, D, F> for NumberDensity {
    type Output = T;

    fn zero(&self) -> T {
        T::zero()
    }

    #[inline(always)]
    fn add(&self, sum: &mut T, _fi: &F, _fj: &F, pair: &Pair<T, D>) {
        *sum += pair.weight;
    }

    fn finish(&self, sum: T) -> T {
        sum
    }
}
