//! Shear on a structure follows its sub-steps: it damps vibrations, and its reaction is exact.
//!
//! Held over the step of the fluid, the drag on a mode that turns by more than a quarter in a step comes when the motion has turned
//! back, and drives it: flags without slip shook themselves apart within seconds.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{Noise, Rubber, block, lattice};
use mps_coupling::Scene;
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidParticles, LaminarViscosity, Slip};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Open, Parallel};

type Viscous = Scene<f64, 2, Rational, LaminarViscosity<f64>>;

/// A stiff block that vibrates in a blob of viscous fluid at rest, with a dozen sub-steps in a step.
fn vibrating() -> Viscous {
    let (l0, c) = (0.01, 1.0);
    let inside = |r: &Vector<f64, 2>| r.iter().all(|&x| x > 8.0 * l0 && x < 16.0 * l0);
    let particles =
        FluidParticles::at_rest(lattice([0.0; 2], [24, 24], l0).into_iter().filter(|r| !inside(r)).collect());
    let viscosity = |r: &_| LaminarViscosity::new::<2>(1e-3, r);
    let config = FluidConfig::water(l0, c);
    let fluid = Fluid::new(config, Rational, viscosity, Open, particles, Boundary::default()).unwrap();
    let mut scene = Scene::new(fluid);
    let parallel = Parallel::serial();
    let mut solid = block([8.0 * l0; 2], [16.0 * l0; 2], [8, 8], &[], 1e5);
    let mut noise = Noise::new(3);
    solid.velocities_mut().iter_mut().for_each(|u| *u = noise.vector(1e-3));
    scene.add_structure(&parallel, Box::new(Rubber::new(solid)), Slip::None).unwrap();
    scene
}

#[test]
fn shear_damps_the_vibrations_of_a_body_and_keeps_the_momentum() {
    let parallel = Parallel::serial();
    let mut scene = vibrating();
    let momentum = |scene: &Viscous| {
        let solid = scene.structure(0).unwrap().as_any().downcast_ref::<Rubber>().unwrap().solid();
        scene.fluid().momentum(&parallel) + solid.momentum(&parallel)
    };
    let start = momentum(&scene);
    let energy = |scene: &Viscous| scene.energy(&parallel).1.total();
    let before = energy(&scene);
    for _ in 0..200 {
        scene.step(&parallel, f64::INFINITY).unwrap();
        assert!(energy(&scene) < 1.5 * before, "step {}: {}", scene.fluid().steps(), energy(&scene) / before);
    }
    assert!(scene.substeps() > 5, "{} sub-steps", scene.substeps());
    let left = energy(&scene) / before;
    assert!(left < 0.5, "{left} of the vibration is left");
    let size = 1e-3 * 1100.0 * 0.08 * 0.08;
    let lost = (momentum(&scene) - start).norm() / size;
    assert!(lost < 1e-12, "{lost:e}");
}
