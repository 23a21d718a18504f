//! Fields of several neighbours brought side by side.

use fearless_simd::Simd;
use mps_kernel::by_axis;
use mps_kernel::small::components;
use mps_kernel::{Lanes, Real, Vector};

/// The neighbours `j` and where their fields are.
#[derive(Clone, Copy)]
pub(crate) struct Gather<'a, S, A> {
    pub(crate) simd: S,
    pub(crate) j: &'a [usize],
    pub(crate) from: &'a [A],
}

impl<S: Simd, A> Gather<'_, S, A> {
    /// One number of each neighbour.
    #[inline(always)]
    pub(crate) fn scalar<T: Real>(&self, field: impl Fn(&A) -> T) -> T::Lanes<S> {
        T::Lanes::gather(self.simd, |lane| field(&self.from[self.j[lane]]))
    }

    /// One vector of each neighbour.
    #[inline(always)]
    pub(crate) fn vector<T: Real, const D: usize>(
        &self,
        field: impl Fn(&A) -> &Vector<T, D>,
    ) -> Vector<T::Lanes<S>, D> {
        by_axis!(axis => self.scalar(|a| components(field(a))[axis]))
    }
}
