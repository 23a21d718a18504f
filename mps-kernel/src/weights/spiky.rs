use super::Kernel;
use crate::Real;

/// `W = (1 - r/re)^3`: the third-order polynomial of Jandaghian and Shakibaeinia 2020.
///
/// Finite at `r = 0` with a non-zero slope there, so that close particles still separate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Spiky;

impl<T: Real> Kernel<T> for Spiky {
    #[inline(always)]
    fn weight(&self, r: T, re: T) -> T {
        let s = (T::one() - r / re).at_least(T::zero());
        s * s * s
    }

    fn name(&self) -> &'static str {
        "spiky"
    }
}
