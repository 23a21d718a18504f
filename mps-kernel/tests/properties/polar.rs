//! The rotation of the polar decomposition, `F = R U`.

use crate::common::{Noise, epsilon};
use mps_kernel::tensor::{determinant, largest_eigenvalue, polar_rotation};
use mps_kernel::{Real, Tensor, Vector};
use proptest::prelude::*;

/// A rotation by any angle, about any axis in 3D.
fn rotation<T: Real, const D: usize>(noise: &mut Noise) -> Tensor<T, D> {
    let angle = noise.between::<T>(-3.15, 3.15);
    let (s, c) = (angle.sin(), angle.cos());
    let axis = if D == 3 { noise.direction::<T, D>() } else { Vector::zeros() };
    // Rodrigues in 3D; in 2D the axis is the normal of the plane.
    Tensor::from_fn(|i, j| {
        let diagonal = if i == j { c } else { T::zero() };
        if D == 2 {
            return if i == j {
                diagonal
            } else if i < j {
                -s
            } else {
                s
            };
        }
        let cross = match (i, j) {
            (0, 1) => -axis[2],
            (1, 0) => axis[2],
            (0, 2) => axis[1],
            (2, 0) => -axis[1],
            (1, 2) => -axis[0],
            (2, 1) => axis[0],
            _ => T::zero(),
        };
        diagonal + s * cross + (T::one() - c) * axis[i] * axis[j]
    })
}

/// `R S` with a stretch `S` of eigenvalues between `least` and one, times `size`.
fn deformation<T: Real, const D: usize>(
    noise: &mut Noise,
    least: f64,
    size: f64,
) -> (Tensor<T, D>, Tensor<T, D>) {
    let (q, r) = (rotation::<T, D>(noise), rotation::<T, D>(noise));
    let mut stretches = Vector::<T, D>::from_fn(|_, _| noise.between(least, 1.0));
    stretches[0] = T::one();
    (r * q * Tensor::from_diagonal(&(stretches * T::of(size))) * q.transpose(), r)
}

/// `R^T R = I`, `det R = 1`, `R^T F` symmetric and positive.
fn is_polar<T: Real, const D: usize>(f: &Tensor<T, D>, r: &Tensor<T, D>) -> Result<(), TestCaseError> {
    let unit = 32.0 * epsilon::<T>();
    let defect = (r.transpose() * r - Tensor::identity()).norm().to_double();
    prop_assert!(defect <= unit, "R^T R off by {defect:e}");
    prop_assert!((determinant(r).to_double() - 1.0).abs() <= unit);
    let stretch = r.transpose() * f;
    let size = f.norm().to_double();
    let skew = (stretch - stretch.transpose()).norm().to_double();
    prop_assert!(skew <= unit * size, "R^T F off symmetry by {:e}", skew / size);
    // The smallest eigenvalue is minus the largest of -U; flat ones are zero to rounding.
    let least = -largest_eigenvalue(&-stretch).to_double();
    prop_assert!(least > -4.0 * epsilon::<T>().sqrt() * size, "smallest stretch {least:e} of {size:e}");
    Ok(())
}

fn decomposes<T: Real, const D: usize>(seed: u64, size: f64) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed);
    let (f, expected) = deformation::<T, D>(&mut noise, 0.05, size);
    let found = polar_rotation(&f).unwrap();
    is_polar(&f, &found)?;
    let error = (found - expected).norm().to_double();
    prop_assert!(error <= 400.0 * epsilon::<T>(), "rotation off by {error:e}");
    // Any other deformation that is not turned inside out.
    let f = Tensor::<T, D>::from_fn(|_, _| noise.between::<T>(-1.0, 1.0) * T::of(size));
    if determinant(&f).to_double() > 1e-3 * size.powi(D as i32) {
        is_polar(&f, &polar_rotation(&f).unwrap())?;
    }
    Ok(())
}

fn keeps_pure_rotations<T: Real, const D: usize>(seed: u64) -> Result<(), TestCaseError> {
    let r = rotation::<T, D>(&mut Noise(seed));
    let error = (polar_rotation(&r).unwrap() - r).norm().to_double();
    prop_assert!(error <= 8.0 * epsilon::<T>(), "off by {error:e}");
    let identity = Tensor::<T, D>::identity();
    let error = (polar_rotation(&identity).unwrap() - identity).norm().to_double();
    prop_assert!(error <= epsilon::<T>(), "identity off by {error:e}");
    Ok(())
}

/// One direction squeezed flat, down to where the guard stands: the rotation stays well determined.
fn squeezed<T: Real, const D: usize>(seed: u64, exponent: f64) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed);
    let (q, r) = (rotation::<T, D>(&mut noise), rotation::<T, D>(&mut noise));
    let mut stretches = Vector::<T, D>::from_element(T::one());
    // From 1 down to 1000 rounding units.
    stretches[0] = T::of((1e3 * epsilon::<T>()).powf(exponent));
    let f = r * q * Tensor::from_diagonal(&stretches) * q.transpose();
    let found = polar_rotation(&f).unwrap();
    is_polar(&f, &found)?;
    let error = (found - r).norm().to_double();
    prop_assert!(error <= 100.0 * epsilon::<T>(), "rotation off by {error:e}");
    Ok(())
}

fn refuses<T: Real, const D: usize>(seed: u64, size: f64) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed);
    let (f, _) = deformation::<T, D>(&mut noise, 0.2, size);
    let mut mirror = Tensor::<T, D>::identity();
    mirror[(D - 1, D - 1)] = -T::one();
    prop_assert!(polar_rotation(&(f * mirror)).is_none(), "inside out");
    mirror[(D - 1, D - 1)] = T::zero();
    prop_assert!(polar_rotation(&(f * mirror)).is_none(), "flat");
    mirror[(D - 1, D - 1)] = T::default_epsilon();
    prop_assert!(polar_rotation(&(f * mirror)).is_none(), "nearly flat");
    prop_assert!(polar_rotation(&Tensor::<T, D>::zeros()).is_none());
    let mut bad = f;
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        bad[(0, D - 1)] = T::of(value);
        prop_assert!(polar_rotation(&bad).is_none(), "{value}");
    }
    Ok(())
}

fn size() -> impl Strategy<Value = f64> {
    (-6.0..6.0).prop_map(|exponent| f64::powf(10.0, exponent))
}

proptest! {
    #[test]
    fn rotation_and_stretch_are_found(seed: u64, size in size()) {
        decomposes::<f64, 2>(seed, size)?;
        decomposes::<f64, 3>(seed, size)?;
        decomposes::<f32, 2>(seed, size)?;
        decomposes::<f32, 3>(seed, size)?;
    }

    #[test]
    fn pure_rotations_are_kept(seed: u64) {
        keeps_pure_rotations::<f64, 2>(seed)?;
        keeps_pure_rotations::<f64, 3>(seed)?;
        keeps_pure_rotations::<f32, 2>(seed)?;
        keeps_pure_rotations::<f32, 3>(seed)?;
    }

    #[test]
    fn flat_deformations_keep_their_rotation(seed: u64, exponent in 0.0..1.0f64) {
        squeezed::<f64, 2>(seed, exponent)?;
        squeezed::<f64, 3>(seed, exponent)?;
        squeezed::<f32, 2>(seed, exponent)?;
        squeezed::<f32, 3>(seed, exponent)?;
    }

    #[test]
    fn inverted_and_singular_deformations_are_refused(seed: u64, size in size()) {
        refuses::<f64, 2>(seed, size)?;
        refuses::<f64, 3>(seed, size)?;
        refuses::<f32, 2>(seed, size)?;
        refuses::<f32, 3>(seed, size)?;
    }
}
