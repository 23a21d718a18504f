//! The scalar type and the small vectors and tensors built from it.

use crate::{F32Lanes, F64Lanes, Lanes, Number};
use bytemuck::Pod;
use fearless_simd::Simd;
use nalgebra::{RealField, SMatrix, SVector};
use num_traits::{FromPrimitive, ToPrimitive};

/// A point, velocity or force: `D` components.
pub type Vector<T, const D: usize> = SVector<T, D>;

/// A `D x D` matrix: strain, stress, corrected matrix.
pub type Tensor<T, const D: usize> = SMatrix<T, D, D>;

/// The scalar of a simulation: `f64` (the default everywhere) or `f32`.
///
/// `Pod` (plain old data) lets stores hash and save their fields without a line of code per field.
pub trait Real: RealField + FromPrimitive + ToPrimitive + Pod + Copy + Default + Number<Self> {
    /// Several values side by side, for the instructions `S`.
    type Lanes<S: Simd>: Lanes<Self, S>;

    /// One neighbour index for each lane.
    type LaneIndices: Copy + AsRef<[usize]> + AsMut<[usize]> + Default + Send + Sync;

    /// The nearest value to a constant written as `f64`.
    fn of(value: f64) -> Self;

    /// The value as `f64`, for output and for sums that must not lose digits.
    fn to_double(self) -> f64;
}

impl Real for f64 {
    type Lanes<S: Simd> = F64Lanes<S>;
    type LaneIndices = [usize; 4];

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
    type Lanes<S: Simd> = F32Lanes<S>;
    type LaneIndices = [usize; 8];

    #[inline(always)]
    fn of(value: f64) -> Self {
        value as f32
    }

    #[inline(always)]
    fn to_double(self) -> f64 {
        f64::from(self)
    }
}
