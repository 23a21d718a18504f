//! Reproducible random deformations, and slopes.

use mps_kernel::Tensor;
use mps_kernel::tensor::{determinant, polar_rotation};

/// Least volume ratio of a sample: the neighbourhood in which slopes are taken stays upright.
const SMALLEST_VOLUME: f64 = 0.05;

/// A source of random tensors.
pub(super) struct Samples {
    state: u64,
    strain: f64,
}

impl Samples {
    pub(super) fn new(seed: u64, strain: f64) -> Self {
        Self { state: seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(1), strain }
    }

    /// Uniform in [-1, 1). Knuth's linear congruential generator, upper bits.
    fn number(&mut self) -> f64 {
        self.state =
            self.state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.state >> 33) as f64 / (1_u64 << 30) as f64 - 1.0
    }

    /// Entries uniform in [-1, 1).
    pub(super) fn tensor<const D: usize>(&mut self) -> Tensor<f64, D> {
        Tensor::from_fn(|_, _| self.number())
    }

    /// Any rotation.
    pub(super) fn rotation<const D: usize>(&mut self) -> Tensor<f64, D> {
        // A random tensor is too flat for a polar decomposition about once in a million million draws.
        for _ in 0..100 {
            let mut any = self.tensor::<D>();
            if determinant(&any) < 0.0 {
                any.row_mut(0).neg_mut();
            }
            if let Some(rotation) = polar_rotation(&any) {
                return rotation;
            }
        }
        Tensor::identity()
    }

    /// `F = R (I + strain)` with `det F > 0`.
    pub(super) fn deformation<const D: usize>(&mut self) -> Tensor<f64, D> {
        let mut strain = self.tensor::<D>() * self.strain;
        let rotation = self.rotation();
        for _ in 0..60 {
            if determinant(&(Tensor::identity() + strain)) > SMALLEST_VOLUME {
                break;
            }
            strain *= 0.5;
        }
        rotation * (Tensor::identity() + strain)
    }

    /// States a particle passes one after the other.
    pub(super) fn path<const D: usize>(&mut self) -> [Tensor<f64, D>; 6] {
        core::array::from_fn(|_| self.deformation())
    }
}

/// Distance of the difference quotients: their error after extrapolation and round-off are both near 1e-11.
const STEP: f64 = 1e-3;

/// Derivative of `value` at zero from central differences at two distances (Richardson's extrapolation).
pub(super) fn slope<V>(value: impl Fn(f64) -> V) -> V
where
    V: core::ops::Sub<Output = V> + core::ops::Mul<f64, Output = V>,
{
    let quotient = |step: f64| (value(step) - value(-step)) * (0.5 / step);
    quotient(0.5 * STEP) * (4.0 / 3.0) - quotient(STEP) * (1.0 / 3.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deformations_are_upright_and_rotations_rotate() {
        let mut samples = Samples::new(1, 1.5);
        for _ in 0..1000 {
            let f = samples.deformation::<3>();
            assert!(determinant(&f) > SMALLEST_VOLUME);
            let q = samples.rotation::<2>();
            assert!((q.transpose() * q - Tensor::identity()).norm() < 1e-14 && determinant(&q) > 0.0);
        }
    }

    #[test]
    fn slopes_are_exact_to_fourth_order() {
        assert!((slope(|x: f64| (1.0 + x).powi(4)) - 4.0).abs() < 1e-12);
        assert!((slope(|x: f64| (2.0 * x).exp()) - 2.0).abs() < 1e-11);
    }
}
