use super::Kernel;
use crate::{Number, Real};

/// `W = (1 - r/re)^3`: the third-order polynomial of Jandaghian and Shakibaeinia 2020.
///
/// Finite at `r = 0` with a non-zero slope there, so that close particles still separate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Spiky;

impl<T: Real> Kernel<T> for Spiky {
    #[inline(always)]
    fn weight<N: Number<T>>(&self, r: N, re: T) -> N {
        let s = (-(r / re) + T::one()).at_least(T::zero());
        s * s * s
    }

    fn name(&self) -> &'static str {
        "spiky"
    }
}
