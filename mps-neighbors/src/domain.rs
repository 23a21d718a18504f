//! How far apart two points are: the one question periodicity changes.

use mps_kernel::small::difference;
use mps_kernel::{Number, Real, Vector};

/// Separation of two points. Zero-sized for open space, so that what is not periodic pays nothing.
pub trait Domain<T: Real, const D: usize>: Copy + Send + Sync {
    /// A difference of two positions \[m\], or that to the nearest image if the domain is periodic.
    ///
    /// Exactly odd in floating point.
    fn nearest<N: Number<T>>(&self, d: Vector<N, D>) -> Vector<N, D>;

    /// `r_to - r_from` \[m\], to the nearest image of `to` if the domain is periodic.
    ///
    /// Exactly antisymmetric in floating point: both particles of a pair see the same distance and
    /// opposite directions to the last bit.
    #[inline(always)]
    fn separation(&self, from: &Vector<T, D>, to: &Vector<T, D>) -> Vector<T, D> {
        self.nearest(difference(to, from))
    }

    /// The image of `p` inside the box \[m\]; `p` itself along open axes.
    fn wrap(&self, p: Vector<T, D>) -> Vector<T, D>;

    /// Lower end and length \[m\] of a periodic axis, `None` for an open one.
    fn period(&self, axis: usize) -> Option<(T, T)>;
}

/// Unbounded space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Open;

impl<T: Real, const D: usize> Domain<T, D> for Open {
    #[inline(always)]
    fn nearest<N: Number<T>>(&self, d: Vector<N, D>) -> Vector<N, D> {
        d
    }

    #[inline(always)]
    fn wrap(&self, p: Vector<T, D>) -> Vector<T, D> {
        p
    }

    #[inline(always)]
    fn period(&self, _axis: usize) -> Option<(T, T)> {
        None
    }
}
