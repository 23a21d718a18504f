//! The tank also rests in three dimensions and in single precision.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{pressure_error, tank_of, water};
use mps_fluid::ArtificialViscosity;
use mps_kernel::weights::{Rational, WendlandGradient};
use mps_kernel::{Kernel, Real};
use mps_neighbors::Parallel;

/// Pressure error, kinetic over potential energy of the start, level over depth after `time`.
fn rest<T: Real, const D: usize>(kernel: impl Kernel<T>, n: usize, l0: f64, time: f64) -> [f64; 3] {
    let parallel = Parallel::all_cores().unwrap();
    let depth = l0 * n as f64;
    let config = water::<T, D>(l0, depth);
    let c = config.sound_speed;
    let mut fluid = tank_of(kernel, [n; D], config, |r| ArtificialViscosity::new::<D>(T::of(0.05), c, r));
    let start = fluid.energy(&parallel).potential.to_double();
    while fluid.time().to_double() < time {
        fluid.step(&parallel).unwrap();
    }
    let top = fluid.particles().position.iter().map(|r| r[D - 1].to_double()).fold(0.0, f64::max);
    let kinetic = fluid.energy(&parallel).kinetic.to_double() / start;
    [pressure_error(&fluid, depth), kinetic, (top + 0.5 * l0) / depth]
}

#[test]
fn a_cube_of_water_rests() {
    let [error, kinetic, level] = rest::<f64, 3>(Rational, 12, 0.01, 0.25);
    assert!(error < 0.05, "pressure error {error}");
    assert!(kinetic < 1e-3, "kinetic energy {kinetic}");
    assert!((level - 1.0).abs() < 0.05, "level {level}");
}

#[test]
fn single_precision_rests_like_double() {
    let single = rest::<f32, 2>(WendlandGradient, 20, 0.01, 0.5);
    let double = rest::<f64, 2>(WendlandGradient, 20, 0.01, 0.5);
    assert!(single[0] < 0.015, "pressure error {}", single[0]);
    // The particles creep past each other in another order, so that only measures of the whole agree.
    assert!((single[0] - double[0]).abs() < 0.005, "{} and {}", single[0], double[0]);
    assert!(single[1] < 2e-4 && (single[2] - 1.0).abs() < 0.005, "{single:?}");
}
