//! Force and moment together: what momentum and angular momentum receive.

use core::ops::{Add, AddAssign, Mul};
use mps_kernel::{Real, Tensor, Vector};

/// A force \[N\] and its moment about a stated point \[N m\], or their sums over time: an impulse \[N s\] and an angular
/// impulse \[N m s\] (per metre of depth in 2D).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Push<T: Real, const D: usize> {
    /// The force.
    pub force: Vector<T, D>,
    /// The moment as the antisymmetric tensor `M_ab = r_a f_b - r_b f_a`: in 2D `M_01` is the usual scalar, in 3D
    /// `(M_12, M_20, M_01)` the usual vector.
    pub moment: Tensor<T, D>,
}

impl<T: Real, const D: usize> Push<T, D> {
    /// Of a force that acts at `arm` \[m\] from the point.
    #[inline]
    pub fn at(arm: &Vector<T, D>, force: &Vector<T, D>) -> Self {
        Self { force: *force, moment: Tensor::from_fn(|a, b| arm[a] * force[b] - arm[b] * force[a]) }
    }

    /// The same in double precision: for sums over many steps, in which single precision loses what is added.
    pub fn to_double(&self) -> Push<f64, D> {
        Push { force: self.force.map(T::to_double), moment: self.moment.map(T::to_double) }
    }
}

impl<T: Real, const D: usize> Default for Push<T, D> {
    fn default() -> Self {
        Self { force: Vector::zeros(), moment: Tensor::zeros() }
    }
}

impl<T: Real, const D: usize> Add for Push<T, D> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { force: self.force + other.force, moment: self.moment + other.moment }
    }
}

impl<T: Real, const D: usize> AddAssign for Push<T, D> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<T: Real, const D: usize> Mul<T> for Push<T, D> {
    type Output = Self;
    fn mul(self, factor: T) -> Self {
        Self { force: self.force * factor, moment: self.moment * factor }
    }
}
