use super::Kernel;
use crate::{Number, Real};

/// `W = re/r - 1`: the rational weight of the original method.
///
/// The reference values for `re = 3 l0` stand at [`ReferenceDensity`](crate::ReferenceDensity).
/// Source: Koshizuka and Oka 1996; eq. 12 of Tavakoli et al. 2026. Singular at `r = 0`, which
/// keeps particles apart; pairs closer than [`closest`](super::closest) are treated as if at it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rational;

impl<T: Real> Kernel<T> for Rational {
    #[inline(always)]
    fn weight<N: Number<T>>(&self, r: N, re: T) -> N {
        (r.dividing(re) - T::one()).at_least(T::zero())
    }

    #[inline(always)]
    fn weight_and_over_r2<N: Number<T>>(&self, r2: N, re: T) -> (N, N) {
        // Under the root, so that rounding cannot leave a weight at r = re: re^2 * (1/re^2) never
        // rounds to more than one, while re * sqrt(1/re^2) does.
        let inverse_r2 = r2.dividing(T::one());
        let weight = ((inverse_r2 * (re * re)).root() - T::one()).at_least(T::zero());
        (weight, weight * inverse_r2)
    }

    fn name(&self) -> &'static str {
        "rational"
    }
}
