//! Shear on a structure without slip follows its sub-steps: it damps vibrations, and its reaction is exact, as is that of a law of the wall.
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

/// A stiff block with these velocities by place in a blob of viscous fluid at rest, with a dozen sub-steps in a step.
fn in_a_blob(slip: Slip, mut velocity: impl FnMut(&Vector<f64, 2>) -> Vector<f64, 2>) -> Viscous {
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
    let places = solid.positions().to_vec();
    solid.velocities_mut().iter_mut().zip(&places).for_each(|(u, r)| *u = velocity(r));
    scene.add_structure(&parallel, Box::new(Rubber::new(solid)), slip).unwrap();
    scene
}

/// Of fluid and body.
fn momentum(scene: &Viscous) -> Vector<f64, 2> {
    let parallel = Parallel::serial();
    let solid = scene.structure(0).unwrap().as_any().downcast_ref::<Rubber>().unwrap().solid();
    scene.fluid().momentum(&parallel) + solid.momentum(&parallel)
}

#[test]
fn shear_damps_the_vibrations_of_a_body_and_keeps_the_momentum() {
    let parallel = Parallel::serial();
    let mut noise = Noise::new(3);
    let mut scene = in_a_blob(Slip::None, |_| noise.vector(1e-3));
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

/// The friction of a law of the wall, which is held over the sub-steps, has its reaction: beside a body that slides along without slip or friction
/// the momentum would be kept as well, hence what friction itself hands over is looked at.
#[test]
fn the_friction_of_a_law_of_the_wall_on_a_sliding_body_has_its_reaction() {
    let parallel = Parallel::serial();
    let speed = Vector::from([0.2, 0.07]);
    let mass = 1100.0 * 0.08 * 0.08;
    let mut after = [Slip::Free, Slip::Law].map(|slip| {
        let mut scene = in_a_blob(slip, |_| speed);
        let start = momentum(&scene);
        for _ in 0..10 {
            scene.step(&parallel, f64::INFINITY).unwrap();
        }
        let lost = (momentum(&scene) - start).norm() / (mass * speed.norm());
        assert!(lost < 1e-12, "{slip:?}: {lost:e}");
        scene.fluid().momentum(&parallel)
    });
    let [free, law] = &mut after;
    let handed = (*law - *free).dot(&speed) / speed.norm();
    assert!(handed > 1e-4 * mass * speed.norm(), "friction has handed over {handed:e} kg m/s");
}
