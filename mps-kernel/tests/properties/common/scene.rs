use mps_kernel::weights::{Gaussian, Rational, Spiky, WendlandC2, WendlandGradient};
use mps_kernel::{Kernel, Number, Real, Vector};
use proptest::prelude::*;

/// Every weight of the crate, chosen at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Weight {
    Rational,
    WendlandC2,
    WendlandGradient,
    Spiky,
    Gaussian,
}

impl Weight {
    pub(crate) const ALL: [Self; 5] =
        [Self::Rational, Self::WendlandC2, Self::WendlandGradient, Self::Spiky, Self::Gaussian];
}

impl<T: Real> Kernel<T> for Weight {
    fn weight<N: Number<T>>(&self, r: N, re: T) -> N {
        match self {
            Self::Rational => Rational.weight(r, re),
            Self::WendlandC2 => WendlandC2.weight(r, re),
            Self::WendlandGradient => WendlandGradient.weight(r, re),
            Self::Spiky => Spiky.weight(r, re),
            Self::Gaussian => Gaussian.weight(r, re),
        }
    }

    fn weight_and_over_r2<N: Number<T>>(&self, r2: N, re: T) -> (N, N) {
        match self {
            Self::Rational => Rational.weight_and_over_r2(r2, re),
            Self::WendlandC2 => WendlandC2.weight_and_over_r2(r2, re),
            Self::WendlandGradient => WendlandGradient.weight_and_over_r2(r2, re),
            Self::Spiky => Spiky.weight_and_over_r2(r2, re),
            Self::Gaussian => Gaussian.weight_and_over_r2(r2, re),
        }
    }

    fn name(&self) -> &'static str {
        match self {
            Self::Rational => Kernel::<T>::name(&Rational),
            Self::WendlandC2 => Kernel::<T>::name(&WendlandC2),
            Self::WendlandGradient => Kernel::<T>::name(&WendlandGradient),
            Self::Spiky => Kernel::<T>::name(&Spiky),
            Self::Gaussian => Kernel::<T>::name(&Gaussian),
        }
    }
}

/// What a random particle set is built from: small enough to be read in a regression file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scene {
    pub(crate) weight: Weight,
    /// Effective radius over spacing.
    pub(crate) ratio: f64,
    /// Spacing \[m\].
    pub(crate) spacing: f64,
    /// Largest displacement of a particle from its lattice point, in spacings and along each axis.
    pub(crate) jitter: f64,
    pub(crate) seed: u64,
}

/// Scenes with every weight, radii of 1.5 to 3.2 spacings and spacings from 0.1 mm to 100 m.
pub(crate) fn scene() -> impl Strategy<Value = Scene> {
    let weight = prop::sample::select(Weight::ALL.as_slice());
    let ratio = prop_oneof![4 => 1.5..3.2, 1 => Just(3.0)]
        .prop_filter("a lattice point is on the rim", clears_the_rim);
    (weight, ratio, -4.0..2.0, 0.0..0.35, any::<u64>()).prop_map(|(weight, ratio, exponent, jitter, seed)| {
        Scene { weight, ratio, spacing: f64::powf(10.0, exponent), jitter, seed }
    })
}

/// Whether no lattice point is inside the radius by so little that the reference density, by its convention, counts it as on the rim, while
/// a pair at this distance is one: a weight that jumps there would have two sums.
fn clears_the_rim(ratio: &f64) -> bool {
    let rim = 32.0 * f64::from(f32::EPSILON);
    (2..=10).map(f64::from).all(|square| *ratio <= square.sqrt() || ratio * ratio * (1.0 - rim) > square)
}

/// Numbers without a pattern, the same for the same seed (SplitMix64).
#[derive(Clone, Debug)]
pub(crate) struct Noise(pub(crate) u64);

impl Noise {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number in `[low, high)`.
    pub(crate) fn between<T: Real>(&mut self, low: f64, high: f64) -> T {
        T::of(low + (high - low) * (self.bits() >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// A vector with components in `[-1, 1)`.
    pub(crate) fn vector<T: Real, const D: usize>(&mut self) -> Vector<T, D> {
        Vector::from_fn(|_, _| self.between(-1.0, 1.0))
    }

    /// A vector of length one.
    pub(crate) fn direction<T: Real, const D: usize>(&mut self) -> Vector<T, D> {
        loop {
            let candidate = self.vector::<T, D>();
            let length = candidate.norm().to_double();
            if length > 0.1 && length < 1.0 {
                return candidate / candidate.norm();
            }
        }
    }

    /// `count` numbers in `[low, high)`.
    pub(crate) fn numbers<T: Real>(&mut self, count: usize, low: f64, high: f64) -> Vec<T> {
        (0..count).map(|_| self.between(low, high)).collect()
    }

    /// `count` vectors with components in `[-1, 1)`.
    pub(crate) fn vectors<T: Real, const D: usize>(&mut self, count: usize) -> Vec<Vector<T, D>> {
        (0..count).map(|_| self.vector()).collect()
    }
}
