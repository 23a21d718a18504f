//! Small tensors: the only file in which two dimensions differ from three.
//!
//! Pinned by `tests/properties/tensor.rs` and `tests/properties/polar.rs`.

use crate::{Real, Tensor};

/// Determinant of a 1x1, 2x2 or 3x3 tensor.
#[inline]
pub fn determinant<T: Real, const D: usize>(a: &Tensor<T, D>) -> T {
    match D {
        1 => a[(0, 0)],
        2 => a[(0, 0)] * a[(1, 1)] - a[(0, 1)] * a[(1, 0)],
        3 => {
            a[(0, 0)] * (a[(1, 1)] * a[(2, 2)] - a[(1, 2)] * a[(2, 1)])
                - a[(0, 1)] * (a[(1, 0)] * a[(2, 2)] - a[(1, 2)] * a[(2, 0)])
                + a[(0, 2)] * (a[(1, 0)] * a[(2, 1)] - a[(1, 1)] * a[(2, 0)])
        }
        _ => T::of(f64::NAN),
    }
}

/// Cofactor tensor `cof A`, with `A^-1 = (cof A)^T / det A`, for `D = 1, 2, 3`.
#[inline]
pub fn cofactor<T: Real, const D: usize>(a: &Tensor<T, D>) -> Tensor<T, D> {
    match D {
        1 => Tensor::identity(),
        2 => Tensor::from_fn(|i, j| {
            let minor = a[(1 - i, 1 - j)];
            if i == j { minor } else { -minor }
        }),
        _ => Tensor::from_fn(|i, j| {
            let (i1, i2) = ((i + 1) % 3, (i + 2) % 3);
            let (j1, j2) = ((j + 1) % 3, (j + 2) % 3);
            a[(i1, j1)] * a[(i2, j2)] - a[(i1, j2)] * a[(i2, j1)]
        }),
    }
}

/// Inverse of `a`, or `None` where it is singular or too nearly so to be trusted.
///
/// The measure is scale free: `|det A| <= limit * (|A|_F / sqrt(D))^D` is refused. For a symmetric
/// tensor with eigenvalues of similar size the ratio is near 1; for a collinear neighbourhood it is 0.
#[inline]
pub fn guarded_inverse<T: Real, const D: usize>(a: &Tensor<T, D>, limit: T) -> Option<Tensor<T, D>> {
    let (unit, scale) = unit_scale(a)?;
    let det = determinant(&unit);
    // Written so that NaN fails the test.
    if det.abs() > limit { Some(cofactor(&unit).transpose() / (det * scale)) } else { None }
}

/// `a` divided by its size `|A|_F / sqrt(D)`, and that size; `None` unless it is positive and finite.
///
/// What powers of a small or large tensor would lose to underflow or overflow stays in range.
#[inline]
fn unit_scale<T: Real, const D: usize>(a: &Tensor<T, D>) -> Option<(Tensor<T, D>, T)> {
    let scale = (a.norm_squared() / T::of(D as f64)).sqrt();
    (scale > T::zero() && scale.is_finite()).then(|| (a / scale, scale))
}

/// Rotation `R` of the polar decomposition `F = R U`.
///
/// In 2D it is closed form; otherwise the iteration of Higham (1986) with his scaling,
/// `R <- (g R + R^-T/g)/2`, `g^2 = |R^-1|_F / |R|_F`, which takes fewer than ten steps.
///
/// `None` if `F` is turned inside out (`det F <= 0`), not finite, or so flat that the rotation is not
/// determined: `det F` below 64 rounding units of `(|F|_F / sqrt(D))^D`.
pub fn polar_rotation<T: Real, const D: usize>(f: &Tensor<T, D>) -> Option<Tensor<T, D>> {
    let (unit, _) = unit_scale(f)?;
    // NaN is not upright either.
    let upright = determinant(&unit) > T::default_epsilon() * T::of(64.0);
    if !upright {
        return None;
    }
    if D == 2 {
        let (c, s) = (unit[(0, 0)] + unit[(1, 1)], unit[(1, 0)] - unit[(0, 1)]);
        let inverse = T::one() / (c * c + s * s).sqrt();
        let (c, s) = (c * inverse, s * inverse);
        return Some(Tensor::from_fn(|i, j| match (i, j) {
            (0, 1) => -s,
            (1, 0) => s,
            _ => c,
        }));
    }
    let mut rotation = unit;
    let tolerance = T::default_epsilon() * T::of(16.0);
    for _ in 0..20 {
        let inverse_transpose = cofactor(&rotation) / determinant(&rotation);
        let stretch = (inverse_transpose.norm() / rotation.norm()).sqrt();
        let next = (rotation * stretch + inverse_transpose / stretch) * T::of(0.5);
        let change = (next - rotation).norm();
        rotation = next;
        if change <= tolerance {
            return Some(rotation);
        }
    }
    None
}

/// Green-Lagrange strain `E = (F^T F - I)/2`.
#[inline]
pub fn green_lagrange<T: Real, const D: usize>(f: &Tensor<T, D>) -> Tensor<T, D> {
    (f.transpose() * f - Tensor::identity()) * T::of(0.5)
}

/// Largest eigenvalue of a symmetric tensor (first principal strain or stress).
///
/// To round-off in 2D. In 3D to round-off too, except next to a double largest eigenvalue, where the
/// closed form loses half the digits: `1e-8 |A|` in `f64`, `3e-4 |A|` in `f32`.
pub fn largest_eigenvalue<T: Real, const D: usize>(a: &Tensor<T, D>) -> T {
    let half = T::of(0.5);
    match D {
        1 => a[(0, 0)],
        2 => {
            let mean = (a[(0, 0)] + a[(1, 1)]) * half;
            let half_difference = (a[(0, 0)] - a[(1, 1)]) * half;
            let shear = (a[(0, 1)] + a[(1, 0)]) * half;
            mean + (half_difference * half_difference + shear * shear).sqrt()
        }
        _ => {
            // Trigonometric solution of the characteristic cubic (Smith 1961).
            let mean = a.trace() / T::of(3.0);
            let deviator = a - Tensor::identity() * mean;
            let p = (deviator.norm_squared() / T::of(6.0)).sqrt();
            if p <= T::default_epsilon() * a.norm() || p == T::zero() {
                return mean;
            }
            // Divided before the determinant: the cube of a small p would underflow.
            let r = (determinant(&(deviator / p)) * half).clamp(-T::one(), T::one());
            mean + T::of(2.0) * p * (r.acos() / T::of(3.0)).cos()
        }
    }
}
