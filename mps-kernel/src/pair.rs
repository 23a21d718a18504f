//! One directed pair of particles, with the geometry every operator needs.

use crate::small::{dot, scale};
use crate::{Kernel, Number, Real, Vector};

/// What particle `i` sees when it looks at a neighbour `j`.
///
/// Operators never divide by the distance: [`over_r2`](Pair::over_r2) carries `W/r^2`, so that the
/// recurring factor `e_ij W / |r_ij|` is the product `r_ij * over_r2` without a square root.
///
/// `N` is a scalar and `j` an index, or `N` are [`Lanes`](crate::Lanes) and `j` one index for each:
/// then it is several pairs of the same particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair<N, const D: usize, J = usize> {
    /// Index of the neighbour.
    pub j: J,
    /// `r_ij = r_j - r_i` \[m\].
    pub r_ij: Vector<N, D>,
    /// Squared distance \[m^2\], not less than the square of the smallest distance of the weights.
    pub r2: N,
    /// Weight `W(|r_ij|, re)` \[-\].
    pub weight: N,
    /// `W / |r_ij|^2` \[1/m^2\].
    pub over_r2: N,
}

impl<N, const D: usize, J> Pair<N, D, J> {
    /// Evaluates the weight of the pair.
    ///
    /// The distance is bounded from below by [`weights::closest`](crate::weights::closest):
    /// coincident particles give a finite weight and a zero direction, never NaN.
    #[inline(always)]
    pub fn new<T, K>(j: J, r_ij: Vector<N, D>, kernel: &K, re: T) -> Self
    where
        T: Real,
        N: Number<T>,
        K: Kernel<T>,
    {
        let closest = crate::weights::closest(re);
        let r2 = dot(&r_ij, &r_ij).at_least(closest * closest);
        let (weight, over_r2) = kernel.weight_and_over_r2(r2, re);
        Self { j, r_ij, r2, weight, over_r2 }
    }

    /// `e_ij W / |r_ij|` \[1/m\], the vector of gradients and divergences (eqs. 14, 15).
    #[inline(always)]
    pub fn gradient_vector<T>(&self) -> Vector<N, D>
    where
        N: Number<T>,
    {
        scale(&self.r_ij, self.over_r2)
    }

    /// The same pairs, with weight zero where `mask` is zero: lanes without a neighbour.
    #[inline(always)]
    #[must_use]
    pub fn masked<T>(self, mask: N) -> Self
    where
        N: Number<T>,
    {
        Self { weight: self.weight * mask, over_r2: self.over_r2 * mask, ..self }
    }
}

impl<T: Real, const D: usize> Pair<T, D> {
    /// Distance `|r_ij|` \[m\].
    #[inline(always)]
    pub fn distance(&self) -> T {
        self.r2.sqrt()
    }
}
