//! Pairwise collisions keep momentum and never create kinetic energy, whatever the cloud, and what they exchange in a time does not
//! depend on the number of steps in it.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod formula;

use crate::common::Noise;
use mps_fluid::{Boundary, Diffusion, Dpc, Fluid, FluidConfig, FluidParticles};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Domain, Open, Parallel};
use proptest::prelude::*;

const L0: f64 = 0.01;

/// Particles in a box of `width` spacings; every fourth one sits on top of the one before, every
/// fourth a hair beside it, if `clustered`.
fn cloud<const D: usize>(len: usize, width: f64, clustered: bool, seed: u64) -> FluidParticles<f64, D> {
    let mut noise = Noise::new(seed);
    let mut points: Vec<Vector<f64, D>> = Vec::new();
    for i in 0..len {
        let last = points.last().copied().unwrap_or_else(Vector::zeros);
        points.push(match i % 4 {
            1 if clustered => last,
            2 if clustered => last + noise.vector::<f64, D>(1e-9 * L0),
            _ => noise.vector(width * L0),
        });
    }
    let mut particles = FluidParticles::at_rest(points);
    particles.velocity.iter_mut().for_each(|u| *u = noise.vector(1.0));
    particles
}

const SOUND: f64 = 10.0;

/// A fluid after its first step, and the length of that: collisions are those of the time that has passed, none before the first step.
fn started<const D: usize, P: Domain<f64, D>>(
    domain: P,
    particles: FluidParticles<f64, D>,
    dpc: Dpc<f64>,
    cfl: f64,
) -> (Fluid<f64, D, Rational, (), P>, f64) {
    // The diffusion of the density would keep the steps below the longer ones of these tests.
    let diffusion = Diffusion::None;
    let config = FluidConfig { collisions: Some(dpc), cfl, diffusion, ..FluidConfig::water(L0, SOUND) };
    let mut fluid = Fluid::new(config, Rational, |_| (), domain, particles, Boundary::default()).unwrap();
    let dt = fluid.step(&Parallel::serial()).unwrap();
    (fluid, dt)
}

/// Kinetic energy and momentum (both per mass) before and after the collisions of one step, and the share `c dt/l0` of it.
fn collide<const D: usize>(
    particles: FluidParticles<f64, D>,
    dpc: Dpc<f64>,
    cfl: f64,
) -> ([f64; 2], [Vector<f64, D>; 2], Fluid<f64, D>, f64) {
    let (mut fluid, dt) = started(Open, particles, dpc, cfl);
    let sums = |fluid: &Fluid<f64, D>| {
        let u = &fluid.particles().velocity;
        let kinetic: f64 = u.iter().map(|u| 0.5 * u.norm_squared()).sum();
        (kinetic, u.iter().sum::<Vector<f64, D>>())
    };
    let before = sums(&fluid);
    // At the beginning of a step velocities are changed by collisions alone.
    fluid.begin_step(&Parallel::serial()).unwrap();
    let after = sums(&fluid);
    ([before.0, after.0], [before.1, after.1], fluid, SOUND * dt / L0)
}

proptest! {
    // No file of past failures: integration tests have no place for one.
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn kinetic_energy_never_rises_and_momentum_stays(
        len in 2_usize..120,
        width in 0.3_f64..8.0,
        clustered: bool,
        restitution in 0.0_f64..=1.0,
        cfl in 0.05_f64..2.0,
        seed: u64,
    ) {
        let dpc = dpc(restitution);
        let (energy, momentum, ..) = collide(cloud::<2>(len, width, clustered, seed), dpc, cfl);
        prop_assert!(energy[1] <= energy[0] * (1.0 + 1e-14), "{} to {}", energy[0], energy[1]);
        prop_assert!((momentum[1] - momentum[0]).norm() < 1e-13 * len as f64);
        let (energy, momentum, ..) = collide(cloud::<3>(len, width, clustered, seed), dpc, cfl);
        prop_assert!(energy[1] <= energy[0] * (1.0 + 1e-14), "3D: {} to {}", energy[0], energy[1]);
        prop_assert!((momentum[1] - momentum[0]).norm() < 1e-13 * len as f64);
    }

    #[test]
    fn no_cloud_becomes_infinite(len in 2_usize..60, width in 0.0_f64..3.0, seed: u64) {
        let (_, _, mut fluid, _) = collide(cloud::<2>(len, width, true, seed), Dpc::default(), 0.5);
        for _ in 0..5 {
            // Squeezed into a point, a cloud may be refused with an error, but never go on with NaN.
            if fluid.step(&Parallel::serial()).is_err() {
                break;
            }
            prop_assert!(fluid.particles().velocity.iter().all(|u| u.norm().is_finite()));
        }
    }
}

/// Two particles that meet with `speed` each, `distance` apart after a first step: the speed of the first of them after the collisions of the
/// second, and the share of the exchange that is due in a step.
fn pair(distance: f64, speed: f64, dpc: Dpc<f64>, cfl: f64) -> [f64; 2] {
    let dt = cfl * L0 / (speed.abs() + SOUND);
    let start = distance + 2.0 * speed * dt;
    let mut particles = FluidParticles::at_rest(vec![Vector::zeros(), Vector::<f64, 2>::new(start, 0.0)]);
    particles.velocity[0].x = speed;
    particles.velocity[1].x = -speed;
    let (_, _, fluid, share) = collide(particles, dpc, cfl);
    let first = usize::from(fluid.particles().id[0] != 0);
    [fluid.particles().velocity[first].x, share]
}

/// Without the background pressure, which does work.
const fn dpc(restitution: f64) -> Dpc<f64> {
    Dpc { restitution, repulsion: 0.0, ceiling: 0.02 }
}

#[test]
fn an_overlapping_pair_sticks_or_bounces_as_told_in_the_time_of_sound() {
    for restitution in [0.0, 0.5, 1.0] {
        for cfl in [0.1, 0.5, 1.0] {
            let [after, share] = pair(0.3 * L0, 1.0, dpc(restitution), cfl);
            let expected = 1.0 - (1.0 + restitution) * share;
            assert!(
                (after - expected).abs() < 1e-13,
                "restitution {restitution}, {cfl}: {after}, not {expected}"
            );
        }
        // No more than the whole in a step that is longer.
        let [after, share] = pair(0.3 * L0, 1.0, dpc(restitution), 1.6);
        assert!(share > 1.4 && (after + restitution).abs() < 1e-13, "restitution {restitution}: {after}");
    }
}

#[test]
fn pairs_that_part_or_stand_a_spacing_apart_do_not_collide() {
    assert_eq!(pair(0.3 * L0, -1.0, dpc(1.0), 0.5)[0], -1.0);
    assert_eq!(pair(1.001 * L0, 1.0, dpc(1.0), 0.5)[0], 1.0);
    // Continuous at the edge of the range.
    assert!(pair(0.9999 * L0, 1.0, dpc(1.0), 0.5)[0] > 0.97);
}

/// Kinetic energy over that at the start of a cloud that has moved for as long as sound needs for a spacing, in steps of the Courant number `cfl`.
fn left_over(cfl: f64) -> f64 {
    let config = FluidConfig {
        collisions: Some(dpc(0.0)),
        cfl,
        diffusion: Diffusion::None,
        ..FluidConfig::water(L0, SOUND)
    };
    let mut particles = cloud::<2>(120, 4.0, false, 5);
    // Too thin for any pressure, and so slow that nobody moves in that time: collisions alone, of the same pairs.
    particles.density.fill(0.5);
    particles.velocity.iter_mut().for_each(|u| *u *= 1e-6);
    let mut fluid = Fluid::new(config, Rational, |_| (), Open, particles, Boundary::default()).unwrap();
    let kinetic =
        |fluid: &Fluid<f64, 2>| fluid.particles().velocity.iter().map(|u| u.norm_squared()).sum::<f64>();
    let start = kinetic(&fluid);
    while fluid.time() < 0.999 * L0 / SOUND {
        fluid.step(&Parallel::serial()).unwrap();
    }
    fluid.begin_step(&Parallel::serial()).unwrap();
    kinetic(&fluid) / start
}

#[test]
fn what_is_exchanged_in_a_time_has_a_limit_for_short_steps() {
    let left = [0.1, 0.05, 0.025, 0.0125].map(left_over);
    // Something has happened, and each halving changes it by half as much.
    assert!(left[3] < 0.8, "{left:?}");
    let change = |k: usize| (left[k + 1] - left[k]).abs();
    assert!(change(0) < 0.05 && change(2) < 0.35 * change(0), "{left:?}");
}
