//! Fields of several neighbours brought side by side.

use fearless_simd::Simd;
use mps_kernel::small::{columns, components};
use mps_kernel::{Lanes, Real, Tensor, Vector};
use mps_kernel::{by_axes, by_axis};

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

    /// Other fields of the same neighbours.
    #[inline(always)]
    pub(crate) fn of<'b, B>(&'b self, from: &'b [B]) -> Gather<'b, S, B> {
        Gather { simd: self.simd, j: self.j, from }
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

impl<S: Simd, T: Real, const D: usize> Gather<'_, S, Tensor<T, D>> {
    /// The tensor of each neighbour.
    #[inline(always)]
    pub(crate) fn tensor(&self) -> Tensor<T::Lanes<S>, D> {
        by_axes!((row, column) => self.scalar(|a| columns(a)[column][row]))
    }
}
