//! Moving tanks: what the fluid feels of the motion of its walls.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{closed_walls, lattice, tank, water};
use mps_fluid::{
    ArtificialViscosity, Boundary, Fluid, FluidConfig, FluidParticles, Slip, Tension, Viscosity,
};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Open, Parallel};

/// One step in which all walls move with the velocity `a t` at its end.
fn step_with_walls<V: Viscosity<f64, 2>>(fluid: &mut Fluid<f64, 2, Rational, V>, a: &Vector<f64, 2>) {
    let parallel = Parallel::serial();
    let dt = fluid.begin_step(&parallel).unwrap();
    let u = a * (fluid.time() + dt);
    fluid.boundary_mut().velocity.fill(u);
    fluid.finish_step(&parallel, dt);
    fluid.boundary_mut().position.iter_mut().for_each(|r| *r += u * dt);
}

#[test]
fn a_tank_in_free_fall_has_no_pressure() {
    let (l0, n) = (0.01, 16);
    let config = water::<f64, 2>(l0, l0 * n as f64);
    let g = config.gravity;
    let mut fluid = tank([n, n], config, |_| ());
    fluid.particles_mut().density.fill(1.0);
    fluid.boundary_mut().acceleration.fill(g);
    let start = fluid.particles().position.clone();
    let mut steps = 0;
    while fluid.time() < 0.3 {
        step_with_walls(&mut fluid, &g);
        steps += 1;
    }
    let particles = fluid.particles();
    let largest = particles.pressure.iter().map(|p| p.abs()).fold(0.0, f64::max);
    assert!(largest < 1e-6 * 1000.0 * 9.81 * 0.16, "{largest} Pa after {steps} steps");
    let fallen = start[0].y - particles.position[particles.id.iter().position(|&id| id == 0).unwrap()].y;
    assert!(fallen > 0.4, "{fallen} m");
}

/// Mean slopes of the pressure [Pa/m] of a closed box full of fluid under the acceleration `a` of its
/// walls, after the sound has died away. `shown` is the acceleration the walls show the fluid.
fn slopes(a: Vector<f64, 2>, shown: Vector<f64, 2>) -> Vector<f64, 2> {
    let (l0, n) = (0.01, 16);
    let c = 12.0;
    let mut config = FluidConfig::water(l0, c);
    config.gravity = Vector::<f64, 2>::new(0.0, -9.81);
    config.tension = Tension::Keep;
    let mut particles = FluidParticles::at_rest(lattice([0.0; 2], [n, n], l0));
    // Pressed together so that no pressure is negative.
    particles.density.fill(1.01);
    let mut boundary = Boundary::default();
    boundary.add_wall(&closed_walls([n, n], l0), Slip::Free).unwrap();
    boundary.acceleration.fill(shown);
    let viscosity = |r: &_| ArtificialViscosity::new::<2>(0.5, c, r);
    let mut fluid = Fluid::new(config, Rational, viscosity, Open, particles, boundary).unwrap();
    let (mut sum, mut count) = (Vector::<f64, 2>::zeros(), 0.0);
    while fluid.time() < 1.2 {
        step_with_walls(&mut fluid, &a);
        if fluid.time() > 0.6 {
            sum += slope(fluid.particles());
            count += 1.0;
        }
    }
    sum / count
}

/// Least squares over the particles.
fn slope(particles: &FluidParticles<f64, 2>) -> Vector<f64, 2> {
    let center = particles.position.iter().sum::<Vector<f64, 2>>() / particles.position.len() as f64;
    let (mut xp, mut xx) = (Vector::<f64, 2>::zeros(), Vector::<f64, 2>::zeros());
    for (r, p) in particles.position.iter().zip(&particles.pressure) {
        let d = r - center;
        xp += d * *p;
        xx += d.component_mul(&d);
    }
    xp.component_div(&xx)
}

#[test]
fn a_tank_accelerated_sideways_tilts_the_pressure() {
    let a = Vector::<f64, 2>::new(3.0, 0.0);
    let tilted = slopes(a, a) / 1000.0;
    assert!((tilted.x + 3.0).abs() < 0.02 * 3.0, "{tilted}");
    assert!((tilted.y + 9.81).abs() < 0.03 * 9.81, "{tilted}");
    // The walls have to show their acceleration: their motion alone gives too much.
    let hidden = slopes(a, Vector::zeros()) / 1000.0;
    assert!((hidden.x + 3.0).abs() > 0.04 * 3.0, "{hidden}");
    let resting = slopes(Vector::zeros(), Vector::zeros()) / 1000.0;
    assert!(resting.x.abs() < 0.01 * 9.81, "{resting}");
}
