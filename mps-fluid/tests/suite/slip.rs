//! Shear along walls: none with free slip, that of the laminar fluid without slip.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{fill, lattice, step_on_account};
use core::f64::consts::PI;
use mps_fluid::{
    ArtificialViscosity, Boundary, CompletedViscosity, Fluid, FluidConfig, FluidParticles, LaminarViscosity,
    Slip, Viscosity,
};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Open, Parallel, PeriodicBox};

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

/// A puddle that slides over a plate of fine points: force on the plate \[N\] in the first step, and what is lost of the momentum in ten,
/// over the impulse of the first.
fn drag<V: Viscosity<f64, 2>>(wrap: impl Fn(ArtificialViscosity<f64>) -> V) -> (f64, f64) {
    let mut particles = FluidParticles::at_rest(fill([0.0; 2], [0.2, 0.05], L0, |_| true));
    particles.velocity.fill(Vector::<f64, 2>::new(1.0, 0.0));
    let mut boundary = Boundary::default();
    let plate = fill([-0.1, -0.03], [0.4, 0.0], 0.5 * L0, |_| true);
    boundary.add_structure(&plate, core::iter::repeat(0.25), Slip::None);
    let viscosity = |r: &_| wrap(ArtificialViscosity::new::<2>(0.5, 10.0, r));
    let config = FluidConfig::water(L0, 10.0);
    let mut fluid = Fluid::new(config, Rational, viscosity, Open, particles, boundary).unwrap();
    let first = step_on_account(&mut fluid, |_, _| {});
    let mut lost = first.lost;
    for _ in 0..9 {
        lost = lost.max(step_on_account(&mut fluid, |_, _| {}).lost);
    }
    (first.force.x, lost / (first.force.norm() * first.dt))
}

#[test]
fn a_structure_bears_the_drag_of_the_completed_viscosity() {
    let (plain, lost) = drag(|plain| plain);
    assert!(plain > 0.0 && lost < 1e-12, "{plain} N, {lost:e}");
    let (whole, lost) = drag(CompletedViscosity);
    assert!(lost < 1e-12, "{lost:e}");
    // The plate completes the neighbourhoods below; what is left to complete is at the ends of the puddle.
    assert!(whole > 1.001 * plain && whole < 1.1 * plain, "{plain} and {whole} N");
}
