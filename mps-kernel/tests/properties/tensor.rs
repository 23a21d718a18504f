//! Determinant, cofactor, inverse, strain and the largest eigenvalue of small tensors.

use crate::common::{Noise, close, epsilon};
use mps_kernel::small::outer;
use mps_kernel::tensor::{cofactor, determinant, green_lagrange, guarded_inverse, largest_eigenvalue};
use mps_kernel::{Real, Tensor, Vector};
use nalgebra::DMatrix;
use proptest::prelude::*;

fn random<T: Real, const D: usize>(noise: &mut Noise, size: f64) -> Tensor<T, D> {
    Tensor::from_fn(|_, _| noise.between::<T>(-1.0, 1.0) * T::of(size))
}

fn in_doubles<T: Real, const D: usize>(a: &Tensor<T, D>) -> DMatrix<f64> {
    DMatrix::from_fn(D, D, |i, j| a[(i, j)].to_double())
}

fn determinant_and_cofactor<T: Real, const D: usize>(seed: u64, size: f64) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed);
    let (a, b) = (random::<T, D>(&mut noise, size), random::<T, D>(&mut noise, 1.0));
    let power = size.powi(D as i32);
    let tolerance = 64.0 * epsilon::<T>();
    let det = determinant(&a).to_double();
    close("determinant", det, in_doubles(&a).determinant(), tolerance * power)?;
    close("transpose", determinant(&a.transpose()).to_double(), det, tolerance * power)?;
    let product = determinant(&(a * b)).to_double();
    close("product", product, det * determinant(&b).to_double(), 8.0 * tolerance * power)?;
    // (a (x) b) c = a (b . c)
    let [u, v, w] = [0; 3].map(|_| noise.vector::<T, D>());
    prop_assert!((outer(&u, &v) * w - u * v.dot(&w)).norm().to_double() <= tolerance);
    // cof(A)^T A = det(A) I, and cof(A B) = cof(A) cof(B).
    let rest = cofactor(&a).transpose() * a - Tensor::identity() * determinant(&a);
    prop_assert!(rest.norm().to_double() <= tolerance * power, "{rest}");
    let rest = cofactor(&(a * b)) - cofactor(&a) * cofactor(&b);
    prop_assert!(rest.norm().to_double() <= 8.0 * tolerance * power / size, "{rest}");
    Ok(())
}

fn inverse<T: Real, const D: usize>(seed: u64, size: f64) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed);
    let a = random::<T, D>(&mut noise, size);
    let limit = 0.05;
    let unit = in_doubles(&a) / size;
    let quality = unit.determinant().abs() / (unit.norm() / (D as f64).sqrt()).powi(D as i32);
    let found = guarded_inverse(&a, T::of(limit));
    if (quality - limit).abs() > 1e-5 {
        prop_assert_eq!(found.is_some(), quality > limit, "{}", quality);
    }
    if let Some(found) = found {
        let rest = (found * a - Tensor::identity()).norm().to_double();
        prop_assert!(rest <= 64.0 * epsilon::<T>() / quality, "{rest:e}");
    }
    // Flat ones, made so by repeating a direction.
    let flat = a * (Tensor::identity() - Tensor::from_fn(|i, j| T::of(if i + j == 0 { 1.0 } else { 0.0 })));
    prop_assert!(guarded_inverse(&flat, T::of(1e-5)).is_none());
    Ok(())
}

fn eigenvalue<T: Real, const D: usize>(a: &Tensor<T, D>, accuracy: f64) -> Result<(), TestCaseError> {
    let expected = in_doubles(a).symmetric_eigenvalues().max();
    let size = in_doubles(a).norm();
    close("largest eigenvalue", largest_eigenvalue(a).to_double(), expected, accuracy * size)
}

fn eigenvalues<T: Real, const D: usize>(seed: u64, size: f64) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed);
    let half = random::<T, D>(&mut noise, size);
    let symmetric = half + half.transpose();
    let (sharp, blunt) = (64.0 * epsilon::<T>(), 4.0 * epsilon::<T>().sqrt());
    // Two equal largest eigenvalues cost half the digits in 3D; random ones are nearly never that near.
    eigenvalue(&symmetric, if D == 2 { sharp } else { blunt })?;
    // Uniaxial: one large eigenvalue, the others equal.
    let axis = noise.direction::<T, D>();
    let uniaxial = outer(&axis, &axis) * T::of(size);
    eigenvalue(&uniaxial, sharp)?;
    // Compressed along one axis: the largest eigenvalue is double in 3D.
    eigenvalue(&-uniaxial, blunt)?;
    // Isotropic, exactly and nearly.
    let isotropic = Tensor::identity() * T::of(size);
    eigenvalue(&isotropic, 2.0 * epsilon::<T>())?;
    eigenvalue(&(isotropic + symmetric * T::default_epsilon()), sharp)?;
    eigenvalue(&(isotropic * T::of(-3.0) + symmetric * T::of(1e-3)), blunt)?;
    prop_assert_eq!(largest_eigenvalue(&Tensor::<T, D>::zeros()), T::zero());
    Ok(())
}

/// Well separated eigenvalues are found to round-off: rotated diagonals 3, 1, -2.
fn separated<T: Real>(seed: u64, size: f64) -> Result<(), TestCaseError> {
    let axis = nalgebra::Unit::new_unchecked(Noise(seed).direction::<T, 3>());
    let q = nalgebra::Rotation3::from_axis_angle(&axis, T::of(seed as f64 * 1e-18)).into_inner();
    let diagonal = Tensor::from_diagonal(&(Vector::from([3.0, 1.0, -2.0]).map(T::of) * T::of(size)));
    let found = largest_eigenvalue(&(q * diagonal * q.transpose())).to_double();
    close("largest of 3, 1, -2", found, 3.0 * size, 64.0 * epsilon::<T>() * size)
}

fn strain<T: Real, const D: usize>(seed: u64) -> Result<(), TestCaseError> {
    let f = random::<T, D>(&mut Noise(seed), 2.0);
    let e = green_lagrange(&f);
    prop_assert!((e - e.transpose()).norm().to_double() <= 16.0 * epsilon::<T>());
    let expected = (in_doubles(&f).transpose() * in_doubles(&f) - DMatrix::identity(D, D)) * 0.5;
    prop_assert!((in_doubles(&e) - expected).norm() <= 64.0 * epsilon::<T>());
    prop_assert_eq!(green_lagrange(&Tensor::<T, D>::identity()), Tensor::<T, D>::zeros());
    Ok(())
}

/// Sizes at which powers of a tensor still fit into `f32`.
fn size() -> impl Strategy<Value = f64> {
    (-8.0..8.0).prop_map(|exponent| f64::powf(10.0, exponent))
}

proptest! {
    #[test]
    fn determinant_and_cofactor_keep_their_identities(seed: u64, size in size()) {
        determinant_and_cofactor::<f64, 2>(seed, size)?;
        determinant_and_cofactor::<f64, 3>(seed, size)?;
        determinant_and_cofactor::<f32, 2>(seed, size)?;
        determinant_and_cofactor::<f32, 3>(seed, size)?;
    }

    #[test]
    fn guarded_inverse_inverts_or_refuses(seed: u64, size in size()) {
        inverse::<f64, 2>(seed, size)?;
        inverse::<f64, 3>(seed, size)?;
        inverse::<f32, 2>(seed, size)?;
        inverse::<f32, 3>(seed, size)?;
        // Where the determinant itself would leave the range of the scalar.
        inverse::<f64, 3>(seed, size * 1e-120)?;
        inverse::<f64, 3>(seed, size * 1e120)?;
        inverse::<f32, 3>(seed, size.min(1.0) * 1e-8)?;
    }

    #[test]
    fn largest_eigenvalue_agrees_with_a_general_solver(seed: u64, size in size()) {
        eigenvalues::<f64, 2>(seed, size)?;
        eigenvalues::<f64, 3>(seed, size)?;
        eigenvalues::<f32, 2>(seed, size)?;
        eigenvalues::<f32, 3>(seed, size)?;
        // Strains of a stiff material in single precision: the cube of their size is below 1e-38.
        eigenvalues::<f32, 3>(seed, size * 1e-8)?;
        separated::<f64>(seed, size)?;
        separated::<f32>(seed, size)?;
    }

    #[test]
    fn green_lagrange_strain_is_symmetric(seed: u64) {
        strain::<f64, 2>(seed)?;
        strain::<f64, 3>(seed)?;
        strain::<f32, 2>(seed)?;
        strain::<f32, 3>(seed)?;
    }
}

#[test]
fn one_dimension_is_the_number_itself() {
    let a = Tensor::<f64, 1>::new(-4.0);
    assert_eq!((determinant(&a), cofactor(&a)[(0, 0)], largest_eigenvalue(&a)), (-4.0, 1.0, -4.0));
    assert_eq!(guarded_inverse(&a, 0.05).unwrap()[(0, 0)], -0.25);
}

#[test]
fn tensors_that_are_not_numbers_have_no_inverse() {
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(guarded_inverse(&Tensor::<f64, 3>::from_element(bad), 0.05).is_none());
    }
    assert!(guarded_inverse(&Tensor::<f64, 3>::zeros(), 0.0).is_none());
}
