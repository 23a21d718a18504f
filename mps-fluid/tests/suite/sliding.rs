//! Water that slides along a wall feels the weight above it and nothing else.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::lattice;
use mps_fluid::{
    ArtificialViscosity, Boundary, EquationOfState, Fluid, FluidConfig, FluidParticles, Slip, Tait,
};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Parallel, PeriodicBox};

const L0: f64 = 0.01;
const COLUMNS: usize = 20;
const ROWS: usize = 10;
/// Sound speed \[m/s\] and speed along the wall, as in a dam break of 0.6 m.
const SOUND: f64 = 34.0;
const SPEED: f64 = 3.0;
const WEIGHT: f64 = 1000.0 * 9.81;

/// A layer of water that slides over a bed whose points lie `fine` times as close as the particles.
/// Root mean square error of the pressure over that at the bed, and the share of the speed that is kept.
fn slide(fine: usize) -> (f64, f64) {
    let parallel = Parallel::serial();
    let depth = ROWS as f64 * L0;
    let eos = Tait::new(1000.0, SOUND);
    let mut water = FluidParticles::at_rest(lattice::<f64, 2>([0.0; 2], [COLUMNS, ROWS], L0));
    for ((n, u), r) in water.density.iter_mut().zip(&mut water.velocity).zip(&water.position) {
        *n = eos.density(WEIGHT * (depth - r.y));
        u.x = SPEED;
    }
    let mut bed = Boundary::default();
    let (spacing, volume) = (L0 / fine as f64, 1.0 / (fine * fine) as f64);
    let points = lattice([0.0, -3.0 * L0], [COLUMNS * fine, 3 * fine], spacing);
    bed.add_fine_wall(&points, volume, Slip::Free).unwrap();
    let channel = PeriodicBox::new(Vector::zeros(), [Some(COLUMNS as f64 * L0), None]).unwrap();
    let mut config = FluidConfig::<f64, 2>::water(L0, SOUND);
    config.gravity.y = -9.81;
    let viscosity = |r: &_| ArtificialViscosity::new::<2>(0.02, SOUND, r);
    let mut fluid = Fluid::new(config, Rational, viscosity, channel, water, bed).unwrap();

    let (mut squares, mut count) = (0.0, 0.0);
    while fluid.time() < 0.4 {
        fluid.step(&parallel).unwrap();
        if fluid.time() > 0.2 && fluid.steps().is_multiple_of(10) {
            let water = fluid.particles();
            for (r, p) in water.position.iter().zip(&water.pressure) {
                squares += (p - WEIGHT * (depth - r.y)).powi(2);
                count += 1.0;
            }
        }
    }
    let speed = fluid.particles().velocity.iter().map(|u| u.x).sum::<f64>() / (COLUMNS * ROWS) as f64;
    ((squares / count).sqrt() / (WEIGHT * depth), speed / SPEED)
}

/// The bed of a dam break once had the spacing of the water: the pressure on it was four fifths noise.
#[test]
fn points_at_half_the_spacing_are_smooth() {
    let (noise, kept) = slide(2);
    assert!(noise < 0.06, "the pressure is off by {noise} of that at the bed");
    assert!((kept - 1.0).abs() < 1e-3, "{kept} of the speed is left");
}

#[test]
fn points_at_the_spacing_of_the_water_are_rough() {
    let (noise, kept) = slide(1);
    assert!(noise > 0.3 && kept < 0.998, "no longer needed? pressure off by {noise}, speed {kept}");
}
