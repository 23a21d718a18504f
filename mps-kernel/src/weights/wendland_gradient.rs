use super::Kernel;
use crate::{Number, Real};

/// `W = q^2 (1 - q)^3`, `q = r/re`: the weight whose pair vector `e W/r` is the gradient of a smooth function.
///
/// `W/r = -F'` (up to a factor) for the C2 function `F = (1 - q)^4 (1 + 4 q)` of Wendland 1995, so that sums of
/// pair vectors are quadratures of a smooth integrand. The other weights are largest at `r = 0`, where a particle has
/// no neighbours: what their sums say depends on where exactly the nearest neighbours are. Strain a
/// lattice without changing its volume, and the moment matrix with `re = 3 l0` changes by 0.3 times the strain with
/// [`Rational`](super::Rational), by 0.03 times with this one: by so much of its pressure a fluid resists shear
/// (`tests/properties/strained_lattice.rs`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WendlandGradient;

impl<T: Real> Kernel<T> for WendlandGradient {
    #[inline(always)]
    fn weight<N: Number<T>>(&self, r: N, re: T) -> N {
        self.weight_and_over_r2(r * r, re).0
    }

    #[inline(always)]
    fn weight_and_over_r2<N: Number<T>>(&self, r2: N, re: T) -> (N, N) {
        // The root of re * re is re again, so that nothing is left at the border.
        let inverse = T::one() / re;
        let s = (-r2.root() + re).at_least(T::zero()) * inverse;
        let over_r2 = s * s * s * (inverse * inverse);
        (over_r2 * r2, over_r2)
    }

    fn name(&self) -> &'static str {
        "wendland-gradient"
    }
}
