//! Reproducible noise.

use mps_kernel::Vector;

/// Numbers that look random and are the same in every run.
#[derive(Clone, Debug, Default)]
pub struct Noise(u64);

impl Noise {
    /// In [-1, 1).
    pub fn number(&mut self) -> f64 {
        // Knuth's linear congruential generator, upper bits.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / f64::from(1_u32 << 30) - 1.0
    }

    /// Every component in [-1, 1).
    pub fn vector<const D: usize>(&mut self) -> Vector<f64, D> {
        Vector::from_fn(|_, _| self.number())
    }
}
