//! A box that repeats itself along some of its axes.

use crate::{Domain, NeighborError};
use mps_kernel::{Number, Real, Vector};

/// Periodic along the axes that have a length, open along the others.
///
/// ```
/// use mps_kernel::Vector;
/// use mps_neighbors::{Domain, PeriodicBox};
///
/// let channel = PeriodicBox::new(Vector::<f64, 2>::new(0.0, 0.0), [Some(1.0), None])?;
/// let d = channel.separation(&Vector::<f64, 2>::new(0.9, 0.0), &Vector::<f64, 2>::new(0.1, 3.0));
/// assert!((d - Vector::<f64, 2>::new(0.2, 3.0)).norm() < 1e-12);
/// assert_eq!(channel.wrap(Vector::<f64, 2>::new(1.25, -7.0)), Vector::<f64, 2>::new(0.25, -7.0));
/// # Ok::<(), mps_neighbors::NeighborError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeriodicBox<T: Real, const D: usize> {
    lower: Vector<T, D>,
    length: [Option<T>; D],
}

impl<T: Real, const D: usize> PeriodicBox<T, D> {
    /// A box from `lower` \[m\] on, with a `length` \[m\] for every periodic axis.
    ///
    /// # Errors
    /// If a length is not positive or not finite, or the lower end of a periodic axis is not
    /// finite. That the box holds at least two search radii is checked by
    /// [`Cells::build`](crate::Cells::build), which knows the radius.
    pub fn new(lower: Vector<T, D>, length: [Option<T>; D]) -> Result<Self, NeighborError> {
        for (axis, length) in length.iter().enumerate() {
            if let Some(length) = length {
                let (lower, length) = (lower[axis].to_double(), length.to_double());
                if !(length > 0.0 && length.is_finite() && lower.is_finite()) {
                    return Err(NeighborError::Period { axis, lower, length });
                }
            }
        }
        Ok(Self { lower, length })
    }
}

impl<T: Real, const D: usize> Domain<T, D> for PeriodicBox<T, D> {
    #[inline(always)]
    fn nearest<N: Number<T>>(&self, mut d: Vector<N, D>) -> Vector<N, D> {
        for axis in 0..D {
            // Without asking whether the pair lies across an edge: lanes would have to ask one by one.
            if let Some(length) = self.length[axis] {
                let images = (d[axis] / length).nearest();
                d[axis] -= images * length;
            }
        }
        d
    }

    #[inline]
    fn wrap(&self, mut p: Vector<T, D>) -> Vector<T, D> {
        for axis in 0..D {
            if let Some(length) = self.length[axis] {
                let lower = self.lower[axis];
                let upper = lower + length;
                if p[axis] < lower || p[axis] >= upper {
                    let images = ((p[axis] - lower) / length).floor();
                    p[axis] -= length * images;
                    // Just below the lower end, the sum rounds to the upper end itself.
                    if p[axis] < lower || p[axis] >= upper {
                        p[axis] = lower;
                    }
                }
            }
        }
        p
    }

    #[inline]
    fn period(&self, axis: usize) -> Option<(T, T)> {
        self.length.get(axis).copied().flatten().map(|length| (self.lower[axis], length))
    }
}
