//! The Laplacian of the original method, and one that leans on near neighbours.
//!
//! Pinned by `tests/properties/polynomials.rs`: on a full lattice exact for cubic fields, with every
//! weight, because `lambda0` and `n0` are summed over the same lattice.

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

/// `(2 D/n0) sum_j (f_j - f_i) W_ij/r^2` of a vector field: the divergence of the gradient, in place of the paper's eq. 16. The viscous term of
/// Morris, Fox and Zhu (1997, J. Comput. Phys. 136, 214-226), written with the weight of this method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompactLaplacian<T> {
    /// `2 D/n0` \[-\], or what it is multiplied with.
    pub factor: T,
}

impl<T: Real> CompactLaplacian<T> {
    /// What neighbour `j` adds.
    #[inline(always)]
    pub fn pair<N, const D: usize, J>(
        &self,
        fi: &Vector<T, D>,
        fj: &Vector<N, D>,
        pair: &Pair<N, D, J>,
    ) -> Vector<N, D>
    where
        N: Number<T>,
    {
        scale(&difference(fj, fi), pair.over_r2 * self.factor)
    }
}

impl<T: Real, const D: usize> PairOperator<T, D, Vector<T, D>> for CompactLaplacian<T> {
    type Output = Vector<T, D>;

    fn zero(&self) -> Self::Output {
        Vector::zeros()
    }

    #[inline(always)]
    fn add(&self, sum: &mut Self::Output, fi: &Vector<T, D>, fj: &Vector<T, D>, pair: &Pair<T, D>) {
        *sum += self.pair(fi, fj, pair);
    }

    fn finish(&self, sum: Self::Output) -> Self::Output {
        sum
    }
}
