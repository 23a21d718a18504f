//! Poor neighbourhoods are refused, coincident particles bounded; nothing is ever NaN.

use crate::common::{Cloud, Noise, Weight, scene};
use mps_kernel::operators::{
    ConservativeDivergence, ConservativeGradient, Corrected, DiffusionFilter, Divergence, Gradient,
    Laplacian, MomentMatrix, NumberDensity, invert_moment,
};
use mps_kernel::{Real, Tensor, Vector, apply};
use proptest::prelude::*;

const SPACING: f64 = 0.01;

/// A particle at the origin with neighbours at the given places, in spacings; radius 3 spacings.
fn around<T: Real, const D: usize>(weight: Weight, neighbours: &[Vector<T, D>]) -> Cloud<T, D> {
    let mut at = vec![Vector::zeros()];
    at.extend(neighbours.iter().map(|x| x * T::of(SPACING)));
    Cloud::new(at, weight, SPACING, 3.0)
}

fn refused<T: Real, const D: usize>(cloud: &Cloud<T, D>, what: &str) -> Result<(), TestCaseError> {
    let moment = apply(&MomentMatrix { factor: cloud.factor() }, cloud, 0, &cloud.at);
    prop_assert!(moment.iter().all(|x| x.is_finite()), "{what}: {moment}");
    let correction = cloud.correction(0);
    prop_assert!(correction.is_degenerate(), "{what}: {correction:?}");
    prop_assert_eq!(correction.matrix(), Tensor::<T, D>::identity());
    // The fall-backs: the gradient as it is, or none at all.
    let gradient = Vector::<T, D>::from_fn(|k, _| T::of(k as f64 + 1.0));
    prop_assert_eq!(correction * gradient, gradient);
    prop_assert_eq!(correction.corrected_or_zero(&gradient), Vector::<T, D>::zeros());
    Ok(())
}

fn refuses_poor_neighbourhoods<T: Real, const D: usize>(
    weight: Weight,
    seed: u64,
) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed);
    let along = noise.direction::<T, D>();
    refused(&around::<T, D>(weight, &[]), "nobody")?;
    refused(&around::<T, D>(weight, &[along * noise.between::<T>(3.01, 9.0)]), "nobody in reach")?;
    refused(&around::<T, D>(weight, &[along * noise.between::<T>(0.0, 2.9)]), "one neighbour")?;
    refused(&around::<T, D>(weight, &[Vector::<T, D>::zeros(); 5]), "coincident neighbours")?;

    let places = noise.numbers::<T>(8, -2.9, 2.9);
    let line: Vec<_> = places.iter().map(|s| along * *s).collect();
    refused(&around::<T, D>(weight, &line), "a line")?;
    // Less than 0.05 off the line at distances above 0.5 keeps the condition number above 100.
    let apart = |s: T| if s < T::zero() { s - T::of(0.5) } else { s + T::of(0.5) };
    let nearly: Vec<_> = places
        .iter()
        .map(|s| along * apart(*s * T::of(0.8)) + noise.direction::<T, D>() * T::of(0.05))
        .collect();
    refused(&around::<T, D>(weight, &nearly), "nearly a line")?;

    if D == 3 {
        let other = noise.direction::<T, D>();
        let plane: Vec<_> = (0..9)
            .map(|_| along * noise.between::<T>(-2.0, 2.0) + other * noise.between::<T>(-0.8, 0.8))
            .collect();
        refused(&around::<T, D>(weight, &plane), "a plane")?;
    }
    Ok(())
}

/// The poorest neighbourhood that still spans the space: as many neighbours as there are directions.
fn accepts_what_spans<T: Real, const D: usize>(weight: Weight, seed: u64) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed);
    let axes: [Vector<T, D>; D] = std::array::from_fn(|k| {
        Vector::from_fn(|row, _| if row == k { noise.between(0.9, 1.1) } else { T::zero() })
    });
    let cloud = around(weight, &axes);
    let slope = noise.direction::<T, D>();
    let field: Vec<T> = cloud.at.iter().map(|x| slope.dot(x)).collect();
    let correction = cloud.correction(0);
    prop_assert!(matches!(correction, Corrected::Full(_)));
    prop_assert!(!correction.is_degenerate());
    let gradient = apply(&Gradient { factor: cloud.factor() }, &cloud, 0, &field);
    prop_assert_eq!(correction.corrected_or_zero(&gradient), correction * gradient);
    let error = (correction * gradient - slope).norm().to_double();
    prop_assert!(error <= 100.0 * crate::common::epsilon::<T>(), "{error:e}");
    Ok(())
}

/// Particles on top of each other, in twos and all together, among others.
fn stays_finite<T: Real, const D: usize>(weight: Weight, seed: u64) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed);
    let mut places: Vec<Vector<T, D>> = (0..6).map(|_| noise.vector() * T::of(1.5)).collect();
    let tiny = noise.vector::<T, D>() * T::of(1e-30);
    places.extend([places[0], places[0], places[1], places[1] + tiny, tiny, Vector::zeros()]);
    let cloud = around(weight, &places);
    let count = cloud.at.len();
    let (p, n): (Vec<T>, Vec<T>) = (noise.numbers(count, -1e5, 1e5), noise.numbers(count, 0.1, 30.0));
    let u: Vec<Vector<T, D>> = noise.vectors(count);
    let factor = cloud.factor();
    let laplacian = cloud.reference().laplacian_factor::<D>();
    let zip = |a: &[T], b: &[T]| -> Vec<(T, T)> { a.iter().copied().zip(b.iter().copied()).collect() };
    let weighted: Vec<_> = u.iter().copied().zip(n.iter().copied()).collect();
    let densities: Vec<_> = n.iter().copied().zip(u.iter().copied()).collect();

    let mut scalars = cloud.each(&NumberDensity, &p);
    scalars.extend(cloud.each(&Divergence { factor }, &u));
    scalars.extend(cloud.each(&ConservativeDivergence { factor }, &weighted));
    scalars.extend(cloud.each(&DiffusionFilter { factor }, &densities));
    let mut vectors = cloud.each(&Gradient { factor }, &p);
    vectors.extend(cloud.each(&ConservativeGradient { factor }, &zip(&p, &n)));
    vectors.extend(cloud.each(&Laplacian { factor: laplacian }, &u));
    vectors.extend((0..count).map(|i| cloud.correction(i) * vectors[i]).collect::<Vec<_>>());
    prop_assert!(scalars.iter().all(|x| x.is_finite()), "{scalars:?}");
    prop_assert!(vectors.iter().flatten().all(|x| x.is_finite()), "{vectors:?}");
    Ok(())
}

proptest! {
    #[test]
    fn poor_neighbourhoods_are_refused(seed: u64) {
        for weight in Weight::ALL {
            refuses_poor_neighbourhoods::<f64, 2>(weight, seed)?;
            refuses_poor_neighbourhoods::<f64, 3>(weight, seed)?;
            refuses_poor_neighbourhoods::<f32, 2>(weight, seed)?;
            refuses_poor_neighbourhoods::<f32, 3>(weight, seed)?;
        }
    }

    #[test]
    fn neighbourhoods_that_span_the_space_are_accepted(seed: u64) {
        for weight in Weight::ALL {
            accepts_what_spans::<f64, 2>(weight, seed)?;
            accepts_what_spans::<f64, 3>(weight, seed)?;
            accepts_what_spans::<f32, 2>(weight, seed)?;
            accepts_what_spans::<f32, 3>(weight, seed)?;
        }
    }

    #[test]
    fn operators_stay_finite_on_coincident_particles(seed: u64) {
        for weight in Weight::ALL {
            stays_finite::<f64, 2>(weight, seed)?;
            stays_finite::<f64, 3>(weight, seed)?;
            stays_finite::<f32, 2>(weight, seed)?;
            stays_finite::<f32, 3>(weight, seed)?;
        }
    }

    /// Two particles that meet lose their pull on each other, whatever the pressure: the weight does
    /// not part them again. That is the business of a collision model.
    #[test]
    fn coincident_pairs_do_not_push(pressure in -1e6..1e6f64, scene in scene()) {
        let cloud = around::<f64, 2>(scene.weight, &[Vector::zeros()]);
        let field = [(pressure, 1.0), (pressure, 1.1)];
        let operator = ConservativeGradient { factor: cloud.factor() };
        prop_assert_eq!(apply(&operator, &cloud, 0, &field), Vector::<f64, 2>::zeros());
    }
}

#[test]
fn moments_that_are_not_numbers_are_refused() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut moment = Tensor::<f64, 2>::identity();
        moment[(0, 1)] = bad;
        assert!(invert_moment(&moment, 0.05).is_degenerate());
        let mut moment = Tensor::<f32, 3>::identity();
        moment[(2, 2)] = bad as f32;
        assert!(invert_moment(&moment, 0.05).is_degenerate());
    }
}

/// The condition numbers the default limit of 0.05 stops at.
#[test]
fn limit_stands_for_a_condition_number() {
    let plane = |small: f64| Tensor::<f64, 2>::from_diagonal(&Vector::from([1.0, small]));
    assert!(!invert_moment(&plane(1.0 / 39.0), 0.05).is_degenerate());
    assert!(invert_moment(&plane(1.0 / 41.0), 0.05).is_degenerate());
    let sheet = |small: f64| Tensor::<f64, 3>::from_diagonal(&Vector::from([1.0, 1.0, small]));
    assert!(!invert_moment(&sheet(1.0 / 36.0), 0.05).is_degenerate());
    assert!(invert_moment(&sheet(1.0 / 37.0), 0.05).is_degenerate());
    let rod = |small: f64| Tensor::<f64, 3>::from_diagonal(&Vector::from([1.0, small, small]));
    assert!(!invert_moment(&rod(1.0 / 10.0), 0.05).is_degenerate());
    assert!(invert_moment(&rod(1.0 / 10.3), 0.05).is_degenerate());
}
