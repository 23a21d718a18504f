//! Gradients of a scalar: the difference form and the conservative sum form.
//!
//! Pinned by `tests/properties/gradient.rs` (corrected: exact for linear fields on any full
//! neighbourhood), `tests/properties/polynomials.rs` (plain: exact for quadratic fields on a full
//! lattice) and `tests/properties/conservation.rs` (the sum form keeps momentum pair by pair, to the
//! last bit; as printed it does not).

use crate::small::scale;
use crate::{Number, Pair, PairOperator, Real, Vector};

/// Difference form (eq. 14): `(D/n0) sum_j (f_j - f_i) e_ij/|r_ij| W_ij`.
///
/// Multiplied by the inverse of the corrected matrix (eq. 21, [`Corrected`](super::Corrected)) it
/// is exact for linear fields on any neighbourhood that spans the space.
#[derive(Clone, Copy, Debug)]
pub struct Gradient<T> {
    /// `D / n0`.
    pub factor: T,
}

impl<T: Real> Gradient<T> {
    /// What neighbour `j` adds, before the factor.
    #[inline(always)]
    pub fn pair<N: Number<T>, const D: usize, J>(fi: T, fj: N, pair: &Pair<N, D, J>) -> Vector<N, D> {
        scale(&pair.r_ij, (fj - fi) * pair.over_r2)
    }
}

impl<T: Real, const D: usize> PairOperator<T, D, T> for Gradient<T> {
    type Output = Vector<T, D>;

    fn zero(&self) -> Self::Output {
        Vector::zeros()
    }

    #[inline(always)]
    fn add(&self, sum: &mut Self::Output, fi: &T, fj: &T, pair: &Pair<T, D>) {
        *sum += Self::pair(*fi, *fj, pair);
    }

    fn finish(&self, sum: Self::Output) -> Self::Output {
        sum * self.factor
    }
}

/// Sum form (eq. 24): `(D/n0) sum_j ((n_i/n_j) p_j + (n_j/n_i) p_i) e_ij/|r_ij| W_ij`.
///
/// The paper prints `(n_i/n_j)` twice. Only the form above (Amaro et al. 2022, eq. 13) makes the
/// two forces of a pair equal and opposite, and is the negative adjoint of
/// [`ConservativeDivergence`](super::ConservativeDivergence).
///
/// The field is `(p, n)`: pressure and number density (or density ratio) of the particle.
#[derive(Clone, Copy, Debug)]
pub struct ConservativeGradient<T> {
    /// `D / n0`.
    pub factor: T,
}

impl<T: Real> ConservativeGradient<T> {
    /// The symmetric pressure of a pair, `(n_i/n_j) p_j + (n_j/n_i) p_i`, from the quotients `s = p/n` (which sweeps keep, to avoid
    /// two divisions a pair) and the densities of both.
    #[inline(always)]
    pub fn pair_pressure<N: Number<T>>(si: T, ni: T, sj: N, nj: N) -> N {
        sj * ni + nj * si
    }
}

impl<T: Real, const D: usize> PairOperator<T, D, (T, T)> for ConservativeGradient<T> {
    type Output = Vector<T, D>;

    fn zero(&self) -> Self::Output {
        Vector::zeros()
    }

    #[inline(always)]
    fn add(&self, sum: &mut Self::Output, fi: &(T, T), fj: &(T, T), pair: &Pair<T, D>) {
        let ((pi, ni), (pj, nj)) = (*fi, *fj);
        let pressure = Self::pair_pressure(pi / ni, ni, pj / nj, nj);
        *sum += pair.r_ij * (pressure * pair.over_r2);
    }

    fn finish(&self, sum: Self::Output) -> Self::Output {
        sum * self.factor
    }
}
