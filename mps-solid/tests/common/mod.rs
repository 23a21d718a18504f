//! Bodies and small tools shared by the tests.
#![allow(dead_code, unreachable_pub)]

use mps_kernel::{Real, Tensor, Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::{ConstitutiveModel, Solid, SolidConfig};

/// Reproducible noise in [-0.5, 0.5).
pub struct Noise(u64);

impl Noise {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(1))
    }

    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / (1_u64 << 31) as f64 - 0.5
    }

    pub fn vector<T: Real, const D: usize>(&mut self) -> Vector<T, D> {
        Vector::from_fn(|_, _| T::of(self.next()))
    }

    pub fn tensor<T: Real, const D: usize>(&mut self) -> Tensor<T, D> {
        Tensor::from_fn(|_, _| T::of(self.next()))
    }
}

/// A rotation by `angle` in the plane of the first two axes, and in 3D by half of it in the next plane.
pub fn rotation<T: Real, const D: usize>(angle: f64) -> Tensor<T, D> {
    let plane = |a: usize, b: usize, angle: f64| {
        let mut r = Tensor::<T, D>::identity();
        r[(a, a)] = T::of(angle.cos());
        r[(b, b)] = T::of(angle.cos());
        r[(a, b)] = T::of(-angle.sin());
        r[(b, a)] = T::of(angle.sin());
        r
    };
    if D == 3 { plane(0, 1, angle) * plane(1, 2, 0.5 * angle) } else { plane(0, 1, angle) }
}

/// A block with spacings near `l0 = 0.01` that differ a little from axis to axis.
pub fn block<T: Real, const D: usize, M: ConstitutiveModel<T, D>>(
    counts: [usize; D],
    clamp: &[Face],
    material: M,
) -> Solid<T, D, M> {
    let upper =
        Vector::<T, D>::from_fn(|axis, _| T::of(0.01 * (1.0 + 0.02 * axis as f64) * counts[axis] as f64));
    let body = body::block(Vector::zeros(), upper, counts, clamp).unwrap();
    let parallel = Parallel::serial();
    let config = SolidConfig::default();
    Solid::new(body.particles, body.spacing, T::of(1000.0), material, WendlandC2, config, &parallel).unwrap()
}

/// Moves every particle to `place(X)` and brings the forces up to date.
pub fn deform<T: Real, const D: usize, M: ConstitutiveModel<T, D>>(
    solid: &mut Solid<T, D, M>,
    mut place: impl FnMut(&Vector<T, D>) -> Vector<T, D>,
) {
    let reference = solid.particles().reference_positions().to_vec();
    for (x, x0) in solid.positions_mut().iter_mut().zip(&reference) {
        *x = place(x0);
    }
    solid.refresh(&Parallel::serial()).unwrap();
}

/// Strain and bending energy [J].
pub fn stored<T: Real, const D: usize, M: ConstitutiveModel<T, D>>(solid: &Solid<T, D, M>) -> T {
    let energy = solid.energy(&Parallel::serial(), &Vector::zeros());
    energy.strain + energy.bending
}
