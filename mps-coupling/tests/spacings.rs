//! Points of a structure may lie closer than the particles of the fluid: its force does not depend on that, and nothing leaks.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::lattice;
use mps_coupling::{Fixed, Scene};
use mps_fluid::{ArtificialViscosity, Boundary, Fluid, FluidConfig, FluidParticles, Slip};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Parallel, PeriodicBox};

type Column = Scene<f64, 2, Rational, ArtificialViscosity<f64>, PeriodicBox<f64, 2>>;

const L0: f64 = 0.01;
const C: f64 = 20.0;
const G: f64 = 9.81;
/// Particles of the water across and up.
const COUNTS: [usize; 2] = [16, 20];

/// Water without sides on a floor whose points are `ratio` times as close, falling on it with `speed` \[m/s\].
fn column(ratio: usize, speed: f64) -> Column {
    let mut config = FluidConfig::water(L0, C);
    config.gravity = Vector::from([0.0, -G]);
    let mut particles = FluidParticles::at_rest(lattice([0.0; 2], COUNTS, L0));
    let height = COUNTS[1] as f64 * L0;
    for ((u, n), r) in particles.velocity.iter_mut().zip(&mut particles.density).zip(&particles.position) {
        u.y = -speed;
        *n += G * (height - r.y) / (C * C);
    }
    let domain = PeriodicBox::new(Vector::zeros(), [Some(COUNTS[0] as f64 * L0), None]).unwrap();
    let viscosity = |r: &_| ArtificialViscosity::new::<2>(0.1, C, r);
    let fluid = Fluid::new(config, Rational, viscosity, domain, particles, Boundary::default()).unwrap();
    let mut scene = Scene::new(fluid);
    let spacing = L0 / ratio as f64;
    let points = lattice([0.0, -4.0 * L0], [COUNTS[0] * ratio, 4 * ratio], spacing);
    let volumes = vec![spacing * spacing; points.len()];
    let floor = Fixed::new(points, volumes, spacing);
    scene.add_structure(&Parallel::serial(), Box::new(floor), Slip::Free).unwrap();
    scene
}

/// Mean force on the floor \[N/m\] from `from` to `to` \[s\].
fn mean_force(scene: &mut Column, [from, to]: [f64; 2]) -> Vector<f64, 2> {
    let parallel = Parallel::serial();
    let (mut impulse, mut time) = (Vector::zeros(), 0.0);
    while scene.fluid().time() < to {
        let dt = scene.step(&parallel, f64::INFINITY).unwrap();
        if scene.fluid().time() > from {
            impulse += scene.forces(0).unwrap().iter().sum::<Vector<f64, 2>>() * dt;
            time += dt;
        }
    }
    impulse / time
}

#[test]
fn a_floor_carries_the_weight_of_the_water_whatever_its_spacing() {
    let weight = 1000.0 * G * (COUNTS[0] * COUNTS[1]) as f64 * L0 * L0;
    for ratio in [1, 2, 3] {
        let force = mean_force(&mut column(ratio, 0.0), [0.1, 0.5]);
        assert!((-force.y / weight - 1.0).abs() < 0.005, "ratio {ratio}: {} of {weight} N/m", -force.y);
        assert!(force.x.abs() < 0.005 * weight, "ratio {ratio}: {} N/m to the side", force.x);
    }
}

#[test]
fn water_that_falls_on_a_floor_does_not_pass_it_whatever_its_spacing() {
    let parallel = Parallel::serial();
    for ratio in [1, 2, 3] {
        let mut scene = column(ratio, 4.0);
        while scene.fluid().time() < 0.1 {
            scene.step(&parallel, f64::INFINITY).unwrap();
            let lowest = scene.fluid().particles().position.iter().fold(f64::INFINITY, |low, r| low.min(r.y));
            assert!(lowest > -0.05 * L0, "ratio {ratio}: a particle at {lowest} m");
        }
    }
}
