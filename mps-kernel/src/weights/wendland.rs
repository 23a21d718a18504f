use super::Kernel;
use crate::{Number, Real};

/// `W = (1 - q)^4 (1 + 4 q)`, `q = r/re`: the C2 function of Wendland 1995.
///
/// Smooth and finite at `r = 0`; used here for the solid and by Zhang et al. (Riemann SPH).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WendlandC2;

impl<T: Real> Kernel<T> for WendlandC2 {
    #[inline(always)]
    fn weight<N: Number<T>>(&self, r: N, re: T) -> N {
        let q = r / re;
        let s = (-q + T::one()).at_least(T::zero());
        let s2 = s * s;
        s2 * s2 * (q * T::of(4.0) + T::one())
    }

    fn name(&self) -> &'static str {
        "wendland-c2"
    }
}
