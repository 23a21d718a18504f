//! Divergences of a vector field: the plain difference form and the adjoint of the pressure gradient.
//!
//! Pinned by `tests/properties/polynomials.rs` (exact for quadratic fields on a full lattice) and
//! `tests/properties/conservation.rs` (adjoint on any particles; the ratio as printed is not).

use crate::small::{difference, dot};
use crate::{Number, Pair, PairOperator, Real, Vector};

/// Difference form (eq. 15): `(D/n0) sum_j (u_j - u_i) . e_ij/|r_ij| W_ij`.
#[derive(Clone, Copy, Debug)]
pub struct Divergence<T> {
    /// `D / n0`.
    pub factor: T,
}

impl<T: Real> Divergence<T> {
    /// What neighbour `j` adds, before the factor.
    #[inline(always)]
    pub fn pair<N, const D: usize, J>(ui: &Vector<T, D>, uj: &Vector<N, D>, pair: &Pair<N, D, J>) -> N
    where
        N: Number<T>,
    {
        dot(&difference(uj, ui), &pair.r_ij) * pair.over_r2
    }
}

impl<T: Real, const D: usize> PairOperator<T, D, Vector<T, D>> for Divergence<T> {
    type Output = T;

    fn zero(&self) -> T {
        T::zero()
    }

    #[inline(always)]
    fn add(&self, sum: &mut T, fi: &Vector<T, D>, fj: &Vector<T, D>, pair: &Pair<T, D>) {
        *sum += Self::pair(fi, fj, pair);
    }

    fn finish(&self, sum: T) -> T {
        sum * self.factor
    }
}

/// Weighted form (eq. 23): `(D/n0) sum_j (n_j/n_i) (u_j - u_i) . e_ij/|r_ij| W_ij`.
///
/// The paper prints the inverse ratio. With `n_j/n_i` (Amaro et al. 2022, eq. 21) it is the negative
/// adjoint of [`ConservativeGradient`](super::ConservativeGradient):
/// `sum_i V p_i div(u)_i = - sum_i V u_i . grad(p)_i` on any set of particles.
///
/// The field is `(u, n)`.
#[derive(Clone, Copy, Debug)]
pub struct ConservativeDivergence<T> {
    /// `D / n0`.
    pub factor: T,
}

impl<T: Real, const D: usize> PairOperator<T, D, (Vector<T, D>, T)> for ConservativeDivergence<T> {
    type Output = T;

    fn zero(&self) -> T {
        T::zero()
    }

    #[inline(always)]
    fn add(&self, sum: &mut T, fi: &(Vector<T, D>, T), fj: &(Vector<T, D>, T), pair: &Pair<T, D>) {
        let ((ui, ni), (uj, nj)) = (*fi, *fj);
        *sum += (nj / ni) * Divergence::pair(&ui, &uj, pair);
    }

    fn finish(&self, sum: T) -> T {
        sum * self.factor
    }
}
