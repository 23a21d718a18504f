//! One directed pair of particles, with the geometry every operator needs.

use crate::{Kernel, Real, Vector};

/// What particle `i` sees when it looks at a neighbour `j`.
///
/// Operators never divide by the distance: [`over_r2`](Pair::over_r2) carries `W/r^2`, so that the
/// recurring factor `e_ij W / |r_ij|` is the product `r_ij * over_r2` without a square root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair<T: Real, const D: usize> {
    /// Index of the neighbour.
    pub j: usize,
    /// `r_ij = r_j - r_i` \[m\].
    pub r_ij: Vector<T, D>,
    /// Squared distance \[m^2\], not less than the square of the smallest distance of the weights.
    pub r2: T,
    /// Weight `W(|r_ij|, re)` \[-\].
    pub weight: T,
    /// `W / |r_ij|^2` \[1/m^2\].
    pub over_r2: T,
}

impl<T: Real, const D: usize> Pair<T, D> {
    /// Evaluates the weight of the pair.
    ///
    /// The distance is bounded from below by [`weights::closest`](crate::weights::closest):
    /// coincident particles give a finite weight and a zero direction, never NaN.
    #[inline(always)]
    pub fn new<K: Kernel<T>>(j: usize, r_ij: Vector<T, D>, kernel: &K, re: T) -> Self {
        let closest = crate::weights::closest(re);
        let r2 = r_ij.norm_squared().at_least(closest * closest);
        let (weight, over_r2) = kernel.weight_and_over_r2(r2, re);
        Self { j, r_ij, r2, weight, over_r2 }
    }

    /// Distance `|r_ij|` \[m\].
    #[inline(always)]
    pub fn distance(&self) -> T {
        self.r2.sqrt()
    }

    /// `e_ij W / |r_ij|` \[1/m\], the vector of gradients and divergences (eqs. 14, 15).
    #[inline(always)]
    pub fn gradient_vector(&self) -> Vector<T, D> {
        self.r_ij * self.over_r2
    }
}
