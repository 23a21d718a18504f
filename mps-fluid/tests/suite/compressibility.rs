//! A fluid knows how compressible it is, and has been.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{lattice, water};
use mps_fluid::{Boundary, Fluid, FluidParticles, Tension};
use mps_kernel::Vector;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::{Open, Parallel};

/// A block of water that flies with three tenths of the speed of sound; one particle is compressed by 2 %, another one is thinner by 5 %.
fn block(tension: Tension) -> Fluid<f64, 2, WendlandGradient> {
    let mut config = water::<f64, 2>(0.01, 0.1);
    (config.tension, config.gravity) = (tension, Vector::zeros());
    let mut particles = FluidParticles::at_rest(lattice([0.0; 2], [6; 2], 0.01));
    particles.velocity.fill(Vector::from([0.3 * config.sound_speed, 0.0]));
    (particles.density[9], particles.density[20]) = (1.02, 0.95);
    Fluid::new(config, WendlandGradient, |_: &_| (), Open, particles, Boundary::default()).unwrap()
}

#[test]
fn it_is_that_of_the_fastest_and_of_the_most_compressed_particle() {
    let parallel = Parallel::serial();
    // Where there is no tension a low density makes no pressure.
    for (tension, density) in [(Tension::Clip, 0.02), (Tension::Keep, 0.05)] {
        let mut fluid = block(tension);
        assert_eq!((fluid.compressibility().mach, fluid.largest_compressibility().density), (0.0, 0.0));
        fluid.begin_step(&parallel).unwrap();
        let now = fluid.compressibility();
        assert!((now.mach - 0.3).abs() < 1e-12 && (now.density - density).abs() < 1e-12, "{now:?}");
        assert_eq!(now, fluid.largest_compressibility());
    }
}

#[test]
fn the_largest_is_remembered() {
    let parallel = Parallel::serial();
    let mut fluid = block(Tension::Clip);
    fluid.step(&parallel).unwrap();
    let before = fluid.largest_compressibility();
    fluid.particles_mut().velocity.fill(Vector::zeros());
    fluid.particles_mut().density.fill(1.0);
    fluid.step(&parallel).unwrap();
    let now = fluid.compressibility();
    assert!(now.mach == 0.0 && now.density == 0.0, "{now:?}");
    assert_eq!(fluid.largest_compressibility(), before);
}
