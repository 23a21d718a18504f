//! The density-diffusion operator of DMPS.
//!
//! Pinned by `tests/properties/diffusion.rs` and, wave by wave, `tests/properties/von_neumann.rs`.

use crate::by_axis;
use crate::small::{components, dot};
use crate::{Number, Pair, PairOperator, Real, Vector};

/// `(2 D / n0) sum_j ((n_j - n_i)/|r_ij| - (g_i + g_j)/2 . e_ij) W_ij/|r_ij|` (eq. 20), with the
/// corrected gradients `g` of eq. 21.
///
/// Written as a Laplacian, but the gradients cancel its second-order part: what is left filters
/// the fourth derivative, which is why it leaves a hydrostatic column alone. The pair terms are
/// antisymmetric to the last bit, so their sum over all particles vanishes.
///
/// It only damps, on any particles: as `g_i` is the least-squares slope,
/// `sum_i n_i F_i = -(D/n0) sum_ij W/r^2 (n_j - n_i - g_i . r_ij)^2`. A degenerate neighbourhood must
/// then hand over no gradient at all ([`corrected_or_zero`](super::Corrected::corrected_or_zero)): the
/// uncorrected one overestimates the slope between two particles that meet, and would drive them apart
/// in density.
///
/// The strongest damping on the lattice, `3.916 / l0^2` in 2D and `3.847 / l0^2` in 3D for the rational
/// weight with `re = 3 l0`, belongs to the wave whose sign alternates along every axis; an explicit step
/// is stable while step times diffusivity times this stays below 2.
///
/// The field is `(n, g)`.
#[derive(Clone, Copy, Debug)]
pub struct DiffusionFilter<T> {
    /// `2 D / n0`.
    pub factor: T,
}

impl<T: Real> DiffusionFilter<T> {
    /// What neighbour `j` adds, before the factor.
    #[inline(always)]
    pub fn pair<N, const D: usize, J>(
        ni: T,
        gi: &Vector<T, D>,
        nj: N,
        gj: &Vector<N, D>,
        pair: &Pair<N, D, J>,
    ) -> N
    where
        N: Number<T>,
    {
        let (own, other) = (components(gi), components(gj));
        let both = by_axis!(axis => other[axis] + own[axis]);
        let slope = dot(&both, &pair.r_ij) * T::of(0.5);
        (nj - ni - slope) * pair.over_r2
    }
}

impl<T: Real, const D: usize> PairOperator<T, D, (T, Vector<T, D>)> for DiffusionFilter<T> {
    type Output = T;

    fn zero(&self) -> T {
        T::zero()
    }

    #[inline(always)]
    fn add(&self, sum: &mut T, fi: &(T, Vector<T, D>), fj: &(T, Vector<T, D>), pair: &Pair<T, D>) {
        *sum += Self::pair(fi.0, &fi.1, fj.0, &fj.1, pair);
    }

    fn finish(&self, sum: T) -> T {
        sum * self.factor
    }
}

/// `(2 D/(n0 lambda0)) sum_j (n_j - n_i - s . r_ij) W_ij`: the Laplacian of the density less its slope `s` in a fluid at
/// rest (Amaro et al. 2022, eq. 20, in terms of the density).
///
/// The paper removes the hydrostatic part with a sign that depends on how `g` is counted; here a fluid in which
/// `n` follows the slope feels nothing. Near a surface or a wall the sum of any other linear field is not
/// zero: that is the price for doing without the gradients of [`DiffusionFilter`].
///
/// The field is `n`.
#[derive(Clone, Copy, Debug)]
pub struct HydrostaticDiffusion<T, const D: usize>
where
    T: Real,
{
    /// `2 D/(n0 lambda0)` \[1/m^2\].
    pub factor: T,
    /// Slope of the field at rest, per metre.
    pub slope: Vector<T, D>,
}

impl<T: Real, const D: usize> HydrostaticDiffusion<T, D> {
    /// What neighbour `j` adds, before the factor.
    #[inline(always)]
    pub fn pair<N: Number<T>, J>(ni: T, nj: N, slope: &Vector<T, D>, pair: &Pair<N, D, J>) -> N {
        let (own, along) = (components(slope), components(&pair.r_ij));
        let mut rise = along[0] * own[0];
        for axis in 1..D {
            rise += along[axis] * own[axis];
        }
        (nj - ni - rise) * pair.weight
    }
}

impl<T: Real, const D: usize> PairOperator<T, D, T> for HydrostaticDiffusion<T, D> {
    type Output = T;

    fn zero(&self) -> T {
        T::zero()
    }

    #[inline(always)]
    fn add(&self, sum: &mut T, fi: &T, fj: &T, pair: &Pair<T, D>) {
        *sum += Self::pair(*fi, *fj, &self.slope, pair);
    }

    fn finish(&self, sum: T) -> T {
        sum * self.factor
    }
}
