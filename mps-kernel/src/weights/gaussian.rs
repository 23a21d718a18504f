use super::Kernel;
use crate::{Number, Real};

/// `W = exp(-(3 r/re)^2)`, cut off at `re`, where it has fallen to 1.2e-4.
///
/// The weight of the nonlocal (peridynamic) operators; smoothing length `h = re/3`. Being cut, it
/// jumps at `re`: choose a radius that is no distance of the lattice (3.1 `l0`, not 3), or rounding
/// decides which neighbours on the rim count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gaussian;

impl<T: Real> Kernel<T> for Gaussian {
    #[inline(always)]
    fn weight<N: Number<T>>(&self, r: N, re: T) -> N {
        let q = r / re;
        (q * q * -T::of(9.0)).exponential().where_below(r, re)
    }

    fn name(&self) -> &'static str {
        "gaussian"
    }
}
