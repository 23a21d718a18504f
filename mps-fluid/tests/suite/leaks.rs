//! Walls hold the fluid.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{lattice, water};
use mps_fluid::{ArtificialViscosity, Boundary, Fluid, FluidConfig, FluidParticles, Slip};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Open, Parallel};

const L0: f64 = 0.01;

/// Fluid left of a wall at x = 0.
fn left_of_wall<const D: usize>(
    config: FluidConfig<f64, D>,
    particles: FluidParticles<f64, D>,
    walls: &[Vector<f64, D>],
) -> Fluid<f64, D, Rational, ArtificialViscosity<f64>> {
    let c = config.sound_speed;
    let mut boundary = Boundary::default();
    boundary.add_wall(walls, Slip::Free).unwrap();
    let viscosity = |r: &_| ArtificialViscosity::new::<D>(0.05, c, r);
    Fluid::new(config, Rational, viscosity, Open, particles, boundary).unwrap()
}

fn furthest<const D: usize>(fluid: &Fluid<f64, D, Rational, ArtificialViscosity<f64>>) -> f64 {
    fluid.particles().position.iter().map(|r| r[0]).fold(f64::MIN, f64::max)
}

/// Furthest place reached along x, over the spacing, while a block hits the wall at x = 0.
fn impact<const D: usize>(fluid_counts: [usize; D], wall_counts: [usize; D], speed: f64, angle: f64) -> f64 {
    let parallel = Parallel::serial();
    let mut corner = fluid_counts.map(|n| -0.5 * n as f64 * L0);
    corner[0] = -(fluid_counts[0] as f64 + 1.0) * L0;
    let mut particles = FluidParticles::at_rest(lattice(corner, fluid_counts, L0));
    for u in &mut particles.velocity {
        (u[0], u[1]) = (speed * angle.cos(), speed * angle.sin());
    }
    let mut corner = wall_counts.map(|n| -0.5 * n as f64 * L0);
    corner[0] = 0.0;
    let walls = lattice(corner, wall_counts, L0);
    let mut fluid = left_of_wall(FluidConfig::water(L0, 10.0 * speed), particles, &walls);
    let mut reached = f64::MIN;
    // Twice the time in which the rear would arrive.
    while fluid.time() < 2.0 * fluid_counts[0] as f64 * L0 / speed {
        fluid.step(&parallel).unwrap();
        reached = reached.max(furthest(&fluid));
    }
    let stopped = fluid.particles().velocity.iter().map(|u| u[0]).sum::<f64>();
    assert!(stopped < 0.2 * speed * fluid.particles().velocity.len() as f64, "the wall was hit");
    reached / L0
}

#[test]
fn a_block_that_hits_a_wall_at_three_metres_a_second_does_not_pass_it() {
    for angle in [0.0, 0.4, 1.0] {
        let reached = impact([20, 20], [3, 160], 3.0, angle);
        assert!(reached < 0.0, "angle {angle}: {reached} spacings behind the surface");
    }
    let reached = impact([8, 8, 8], [3, 60, 60], 3.0, 0.3);
    assert!(reached < 0.0, "3D: {reached} spacings behind the surface");
}

#[test]
fn a_wall_two_layers_thin_holds_water_on_one_side() {
    let parallel = Parallel::serial();
    let (width, height) = (20, 30);
    let particles = FluidParticles::at_rest(lattice([-(width as f64) * L0, 0.0], [width, height], L0));
    let mut walls = lattice::<f64, 2>([0.0, -3.0 * L0], [2, height + 20], L0);
    walls.extend(lattice::<f64, 2>([-(width as f64 + 3.0) * L0, -3.0 * L0], [3, height + 20], L0));
    walls.extend(lattice::<f64, 2>([-(width as f64) * L0, -3.0 * L0], [width, 3], L0));
    let config = water::<f64, 2>(L0, height as f64 * L0);
    let mut fluid = left_of_wall(config, particles, &walls);
    for _ in 0..300 {
        fluid.step(&parallel).unwrap();
        assert!(furthest(&fluid) < 0.0, "step {}: {} m", fluid.steps(), furthest(&fluid));
    }
    let lowest = fluid.particles().position.iter().map(|r| r.y).fold(f64::MAX, f64::min);
    assert!(lowest > 0.0, "{lowest} m");
    // It does not hold by sticking: the fluid pushes.
    let at_wall = |r: &Vector<f64, 2>| r.x > -1.5 * L0 && r.y < 0.5 * height as f64 * L0;
    let particles = fluid.particles();
    let pressures = particles.position.iter().zip(&particles.pressure);
    let (sum, count) = pressures.filter(|(r, _)| at_wall(r)).fold((0.0, 0), |(s, k), (_, p)| (s + p, k + 1));
    assert!(sum / f64::from(count) > 0.3 * 1000.0 * 9.81 * height as f64 * L0);
}
