//! The Laplacian of the original method.
//!
//! Pinned by `tests/properties/polynomials.rs`: on a full lattice exact for cubic fields, with every
//! weight, because `lambda0` is summed over the same lattice.

use crate::small::{difference, scale};
use crate::{Number, Pair, PairOperator, Real, Vector};

/// `(2 D / (n0 lambda0)) sum_j (f_j - f_i) W_ij` (eqs. 16, 25), of a vector field.
#[derive(Clone, Copy, Debug)]
pub struct Laplacian<T> {
    /// `2 D / (n0 lambda0)` \[1/m^2\].
    pub factor: T,
}

impl<T: Real> Laplacian<T> {
    /// What neighbour `j` adds, before the factor.
    #[inline(always)]
    pub fn pair<N, const D: usize, J>(
        fi: &Vector<T, D>,
        fj: &Vector<N, D>,
        pair: &Pair<N, D, J>,
    ) -> Vector<N, D>
    where
        N: Number<T>,
    {
        scale(&difference(fj, fi), pair.weight)
    }
}

impl<T: Real, const D: usize> PairOperator<T, D, Vector<T, D>> for Laplacian<T> {
    type Output = Vector<T, D>;

    fn zero(&self) -> Self::Output {
        Vector::zeros()
    }

    #[inline(always)]
    fn add(&self, sum: &mut Self::Output, fi: &Vector<T, D>, fj: &Vector<T, D>, pair: &Pair<T, D>) {
        *sum += Self::pair(fi, fj, pair);
    }

    fn finish(&self, sum: Self::Output) -> Self::Output {
        sum * self.factor
    }
}
