//! `n0` and `lambda0`: what the weights sum to on the full reference lattice.

use crate::weights::closest;
use crate::{Kernel, Real, Vector};
use thiserror::Error;

/// Reference values of the square (2D) or cubic (3D) lattice with spacing `l0` (eqs. 13, 17).
///
/// For the rational weight and `re = 3 l0`: `n0 = 17.46104835`, `lambda0 = 2.32387649 l0^2` from 24
/// neighbours in 2D, `n0 = 48.63342843`, `lambda0 = 3.03627453 l0^2` from 92 in 3D. Points on the
/// rim, `|r| = re` up to rounding (four more in 2D, 30 in 3D), have no weight and are not counted.
///
/// Pinned for every weight against sums in 40 digits by `tests/properties/reference_density.rs`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceDensity<T> {
    /// Particle number density `n0 = sum_j W_ij` of an interior particle \[-\].
    pub n0: T,
    /// `lambda0 = sum_j |r_ij|^2 W_ij / sum_j W_ij` \[m^2\].
    pub lambda0: T,
    /// Spacing of the lattice \[m\].
    pub spacing: T,
    /// Effective radius \[m\].
    pub radius: T,
    /// Number of lattice neighbours with a positive weight.
    pub neighbors: usize,
}

/// Why no reference density exists.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ReferenceDensityError {
    /// The spacing is not a positive finite number.
    #[error(
        "particle spacing must be positive and finite, got {0} m: give the distance between particles in metres"
    )]
    Spacing(f64),
    /// The radius does not reach beyond the first neighbours, or reaches absurdly far.
    #[error(
        "effective radius {radius} m must be 1.2 to 15 times the spacing {spacing} m (usual: 2.1 to 4): a particle needs neighbours on all sides, but not thousands"
    )]
    Radius {
        /// The refused radius \[m\].
        radius: f64,
        /// The spacing it was given for \[m\].
        spacing: f64,
    },
    /// The weights do not add up to a number one can divide by.
    #[error(
        "the weights of the lattice with spacing {spacing} m add up to {sum}, which is not a positive finite number: choose units in which the spacing is nearer to 1, or check the weight"
    )]
    Sum {
        /// The sum of the weights \[-\].
        sum: f64,
        /// The spacing of the lattice \[m\].
        spacing: f64,
    },
}

impl<T: Real> ReferenceDensity<T> {
    /// Sums the weight over the lattice of spacing `spacing` \[m\] within `radius` \[m\].
    ///
    /// # Errors
    /// If the spacing is not positive, the radius is not between 1.2 and 15 spacings, or the sum
    /// overflows or vanishes. (From 15 spacings on, [`closest`] would near the spacing itself.)
    pub fn lattice<K: Kernel<T>, const D: usize>(
        kernel: &K,
        spacing: T,
        radius: T,
    ) -> Result<Self, ReferenceDensityError> {
        let (l0, re) = (spacing.to_double(), radius.to_double());
        if !(l0.is_finite() && l0 > 0.0) {
            return Err(ReferenceDensityError::Spacing(l0));
        }
        if !(re >= 1.2 * l0 && re <= 15.0 * l0) {
            return Err(ReferenceDensityError::Radius { radius: re, spacing: l0 });
        }
        let mut n0 = T::zero();
        let mut second_moment = T::zero();
        let mut neighbors = 0;
        let closest = closest(radius);
        for offset in lattice_offsets::<T, D>(spacing, radius) {
            let r2 = offset.norm_squared();
            let (weight, _) = kernel.weight_and_over_r2(r2.max(closest * closest), radius);
            if is_within(&offset, radius) && weight > T::zero() {
                n0 += weight;
                second_moment += weight * r2;
                neighbors += 1;
            }
        }
        let lambda0 = second_moment / n0;
        // Squares and their inverses leave the range of the scalar for very small or large spacings.
        if !(n0.is_finite() && lambda0.is_finite() && n0 > T::zero() && lambda0 > T::zero()) {
            return Err(ReferenceDensityError::Sum { sum: n0.to_double(), spacing: l0 });
        }
        Ok(Self { n0, lambda0, spacing, radius, neighbors })
    }

    /// `D / n0`, the factor of gradients and divergences (eqs. 14, 15).
    #[inline]
    pub fn gradient_factor<const D: usize>(&self) -> T {
        T::of(D as f64) / self.n0
    }

    /// `2 D / (n0 lambda0)` \[1/m^2\], the factor of the Laplacian (eq. 16).
    #[inline]
    pub fn laplacian_factor<const D: usize>(&self) -> T {
        T::of(2.0 * D as f64) / (self.n0 * self.lambda0)
    }
}

/// Whether a lattice point is a neighbour.
///
/// A point on the rim counts as outside, whatever the last bits of spacing and radius say:
/// else the count, and n0 of a weight that jumps there, would be left to chance.
pub(crate) fn is_within<T: Real, const D: usize>(offset: &Vector<T, D>, radius: T) -> bool {
    offset.norm_squared() < radius * radius * (T::one() - T::default_epsilon() * T::of(16.0))
}

/// All lattice vectors except zero with components up to `radius`, in a fixed order.
pub(crate) fn lattice_offsets<T: Real, const D: usize>(
    spacing: T,
    radius: T,
) -> impl Iterator<Item = Vector<T, D>> {
    let reach = (radius.to_double() / spacing.to_double()).ceil() as i64;
    let side = (2 * reach + 1) as usize;
    (0..side.pow(D as u32)).filter_map(move |index| {
        let mut rest = index;
        let mut zero = true;
        let offset = Vector::from_fn(|_, _| {
            let step = (rest % side) as i64 - reach;
            rest /= side;
            zero &= step == 0;
            spacing * T::of(step as f64)
        });
        (!zero).then_some(offset)
    })
}
