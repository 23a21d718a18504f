//! What is exchanged is the formula, written out pair by pair.

use super::{L0, SOUND, cloud, dpc, started};
use mps_fluid::{Dpc, Fluid, FluidParticles};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Domain, Open, Parallel, PeriodicBox};
use proptest::prelude::*;

/// Holds what the collisions of the next step change the velocities by against the formula, of all pairs, one by one (section 11 of docs/method.md). Returns the
/// largest change \[m/s\] and the smallest limit of a pair.
fn compare<const D: usize, P: Domain<f64, D>>(
    domain: &P,
    (mut fluid, dt): (Fluid<f64, D, Rational, (), P>, f64),
    dpc: &Dpc<f64>,
) -> Result<(f64, f64), TestCaseError> {
    let before = fluid.particles().clone();
    fluid.begin_step(&Parallel::serial()).unwrap();
    let after = fluid.particles();
    let (expected, limit) = written_out(domain, &before, dpc, dt);
    let largest = expected.iter().map(Vector::norm).fold(0.0, f64::max);
    for ((id, u), expected) in before.id.iter().zip(&before.velocity).zip(&expected) {
        let now = after.id.iter().position(|other| other == id).unwrap();
        let found = after.velocity[now] - u;
        prop_assert!((found - expected).norm() < 1e-12 * largest.max(1.0), "{found} for {expected}");
    }
    Ok((largest, limit))
}

fn written_out<const D: usize, P: Domain<f64, D>>(
    domain: &P,
    particles: &FluidParticles<f64, D>,
    dpc: &Dpc<f64>,
    dt: f64,
) -> (Vec<Vector<f64, D>>, f64) {
    let FluidParticles { position, velocity: u, pressure: p, .. } = particles;
    let density = 1000.0;
    let all = || 0..position.len();
    // Line, distance and approach of those that have a line.
    let pair = |i: usize, j: usize| {
        let line = domain.separation(&position[i], &position[j]);
        let distance = line.norm();
        (0.0 < distance && distance < L0)
            .then(|| (line / distance, distance, (u[j] - u[i]).dot(&line) / distance))
    };
    let chi = |distance: f64| (L0 / distance.max(L0 / 20.0) - 1.0).sqrt();
    let share = |distance: f64, approach: f64| {
        let k = if distance < 0.5 * L0 { 1.0 } else { chi(distance) };
        if approach < 0.0 { k * 0.5 * (1.0 + dpc.restitution) * (SOUND * dt / L0).min(1.0) } else { 0.0 }
    };
    let load =
        |i: usize| all().filter_map(|j| pair(i, j)).map(|(_, r, approach)| share(r, approach)).sum::<f64>();
    let limit: Vec<f64> = all().map(|i| 1.0 / load(i).max(1.0)).collect();
    let change = |i: usize| {
        let mut sum = Vector::zeros();
        for j in all() {
            let Some((line, r, approach)) = pair(i, j) else { continue };
            if approach < 0.0 {
                sum += line * (share(r, approach) * limit[i].min(limit[j]) * approach);
            } else {
                let background =
                    dpc.repulsion * (p[i] + p[j]).abs().min(dpc.ceiling * density * SOUND * SOUND);
                sum -= line * (dt / density * chi(r) * background / r);
            }
        }
        sum
    };
    (all().map(change).collect(), limit.iter().copied().fold(1.0, f64::min))
}

#[test]
fn crowds_limit_what_they_exchange() {
    let crowd = started(Open, cloud::<2>(60, 1.2, false, 3), dpc(1.0), 1.0);
    let (_, limit) = compare(&Open, crowd, &dpc(1.0)).unwrap();
    assert!(limit < 0.5, "{limit}");
}

#[test]
fn pairs_at_rest_are_pushed() {
    let pushing = Dpc { repulsion: 0.5, ..dpc(0.0) };
    let mut dense = cloud::<2>(40, 3.0, false, 4);
    dense.density.fill(1.01);
    let (mut fluid, dt) = started(Open, dense, pushing, 0.5);
    fluid.particles_mut().velocity.fill(Vector::zeros());
    let (largest, _) = compare(&Open, (fluid, dt), &pushing).unwrap();
    assert!(largest > 0.0);
}

/// One in the rows of its neighbours, but farther away than a spacing.
#[test]
fn what_flies_by_out_of_range_is_not_felt_whatever_its_speed() {
    for wild in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        let places = [0.0, 0.9, 2.0].map(|x| Vector::<f64, 2>::new(x * L0, 0.0));
        let mut particles = FluidParticles::at_rest(places.to_vec());
        particles.velocity[0].x = 1.0;
        let (mut fluid, _) = started(Open, particles, dpc(1.0), 0.5);
        let wildest = fluid.particles().id.iter().position(|id| *id == 2).unwrap();
        fluid.particles_mut().velocity[wildest].x = wild;
        // The step itself is refused for its speed.
        assert!(fluid.begin_step(&Parallel::serial()).is_err());
        let left = fluid.particles().velocity.iter().filter(|u| u.norm().is_finite()).count();
        assert_eq!(left, 2, "{wild}");
    }
}

proptest! {
    // No file of past failures: integration tests have no place for one.
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_exchanged_is_the_formula_written_out(
        len in 2_usize..80,
        width in 1.0_f64..6.0,
        clustered: bool,
        restitution in 0.0_f64..=1.0,
        repulsion in prop::sample::select(vec![0.0, 0.1, 0.7]),
        cfl in 0.05_f64..1.5,
        seed: u64,
    ) {
        let dpc = Dpc { restitution, repulsion, ceiling: 0.02 };
        compare(&Open, started(Open, cloud::<2>(len, width, clustered, seed), dpc, cfl), &dpc)?;
        compare(&Open, started(Open, cloud::<3>(len, width, clustered, seed), dpc, cfl), &dpc)?;
        // Some pairs see each other across the border.
        let side = 2.0 * width.max(4.0) * L0;
        let domain = PeriodicBox::new(Vector::repeat(-width * L0), [Some(side); 2]).unwrap();
        compare(&domain, started(domain, cloud::<2>(len, width, clustered, seed), dpc, cfl), &dpc)?;
    }
}
