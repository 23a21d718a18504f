//! A fluid knows how compressible it is, and has been.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{lattice, water};
use mps_fluid::{Boundary, EquationOfState, Fluid, FluidConfig, FluidParticles, Tension};
use mps_kernel::Vector;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::{Open, Parallel, PeriodicBox};

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

/// A standing wave of sound so weak that the background pressure is never lost: nothing is clipped, so that nothing may differ.
#[test]
fn a_wave_below_the_background_pressure_has_the_same_energy_with_and_without_tension() {
    let parallel = Parallel::serial();
    let run = |tension| {
        let mut config = FluidConfig::<f64, 2>::water(0.01, 10.0);
        (config.tension, config.background_pressure, config.collisions) = (tension, 2000.0, None);
        let mut particles = FluidParticles::at_rest(lattice::<f64, 2>([0.0; 2], [20, 10], 0.01));
        for (n, r) in particles.density.iter_mut().zip(&particles.position) {
            *n = 1.0 + 0.015 * (r.x * core::f64::consts::TAU / 0.2).cos();
        }
        let domain = PeriodicBox::new(Vector::zeros(), [Some(0.2), Some(0.1)]).unwrap();
        let nothing = Boundary::default();
        let mut fluid = Fluid::new(config, WendlandGradient, |_: &_| (), domain, particles, nothing).unwrap();
        let mut energies = vec![fluid.energy(&parallel)];
        for _ in 0..40 {
            fluid.step(&parallel).unwrap();
            energies.push(fluid.energy(&parallel));
        }
        assert!(fluid.particles().density.iter().any(|n| *n < 0.995));
        (energies, fluid.largest_compressibility())
    };
    assert_eq!(run(Tension::Clip), run(Tension::Keep));
}

/// Where the pressure has ended nothing more is stored: the energy goes on from what it was there, without a step.
#[test]
fn without_pressure_the_stored_energy_stays() {
    let stored = |density: f64| {
        let mut config = FluidConfig::<f64, 2>::water(0.01, 10.0);
        config.background_pressure = 2000.0;
        let mut particles = FluidParticles::at_rest(vec![Vector::zeros()]);
        particles.density[0] = density;
        let nothing = Boundary::default();
        let fluid = Fluid::new(config, WendlandGradient, |_: &_| (), Open, particles, nothing).unwrap();
        (fluid.energy(&Parallel::serial()).compression, fluid.particles().pressure[0])
    };
    let end = FluidConfig::<f64, 2> { background_pressure: 2000.0, ..FluidConfig::water(0.01, 10.0) }
        .equation_of_state()
        .density(0.0);
    let ((above, pressure), (below, none), (far, _)) = (stored(end + 1e-9), stored(end - 1e-9), stored(0.5));
    assert!(pressure > 0.0 && none == 0.0);
    assert!((above - below).abs() < 1e-12 && below == far && far < 0.0, "{above}, {below}, {far} J");
}
