//! Pressure gradient (eq. 24) and divergence (eq. 23) belong together: momentum is kept pair by pair,
//! and the work of the pressure is the work of the compression, on any particles at all.
//!
//! Both equations are misprinted in the source paper; the printed forms are run too and fail.

use crate::common::{Cloud, Noise, Scene, close, epsilon, scene};
use mps_kernel::operators::{ConservativeDivergence, ConservativeGradient};
use mps_kernel::{Pair, PairOperator, Real, Vector};
use proptest::prelude::*;

/// Pressure, number density and velocity of every particle: any values, densities positive.
struct State<T: Real, const D: usize> {
    p: Vec<T>,
    n: Vec<T>,
    u: Vec<Vector<T, D>>,
}

impl<T: Real, const D: usize> State<T, D> {
    fn random(count: usize, seed: u64) -> Self {
        let mut noise = Noise(seed ^ 0x5EED);
        Self {
            p: noise.numbers(count, -1.0, 1.0),
            n: noise.numbers(count, 0.3, 30.0),
            u: noise.vectors(count),
        }
    }
}

/// `sum_i p_i div(u)_i`, `sum_i u_i . grad(p)_i`, and the sum of the sizes of all terms.
fn work<T: Real, const D: usize>(
    cloud: &Cloud<T, D>,
    state: &State<T, D>,
    divergence: &impl PairOperator<T, D, (Vector<T, D>, T), Output = T>,
    gradient: &impl PairOperator<T, D, (T, T), Output = Vector<T, D>>,
) -> (f64, f64, f64) {
    let velocities: Vec<_> = state.u.iter().copied().zip(state.n.iter().copied()).collect();
    let pressures: Vec<_> = state.p.iter().copied().zip(state.n.iter().copied()).collect();
    let (mut compression, mut pressure, mut size) = (0.0, 0.0, 0.0);
    for (i, pair) in cloud.pairs() {
        let mut term = divergence.zero();
        divergence.add(&mut term, &velocities[i], &velocities[pair.j], &pair);
        let term = divergence.finish(term) * state.p[i];
        let mut force = gradient.zero();
        gradient.add(&mut force, &pressures[i], &pressures[pair.j], &pair);
        let force = gradient.finish(force).dot(&state.u[i]);
        compression += term.to_double();
        pressure += force.to_double();
        size += term.to_double().abs() + force.to_double().abs();
    }
    (compression, pressure, size)
}

fn adjoint<T: Real, const D: usize>(cloud: &Cloud<T, D>, seed: u64) -> Result<(), TestCaseError> {
    let state = State::random(cloud.at.len(), seed);
    let factor = cloud.factor();
    let divergence = ConservativeDivergence { factor };
    let gradient = ConservativeGradient { factor };
    let (compression, pressure, size) = work(cloud, &state, &divergence, &gradient);
    // Each term carries a few roundings of its own; cancellation in u_j - u_i and in the pressure of
    // the pair is bounded by the parts, and both are of size one.
    let tolerance = 16.0 * epsilon::<T>() * (size + cloud.at.len() as f64 * f64::MIN_POSITIVE);
    close("work of the pressure", pressure, -compression, tolerance)
}

fn keeps_momentum<T: Real, const D: usize>(cloud: &Cloud<T, D>, seed: u64) -> Result<(), TestCaseError> {
    let state = State::<T, D>::random(cloud.at.len(), seed);
    let fields: Vec<_> = state.p.iter().copied().zip(state.n.iter().copied()).collect();
    let gradient = ConservativeGradient { factor: cloud.factor() };
    // Pair by pair, to the last bit.
    let pairs = cloud.pairs();
    let term = |i: usize, pair: &Pair<T, D>| {
        let mut sum = Vector::zeros();
        gradient.add(&mut sum, &fields[i], &fields[pair.j], pair);
        sum
    };
    for (i, pair) in &pairs {
        let (_, back) = pairs.iter().find(|(j, other)| *j == pair.j && other.j == *i).unwrap();
        let (there, back) = (term(*i, pair), term(pair.j, back));
        prop_assert_eq!(there, -back, "pair {} {}", i, pair.j);
    }
    // And so in sum, to what adding them up loses.
    let forces = cloud.each(&gradient, &fields);
    let total = forces.iter().fold(Vector::<f64, D>::zeros(), |sum, force| sum + force.map(Real::to_double));
    let size: f64 = pairs.iter().map(|(i, pair)| (term(*i, pair) * gradient.factor).norm().to_double()).sum();
    prop_assert!(size > 0.0 || pairs.is_empty());
    let tolerance = 64.0 * epsilon::<T>() * size;
    prop_assert!(total.norm() <= tolerance, "{} > {tolerance}", total.norm());
    Ok(())
}

fn pair_pressure_is_symmetric<T: Real>(seed: u64) -> Result<(), TestCaseError> {
    let mut noise = Noise(seed);
    let (p, n) = (noise.numbers::<T>(2, -1e5, 1e5), noise.numbers::<T>(2, 1e-3, 100.0));
    let share = [p[0] / n[0], p[1] / n[1]];
    let from = |i: usize, j: usize| ConservativeGradient::pair_pressure(share[i], n[i], share[j], n[j]);
    prop_assert_eq!(from(0, 1), from(1, 0));
    // The formula itself, at the one state where both ratios show.
    let expected = (n[0] / n[1] * p[1] + n[1] / n[0] * p[0]).to_double();
    let size = (n[0] / n[1] * p[1].abs() + n[1] / n[0] * p[0].abs()).to_double();
    close("pressure of the pair", from(0, 1).to_double(), expected, 8.0 * epsilon::<T>() * size)
}

fn on_all<T: Real, const D: usize>(
    scene: &Scene,
    side: usize,
    check: impl Fn(&Cloud<T, D>, u64) -> Result<(), TestCaseError>,
) -> Result<(), TestCaseError> {
    check(&Cloud::jittered(scene, side), scene.seed)?;
    check(&Cloud::scattered(scene, side), scene.seed)
}

proptest! {
    #[test]
    fn divergence_is_the_negative_adjoint_of_the_pressure_gradient(scene in scene()) {
        on_all::<f64, 2>(&scene, 6, adjoint)?;
        on_all::<f64, 3>(&scene, 4, adjoint)?;
        on_all::<f32, 2>(&scene, 6, adjoint)?;
        on_all::<f32, 3>(&scene, 4, adjoint)?;
    }

    #[test]
    fn pressure_keeps_momentum_pair_by_pair(scene in scene()) {
        on_all::<f64, 2>(&scene, 5, keeps_momentum)?;
        on_all::<f64, 3>(&scene, 3, keeps_momentum)?;
        on_all::<f32, 2>(&scene, 5, keeps_momentum)?;
        on_all::<f32, 3>(&scene, 3, keeps_momentum)?;
    }

    #[test]
    fn pressure_of_a_pair_has_the_same_bits_from_both_sides(seed: u64) {
        pair_pressure_is_symmetric::<f64>(seed)?;
        pair_pressure_is_symmetric::<f32>(seed)?;
    }
}

/// Eq. 23 as printed: the ratio upside down.
struct PrintedDivergence(f64);

impl<const D: usize> PairOperator<f64, D, (Vector<f64, D>, f64)> for PrintedDivergence {
    type Output = f64;

    fn zero(&self) -> f64 {
        0.0
    }

    fn add(
        &self,
        sum: &mut f64,
        fi: &(Vector<f64, D>, f64),
        fj: &(Vector<f64, D>, f64),
        pair: &Pair<f64, D>,
    ) {
        *sum += fi.1 / fj.1 * (fj.0 - fi.0).dot(&pair.gradient_vector());
    }

    fn finish(&self, sum: f64) -> f64 {
        sum * self.0
    }
}

/// Eq. 24 as printed: the same ratio twice.
struct PrintedGradient(f64);

impl<const D: usize> PairOperator<f64, D, (f64, f64)> for PrintedGradient {
    type Output = Vector<f64, D>;

    fn zero(&self) -> Vector<f64, D> {
        Vector::zeros()
    }

    fn add(&self, sum: &mut Vector<f64, D>, fi: &(f64, f64), fj: &(f64, f64), pair: &Pair<f64, D>) {
        *sum += pair.gradient_vector() * (fi.1 / fj.1 * fj.0 + fi.1 / fj.1 * fi.0);
    }

    fn finish(&self, sum: Vector<f64, D>) -> Vector<f64, D> {
        sum * self.0
    }
}

fn printed_forms_fail<const D: usize>(seed: u64) {
    let weight = crate::common::Weight::Rational;
    let scene = Scene { weight, ratio: 3.0, spacing: 0.1, jitter: 0.2, seed };
    let cloud = Cloud::<f64, D>::jittered(&scene, 4);
    let state = State::random(cloud.at.len(), seed);
    let factor = cloud.factor();
    let (divergence, gradient) = (ConservativeDivergence { factor }, ConservativeGradient { factor });
    let (printed_divergence, printed_gradient) = (PrintedDivergence(factor), PrintedGradient(factor));

    // Random signs make even a wrong sum small now and then: 1e-5 of its terms is far above rounding.
    let defect = |(compression, pressure, size): (f64, f64, f64)| (compression + pressure).abs() / size;
    assert!(defect(work(&cloud, &state, &divergence, &gradient)) < 1e-14);
    assert!(defect(work(&cloud, &state, &printed_divergence, &gradient)) > 1e-5);
    assert!(defect(work(&cloud, &state, &divergence, &printed_gradient)) > 1e-5);
    assert!(defect(work(&cloud, &state, &printed_divergence, &printed_gradient)) > 1e-5);

    let fields: Vec<_> = state.p.iter().copied().zip(state.n.iter().copied()).collect();
    let net = |forces: Vec<Vector<f64, D>>| {
        let size: f64 = forces.iter().map(Vector::norm).sum();
        forces.iter().sum::<Vector<f64, D>>().norm() / size
    };
    assert!(net(cloud.each(&gradient, &fields)) < 1e-13);
    assert!(net(cloud.each(&printed_gradient, &fields)) > 1e-5);
}

#[test]
fn the_misprinted_forms_conserve_nothing() {
    for seed in 0..20 {
        printed_forms_fail::<2>(seed);
        printed_forms_fail::<3>(seed);
    }
}
