//! Shear along walls: none with free slip, that of the laminar fluid without slip.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::lattice;
use core::f64::consts::PI;
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidParticles, LaminarViscosity, Slip};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Parallel, PeriodicBox};

const L0: f64 = 0.01;
const NU: f64 = 0.02;
/// Free slip is not perfect: fluid that slides over the points of a wall feels their roughness.
const ROUGHNESS: f64 = 1e-3;

/// Mean velocity along the channel after `time` over that of the start, whose profile is `start`.
/// Both walls move with `wall`.
fn mean_velocity(rows: usize, slip: Slip, time: f64, wall: f64, start: impl Fn(f64) -> f64) -> f64 {
    let parallel = Parallel::serial();
    let columns = 10;
    let mut particles = FluidParticles::at_rest(lattice::<f64, 2>([0.0; 2], [columns, rows], L0));
    for (u, r) in particles.velocity.iter_mut().zip(&particles.position) {
        u.x = start(r.y / (rows as f64 * L0));
    }
    let before: f64 = particles.velocity.iter().map(|u| u.x).sum();
    let mut boundary = Boundary::default();
    for y in [-3.0, rows as f64] {
        boundary.add_wall(&lattice([0.0, y * L0], [columns, 3], L0), slip).unwrap();
    }
    boundary.velocity.fill(Vector::<f64, 2>::new(wall, 0.0));
    let domain = PeriodicBox::new(Vector::zeros(), [Some(columns as f64 * L0), None]).unwrap();
    let config = FluidConfig::water(L0, 10.0);
    let viscosity = |r: &_| LaminarViscosity::new::<2>(NU, r);
    let mut fluid = Fluid::new(config, Rational, viscosity, domain, particles, boundary).unwrap();
    while fluid.time() < time {
        fluid.step(&parallel).unwrap();
    }
    fluid.particles().velocity.iter().map(|u| u.x).sum::<f64>() / before
}

#[test]
fn free_slip_leaves_a_plug_flow_alone() {
    let kept = mean_velocity(20, Slip::Free, 0.1, 0.0, |_| 0.1);
    assert!((kept - 1.0).abs() < ROUGHNESS, "{kept}");
}

/// Decay rate of the slowest mode of a channel `rows` spacings wide, over the exact one.
fn decay(rows: usize) -> f64 {
    let rate = NU * (PI / (rows as f64 * L0)).powi(2);
    -mean_velocity(rows, Slip::None, 1.0 / rate, 0.0, |y| 0.1 * (PI * y).sin()).ln()
}

/// Straight profiles are exact at the wall; rows that slide over each other leave half a percent.
#[test]
fn without_slip_a_channel_decays_with_the_rate_of_its_slowest_mode() {
    let [coarse, fine] = [10, 20].map(|rows| (decay(rows) - 1.0).abs());
    assert!(coarse < 0.015 && fine < 0.006, "{coarse}, {fine}");
}

#[test]
fn moving_walls_drag_the_fluid_along_but_no_faster_than_they_are() {
    let dragged = mean_velocity(20, Slip::None, 0.1, 0.2, |_| 0.1);
    assert!(dragged > 1.1 && dragged < 2.0, "{dragged}");
    let free = mean_velocity(20, Slip::Free, 0.1, 0.2, |_| 0.1);
    assert!((free - 1.0).abs() < ROUGHNESS, "{free}");
}
