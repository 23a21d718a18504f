//! The scalar type and the small vectors and tensors built from it.

use bytemuck::Pod;
use nalgebra::{RealField, SMatrix, SVector};
use num_traits::{FromPrimitive, ToPrimitive};

/// A point, velocity or force: `D` components.
pub type Vector<T, const D: usize> = SVector<T, D>;

/// A `D x D` matrix: strain, stress, corrected matrix.
pub type Tensor<T, const D: usize> = SMatrix<T, D, D>;

/// The scalar of a simulation: `f64` (the default everywhere) or `f32`.
///
/// `Pod` (plain old data) lets stores hash and save their fields without a line of code per field.
pub trait Real: RealField + FromPrimitive + ToPrimitive + Pod + Copy + Default {
    /// The nearest value to a constant written as `f64`.
    fn of(value: f64) -> Self;

    /// The value as `f64`, for output and for sums that must not lose digits.
    fn to_double(self) -> f64;

    /// The value, or `floor` where it is not above it (NaN included).
    ///
    /// One instruction. `max` has to look for NaN on both sides, which costs the pair loop several
    /// percent.
    #[inline(always)]
    fn at_least(self, floor: Self) -> Self {
        if self > floor { self } else { floor }
    }
}

impl Real for f64 {
    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn to_double(self) -> f64 {
        self
    }
}

impl Real for f32 {
    #[inline(always)]
    fn of(value: f64) -> Self {
        value as f32
    }

    #[inline(always)]
    fn to_double(self) -> f64 {
        f64::from(self)
    }
}
