//! The corrected matrix: what makes a gradient exact on an incomplete neighbourhood.
//!
//! Pinned by `tests/properties/gradient.rs` (exactness) and `tests/properties/degenerate.rs` (what is
//! refused).

use crate::small::{outer, scale};
use crate::tensor::guarded_inverse;
use crate::{Number, Pair, PairOperator, Real, Tensor, Vector};

/// `(D/n0) sum_j e_ij (x) e_ij W_ij`, the matrix whose inverse is `C_i` (eq. 22).
#[derive(Clone, Copy, Debug)]
pub struct MomentMatrix<T> {
    /// `D / n0`.
    pub factor: T,
}

impl<T: Real> MomentMatrix<T> {
    /// What neighbour `j` adds, before the factor.
    #[inline(always)]
    pub fn pair<N: Number<T>, const D: usize, J>(pair: &Pair<N, D, J>) -> Tensor<N, D> {
        outer(&scale(&pair.r_ij, pair.over_r2), &pair.r_ij)
    }
}

impl<T: Real, const D: usize, F: Copy> PairOperator<T, D, F> for MomentMatrix<T> {
    type Output = Tensor<T, D>;

    fn zero(&self) -> Self::Output {
        Tensor::zeros()
    }

    #[inline(always)]
    fn add(&self, sum: &mut Self::Output, _fi: &F, _fj: &F, pair: &Pair<T, D>) {
        *sum += Self::pair::<T, D, usize>(pair);
    }

    fn finish(&self, sum: Self::Output) -> Self::Output {
        sum * self.factor
    }
}

/// The inverse of a moment matrix, or the reason to do without.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Corrected<T: Real, const D: usize> {
    /// `C_i`, to be multiplied with the difference-form gradient.
    Full(Tensor<T, D>),
    /// The neighbourhood is empty, collinear or nearly so: the gradient stays uncorrected.
    /// Callers count these and report them.
    Degenerate,
}

impl<T: Real, const D: usize> Corrected<T, D> {
    /// The matrix to multiply with: `C_i`, or the identity for a degenerate neighbourhood.
    #[inline]
    pub fn matrix(&self) -> Tensor<T, D> {
        match self {
            Self::Full(matrix) => *matrix,
            Self::Degenerate => Tensor::identity(),
        }
    }

    /// The corrected gradient, or none where the neighbourhood is degenerate: what
    /// [`DiffusionFilter`](super::DiffusionFilter) takes, so that it damps on any particles.
    #[inline]
    pub fn corrected_or_zero(&self, gradient: &Vector<T, D>) -> Vector<T, D> {
        match self {
            Self::Full(matrix) => matrix * gradient,
            Self::Degenerate => Vector::zeros(),
        }
    }

    /// Whether the neighbourhood was too poor to correct.
    #[inline]
    pub fn is_degenerate(&self) -> bool {
        matches!(self, Self::Degenerate)
    }
}

/// `C_i` from the finished moment matrix (eq. 22), guarded.
///
/// `limit` bounds `|det M| / (|M|_F/sqrt(D))^D` from below; 0.05 refuses condition numbers above 40 in
/// 2D, above 37 in 3D if the neighbourhood is flat and above 10 if it is a rod.
#[inline]
pub fn invert_moment<T: Real, const D: usize>(moment: &Tensor<T, D>, limit: T) -> Corrected<T, D> {
    match guarded_inverse(moment, limit) {
        Some(inverse) => Corrected::Full(inverse),
        None => Corrected::Degenerate,
    }
}

/// A gradient corrected by `C_i` (eq. 21).
impl<T: Real, const D: usize> core::ops::Mul<Vector<T, D>> for Corrected<T, D> {
    type Output = Vector<T, D>;

    #[inline]
    fn mul(self, gradient: Vector<T, D>) -> Vector<T, D> {
        match self {
            Self::Full(matrix) => matrix * gradient,
            Self::Degenerate => gradient,
        }
    }
}
