//! The density filter (eq. 20) leaves quadratic fields alone, creates nothing and only damps.
//!
//! With corrected gradients `g` (eqs. 21, 22) the filter `F` satisfies, on *any* particles whose
//! neighbourhoods are full,
//!
//! ```text
//! sum_i m_i F(n)_i = -(D/n0) sum_ij W/r^2 (m_j - m_i - g(m)_i . r_ij) (n_j - n_i - g(n)_i . r_ij),
//! ```
//!
//! because `g` is the least-squares slope, so that its residual is orthogonal to every slope. So it
//! is symmetric and takes from `sum n_i^2` what the slopes leave unexplained: never a gain.

use crate::common::{Cloud, Noise, Scene, Weight, close, epsilon, scene};
use mps_kernel::operators::{Corrected, DiffusionFilter, Gradient, HydrostaticDiffusion};
use mps_kernel::{Real, Tensor, Vector, apply};
use proptest::prelude::*;

fn filter<T: Real, const D: usize>(cloud: &Cloud<T, D>) -> DiffusionFilter<T> {
    DiffusionFilter { factor: cloud.factor() * T::of(2.0) }
}

fn pack<T: Real, const D: usize>(n: &[T], g: &[Vector<T, D>]) -> Vec<(T, Vector<T, D>)> {
    n.iter().copied().zip(g.iter().copied()).collect()
}

/// On a lattice: `n` may bend by any quadratic, in units of the spacing.
fn ignores_quadratics<T: Real, const D: usize>(scene: &Scene) -> Result<(), TestCaseError> {
    // Three layers around the middle see three more layers each.
    let cloud = Cloud::<T, D>::lattice(scene.weight, scene.spacing, scene.ratio.min(2.1), 9);
    let mut noise = Noise(scene.seed);
    let (offset, slope) = (noise.between::<T>(-2.0, 2.0), noise.vector::<T, D>());
    let half = Tensor::<T, D>::from_fn(|_, _| noise.between(-0.5, 0.5));
    let fields: Vec<T> = cloud
        .at
        .iter()
        .map(|x| x / cloud.spacing)
        .map(|x| offset + slope.dot(&x) + x.dot(&(half * x)))
        .collect();

    let (i, gradient) = (cloud.middle(), Gradient { factor: cloud.factor() });
    let mut gradients = vec![Vector::zeros(); cloud.at.len()];
    let near = (T::of(2.01) * cloud.re).to_double();
    for j in (0..cloud.at.len()).filter(|&j| cloud.at[j].norm().to_double() < near / 2.0) {
        gradients[j] = cloud.correction(j) * apply(&gradient, &cloud, j, &fields);
    }
    let found = apply(&filter(&cloud), &cloud, i, &pack(&fields, &gradients));
    // In units of the spacing: terms of size 20, weights that sum to 2 D.
    let found = (found * cloud.spacing * cloud.spacing).to_double();
    close("filter of a quadratic", found, 0.0, 1000.0 * epsilon::<T>())
}

fn ignores_linears<T: Real, const D: usize>(cloud: &Cloud<T, D>, seed: u64) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed ^ 0x11);
    let slope = noise.direction::<T, D>() / cloud.spacing;
    let field: Vec<T> = cloud.at.iter().map(|x| slope.dot(x)).collect();
    let Some(gradients) = cloud.corrected_gradients(&field) else {
        return Ok(());
    };
    for (i, found) in cloud.each(&filter(cloud), &pack(&field, &gradients)).into_iter().enumerate() {
        let mut weights = 0.0;
        mps_kernel::Neighborhood::for_each(cloud, i, |pair| weights += pair.over_r2.to_double());
        let weights = weights * filter(cloud).factor.to_double();
        close("filter of a linear field", found.to_double(), 0.0, 4000.0 * epsilon::<T>() * weights)?;
    }
    Ok(())
}

/// Whatever the densities and even the gradients are.
fn creates_nothing<T: Real, const D: usize>(cloud: &Cloud<T, D>, seed: u64) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed ^ 0x22);
    let n: Vec<T> = noise.numbers(cloud.at.len(), 0.0, 30.0);
    let g: Vec<Vector<T, D>> = noise.vectors(cloud.at.len());
    let g: Vec<_> = g.iter().map(|g| g * T::of(10.0) / cloud.spacing).collect();
    let (mut total, mut size) = (0.0, 0.0);
    for (i, pair) in cloud.pairs() {
        let there = DiffusionFilter::pair(n[i], &g[i], n[pair.j], &g[pair.j], &pair);
        let back = mps_kernel::Pair { j: i, r_ij: -pair.r_ij, ..pair };
        prop_assert_eq!(there, -DiffusionFilter::pair(n[pair.j], &g[pair.j], n[i], &g[i], &back));
        size += there.to_double().abs();
    }
    let factor = filter(cloud).factor.to_double();
    total += cloud.each(&filter(cloud), &pack(&n, &g)).iter().map(|f| f.to_double()).sum::<f64>();
    close("sum over all particles", total, 0.0, 64.0 * epsilon::<T>() * size * factor)
}

/// The identity at the head of this file.
fn only_damps<T: Real, const D: usize>(cloud: &Cloud<T, D>, seed: u64) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed ^ 0x33);
    let fields: [Vec<T>; 2] = std::array::from_fn(|_| noise.numbers(cloud.at.len(), -1.0, 1.0));
    let (Some(gm), Some(gn)) = (cloud.corrected_gradients(&fields[0]), cloud.corrected_gradients(&fields[1]))
    else {
        return Ok(());
    };
    let [m, n] = &fields;
    let filter = filter(cloud);
    let filtered = cloud.each(&filter, &pack(n, &gn));
    let residual = |f: &[T], g: &[Vector<T, D>], i: usize, pair: &mps_kernel::Pair<T, D>| {
        (f[pair.j] - f[i] - g[i].dot(&pair.r_ij)).to_double()
    };
    let (mut mixed, mut own, mut size) = (0.0, 0.0, 0.0);
    for (i, pair) in cloud.pairs() {
        let weight = pair.over_r2.to_double() * filter.factor.to_double() / 2.0;
        let (a, b) = (residual(m, &gm, i, &pair), residual(n, &gn, i, &pair));
        mixed -= a * b * weight;
        own -= b * b * weight;
        let (ga, gb) = (gm[i].norm() * pair.r_ij.norm(), gn[i].norm() * pair.r_ij.norm());
        size += (2.0 + ga.to_double()) * (2.0 + gb.to_double()) * weight;
    }
    let dot = |a: &[T]| -> f64 { a.iter().zip(&filtered).map(|(a, b)| a.to_double() * b.to_double()).sum() };
    let tolerance = 1000.0 * epsilon::<T>() * size;
    close("m . F(n)", dot(m), mixed, tolerance)?;
    close("n . F(n)", dot(n), own, tolerance)?;
    prop_assert!(own < 0.0);
    Ok(())
}

/// Everything to do with poor neighbourhoods: no gradient handed over, no gain.
fn damps_degenerate_sets<const D: usize>(cloud: &Cloud<f64, D>, seed: u64) -> Result<(), TestCaseError> {
    let n: Vec<f64> = Noise(seed ^ 0x44).numbers(cloud.at.len(), -1.0, 1.0);
    let gradients = cloud.each(&Gradient { factor: cloud.factor() }, &n);
    let safe: Vec<_> =
        gradients.iter().enumerate().map(|(i, g)| cloud.correction(i).corrected_or_zero(g)).collect();
    let filtered = cloud.each(&filter(cloud), &pack(&n, &safe));
    let gain: f64 = n.iter().zip(&filtered).map(|(n, f)| n * f).sum();
    let size: f64 = n.iter().zip(&filtered).map(|(n, f)| (n * f).abs()).sum();
    prop_assert!(gain <= 1e-9 * size, "gained {gain:e} of {size:e}");
    Ok(())
}

proptest! {
    #[test]
    fn filter_ignores_quadratic_fields_on_a_lattice(scene in scene()) {
        ignores_quadratics::<f64, 2>(&scene)?;
        ignores_quadratics::<f64, 3>(&scene)?;
        ignores_quadratics::<f32, 2>(&scene)?;
        ignores_quadratics::<f32, 3>(&scene)?;
    }

    #[test]
    fn filter_ignores_linear_fields_on_full_neighbourhoods(scene in scene()) {
        ignores_linears(&Cloud::<f64, 2>::jittered(&scene, 7), scene.seed)?;
        ignores_linears(&Cloud::<f64, 3>::jittered(&scene, 4), scene.seed)?;
        ignores_linears(&Cloud::<f32, 2>::jittered(&scene, 7), scene.seed)?;
        ignores_linears(&Cloud::<f32, 3>::jittered(&scene, 4), scene.seed)?;
    }

    #[test]
    fn filter_creates_nothing(scene in scene()) {
        creates_nothing(&Cloud::<f64, 2>::jittered(&scene, 6), scene.seed)?;
        creates_nothing(&Cloud::<f64, 3>::scattered(&scene, 4), scene.seed)?;
        creates_nothing(&Cloud::<f32, 2>::scattered(&scene, 6), scene.seed)?;
        creates_nothing(&Cloud::<f32, 3>::jittered(&scene, 4), scene.seed)?;
    }

    #[test]
    fn filter_is_symmetric_and_only_damps(scene in scene()) {
        only_damps(&Cloud::<f64, 2>::jittered(&scene, 7), scene.seed)?;
        only_damps(&Cloud::<f64, 3>::jittered(&scene, 4), scene.seed)?;
        only_damps(&Cloud::<f32, 2>::jittered(&scene, 7), scene.seed)?;
        only_damps(&Cloud::<f32, 3>::jittered(&scene, 4), scene.seed)?;
    }

    #[test]
    fn filter_damps_degenerate_sets_if_they_hand_over_no_gradient(scene in scene()) {
        // Sparse: most of these particles have one neighbour or none.
        let sparse = Scene { ratio: 3.0 * scene.jitter + 0.2, ..scene };
        let wide = |mut cloud: Cloud<f64, 2>| { cloud.spacing = cloud.re / 3.0; cloud };
        damps_degenerate_sets(&wide(Cloud::scattered(&sparse, 6)), scene.seed)?;
        let wide = |mut cloud: Cloud<f64, 3>| { cloud.spacing = cloud.re / 3.0; cloud };
        damps_degenerate_sets(&wide(Cloud::scattered(&sparse, 4)), scene.seed)?;
    }
}

/// Why a degenerate neighbourhood must not hand its uncorrected gradient to the filter: two particles
/// that meet away from all others overestimate the slope between them, and diffusion turns around.
#[test]
fn uncorrected_gradients_of_a_close_pair_would_amplify() {
    let at = vec![Vector::from([0.0, 0.0]), Vector::from([0.02, 0.0])];
    let cloud = Cloud::<f64, 2>::new(at, Weight::Rational, 0.1, 3.0);
    let n = [1.0, -1.0];
    let gradients = cloud.each(&Gradient { factor: cloud.factor() }, &n);
    let correction = cloud.correction(0);
    assert!(matches!(correction, Corrected::Degenerate));
    let plain: Vec<_> = gradients.iter().map(|g| correction * *g).collect();
    assert!(apply(&filter(&cloud), &cloud, 0, &pack(&n, &plain)) > 0.0);
    let safe: Vec<_> = gradients.iter().map(|g| correction.corrected_or_zero(g)).collect();
    assert!(apply(&filter(&cloud), &cloud, 0, &pack(&n, &safe)) < 0.0);
}

/// It is a filter of the fourth derivative: a quartic it does damp.
#[test]
fn filter_sees_quartics() {
    for weight in Weight::ALL {
        let cloud = Cloud::<f64, 2>::lattice(weight, 1.0, 2.1, 9);
        let field: Vec<f64> = cloud.at.iter().map(|x| x[0].powi(4)).collect();
        let gradients = cloud.corrected_gradients(&field).unwrap();
        let found = apply(&filter(&cloud), &cloud, cloud.middle(), &pack(&field, &gradients));
        assert!(found < -0.5, "{weight:?}: {found}");
    }
}

/// On any particles: a field that follows the slope at rest stays, whatever the neighbourhood; nothing is created;
/// and the sum of squares of what differs from the slope never grows.
fn hydrostatic<T: Real, const D: usize>(cloud: &Cloud<T, D>, seed: u64) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed ^ 0x22);
    let slope = noise.direction::<T, D>() / cloud.spacing;
    let operator = HydrostaticDiffusion { factor: cloud.factor() / (cloud.spacing * cloud.spacing), slope };
    let rest: Vec<T> = cloud.at.iter().map(|x| slope.dot(x)).collect();
    let weights: f64 = cloud.each(&operator, &rest).iter().map(|f| f.to_double().abs()).sum();
    let scale = operator.factor.to_double() * cloud.at.len() as f64;
    // Dozens of terms below 4 with weights of up to 30.
    close("what is at rest", weights, 0.0, 1e5 * epsilon::<T>() * scale)?;

    let off: Vec<T> = rest.iter().map(|_| noise.between(-1.0, 1.0)).collect();
    let field: Vec<T> = rest.iter().zip(&off).map(|(&a, &b)| a + b).collect();
    let found = cloud.each(&operator, &field);
    let (mut sum, mut product) = (0.0, 0.0);
    for (f, n) in found.iter().zip(&off) {
        sum += f.to_double();
        product += f.to_double() * n.to_double();
    }
    close("sum", sum, 0.0, 1e5 * epsilon::<T>() * scale)?;
    prop_assert!(product < 0.0, "the differences have grown: {product}");
    Ok(())
}

proptest! {
    #[test]
    fn diffusion_less_the_hydrostatic_part_leaves_rest_alone_on_any_particles(scene in scene()) {
        hydrostatic(&Cloud::<f64, 2>::jittered(&scene, 6), scene.seed)?;
        hydrostatic(&Cloud::<f64, 3>::jittered(&scene, 4), scene.seed)?;
        hydrostatic(&Cloud::<f32, 2>::jittered(&scene, 6), scene.seed)?;
    }
}
