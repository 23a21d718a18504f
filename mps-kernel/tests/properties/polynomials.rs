//! What the plain operators reproduce on a full square or cubic lattice, with every weight.
//!
//! The lattice is symmetric under reflection and under exchange of axes. Reflection cancels the even
//! parts of a gradient and the odd parts of a Laplacian, exchange makes the second moments equal,
//! `sum_j r (x) r W = (n0 lambda0 / D) I`. So
//!
//! - gradient and divergence (eqs. 14, 15) are exact for quadratic fields, and wrong for cubic ones;
//! - the Laplacians (eq. 16 with `lambda0` as summed over the same lattice, and that of near neighbours) are exact for cubic
//!   fields, and wrong for quartic ones.
//!
//! Neither depends on the weight: the rational one is no worse than the smooth ones here.

use crate::common::{Cloud, Noise, Scene, Weight, close, epsilon, scene};
use mps_kernel::operators::{CompactLaplacian, ConservativeDivergence, Divergence, Gradient, Laplacian};
use mps_kernel::{Real, Tensor, Vector, apply, small};
use proptest::prelude::*;

/// `a + b.x + x.H x/2 + (c.x)^3`, in units of the spacing.
struct Polynomial<T: Real, const D: usize> {
    constant: T,
    slope: Vector<T, D>,
    curvature: Tensor<T, D>,
    cubic: Vector<T, D>,
}

impl<T: Real, const D: usize> Polynomial<T, D> {
    fn random(noise: &mut Noise) -> Self {
        let half = Tensor::<T, D>::from_fn(|_, _| noise.between::<T>(-0.5, 0.5));
        Self {
            constant: noise.between(-2.0, 2.0),
            slope: noise.vector(),
            curvature: half + half.transpose(),
            cubic: noise.vector(),
        }
    }

    fn quadratic(&self, x: &Vector<T, D>) -> T {
        self.constant + self.slope.dot(x) + x.dot(&(self.curvature * x)) * T::of(0.5)
    }

    fn full(&self, x: &Vector<T, D>) -> T {
        let c = self.cubic.dot(x);
        self.quadratic(x) + c * c * c
    }
}

/// A block around one particle whose neighbourhood is full, at coordinates in units of the spacing.
fn full_neighbourhood<T: Real, const D: usize>(scene: &Scene) -> (Cloud<T, D>, Vec<Vector<T, D>>) {
    // The cut Gaussian jumps at its rim, so that rounding would pick the neighbours at 3 spacings.
    let on_rim = scene.weight == Weight::Gaussian && scene.ratio == 3.0;
    let ratio = if on_rim { 3.1 } else { scene.ratio };
    let cloud = Cloud::lattice(scene.weight, scene.spacing, ratio, 9);
    let in_spacings = Cloud::lattice(scene.weight, 1.0, ratio, 9).at;
    (cloud, in_spacings)
}

/// Hundred terms of size at most 30 (a cubic of 3 spacings in 3D more: the caller multiplies).
const ROUNDINGS: f64 = 1000.0;

fn first_order<T: Real, const D: usize>(scene: &Scene) -> Result<(), TestCaseError> {
    let (cloud, at) = full_neighbourhood::<T, D>(scene);
    let (i, spacing) = (cloud.middle(), cloud.spacing.to_double());
    let mut noise = Noise(scene.seed);
    let components: [Polynomial<T, D>; D] = std::array::from_fn(|_| Polynomial::random(&mut noise));
    let tolerance = ROUNDINGS * epsilon::<T>();

    let gradient = Gradient { factor: cloud.factor() };
    for polynomial in &components {
        let field: Vec<T> = at.iter().map(|x| polynomial.quadratic(x)).collect();
        let found = apply(&gradient, &cloud, i, &field) * cloud.spacing;
        let error = (found - polynomial.slope).norm().to_double();
        prop_assert!(error <= tolerance, "gradient off by {error:e}, allowed {tolerance:e}");
    }

    let field: Vec<Vector<T, D>> =
        at.iter().map(|x| Vector::from_fn(|k, _| components[k].quadratic(x))).collect();
    let expected: f64 = (0..D).map(|k| components[k].slope[k].to_double()).sum();
    let found = apply(&Divergence { factor: cloud.factor() }, &cloud, i, &field);
    close("divergence", found.to_double() * spacing, expected, tolerance)?;
    // The weighted form is the same where the density is uniform, whatever its value.
    let density = noise.between::<T>(0.5, 30.0);
    let weighted: Vec<_> = field.iter().map(|u| (*u, density)).collect();
    let found = apply(&ConservativeDivergence { factor: cloud.factor() }, &cloud, i, &weighted);
    close("weighted divergence", found.to_double() * spacing, expected, tolerance)
}

fn second_order<T: Real, const D: usize>(scene: &Scene) -> Result<(), TestCaseError> {
    let (cloud, at) = full_neighbourhood::<T, D>(scene);
    let mut noise = Noise(scene.seed);
    let components: [Polynomial<T, D>; D] = std::array::from_fn(|_| Polynomial::random(&mut noise));
    let field: Vec<Vector<T, D>> = at.iter().map(|x| Vector::from_fn(|k, _| components[k].full(x))).collect();
    let operator = Laplacian { factor: cloud.reference().laplacian_factor::<D>() };
    let compact = CompactLaplacian { factor: cloud.factor() * T::of(2.0) };
    let square = cloud.spacing * cloud.spacing;
    let found = apply(&operator, &cloud, cloud.middle(), &field) * square;
    let near = apply(&compact, &cloud, cloud.middle(), &field) * square;
    for k in 0..D {
        let expected = components[k].curvature.trace().to_double();
        let tolerance = 10.0 * ROUNDINGS * epsilon::<T>();
        close("Laplacian", found[k].to_double(), expected, tolerance)?;
        close("Laplacian of near neighbours", near[k].to_double(), expected, tolerance)?;
    }
    Ok(())
}

/// `(n0 lambda0 / D) I`, on which the Laplacian rests, and `(n0 / D) I`, on which the gradient does.
fn moments_are_isotropic<T: Real, const D: usize>(scene: &Scene) -> Result<(), TestCaseError> {
    let (cloud, _) = full_neighbourhood::<T, D>(scene);
    let reference = cloud.reference();
    let (mut first, mut second) = (Tensor::<T, D>::zeros(), Tensor::<T, D>::zeros());
    for (i, pair) in cloud.pairs() {
        if i == cloud.middle() {
            first += small::outer(&pair.gradient_vector(), &pair.r_ij);
            second += small::outer(&pair.r_ij, &pair.r_ij) * pair.weight;
        }
    }
    let dimension = T::of(D as f64);
    let tolerance = 100.0 * epsilon::<T>();
    let first = (first * (dimension / reference.n0) - Tensor::identity()).norm().to_double();
    let second = second * (dimension / (reference.n0 * reference.lambda0)) - Tensor::identity();
    prop_assert!(first <= tolerance, "{first:e}");
    prop_assert!(second.norm().to_double() <= tolerance, "{second}");
    Ok(())
}

proptest! {
    #[test]
    fn gradient_and_divergence_are_exact_for_quadratic_fields(scene in scene()) {
        first_order::<f64, 2>(&scene)?;
        first_order::<f64, 3>(&scene)?;
        first_order::<f32, 2>(&scene)?;
        first_order::<f32, 3>(&scene)?;
    }

    #[test]
    fn laplacians_are_exact_for_cubic_fields(scene in scene()) {
        second_order::<f64, 2>(&scene)?;
        second_order::<f64, 3>(&scene)?;
        second_order::<f32, 2>(&scene)?;
        second_order::<f32, 3>(&scene)?;
    }

    #[test]
    fn moments_of_the_lattice_are_isotropic(scene in scene()) {
        moments_are_isotropic::<f64, 2>(&scene)?;
        moments_are_isotropic::<f64, 3>(&scene)?;
        moments_are_isotropic::<f32, 2>(&scene)?;
        moments_are_isotropic::<f32, 3>(&scene)?;
    }
}

/// The first order that is not reproduced, and by how much: for the rational weight and `re = 3 l0`
/// the gradient of `x^3` at the origin is `sum x^4 W/r^2` over `sum x^2 W/r^2`, not zero.
#[test]
fn cubic_gradient_and_quartic_laplacian_are_not_exact() {
    for weight in Weight::ALL {
        let cloud = Cloud::<f64, 2>::lattice(weight, 1.0, 3.0, 7);
        let cubic: Vec<f64> = cloud.at.iter().map(|x| x[0].powi(3)).collect();
        let gradient = apply(&Gradient { factor: cloud.factor() }, &cloud, cloud.middle(), &cubic);
        assert!(gradient[0] > 0.9, "{weight:?}: {gradient}");
        let quartic: Vec<_> = cloud.at.iter().map(|x| Vector::from([x[0].powi(4), 0.0])).collect();
        let operator = Laplacian { factor: cloud.reference().laplacian_factor::<2>() };
        let laplacian = apply(&operator, &cloud, cloud.middle(), &quartic);
        assert!(laplacian[0] > 0.9, "{weight:?}: {laplacian}");
    }
}
