//! In single precision a position far from the origin moves in steps of its last place, but what the fluid is told of the motion is smooth.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use mps_coupling::{ElasticBody, Scene};
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidParticles, Slip};
use mps_kernel::Vector;
use mps_kernel::weights::{Rational, WendlandC2};
use mps_neighbors::{Open, Parallel};
use mps_solid::materials::CorotationalHooke;
use mps_solid::{Solid, SolidConfig, body};

const L0: f32 = 0.01;
/// Where the scene begins along both axes: the last place of a coordinate there is 6e-8 m.
const FAR: f32 = 0.6;

/// A block of rubber that glides with `speed` \[m/s\] below water at rest, too far away to be pushed by it.
fn gliding(speed: Vector<f32, 2>) -> Scene<f32, 2> {
    let serial = Parallel::serial();
    let places = (0..64_u8).map(|k| {
        let cell = Vector::from([k % 8, k / 8].map(f32::from));
        cell.map(|k| FAR + (k + 0.5) * L0)
    });
    let water = FluidParticles::at_rest(places.collect());
    let config = FluidConfig::water(L0, 10.0);
    let fluid = Fluid::new(config, Rational, |_| (), Open, water, Boundary::default()).unwrap();
    let [lower, upper] =
        [[FAR, FAR - 10.0 * L0], [FAR + 8.0 * L0, FAR - 6.0 * L0]].map(Vector::<f32, 2>::from);
    let block = body::block(lower, upper, [8, 4], &[]).unwrap();
    // So soft that its sound carries the rounding of its positions, 6e-6 of a spacing, on with 0.4 m/s only.
    let material = CorotationalHooke::new(1e2, 0.4).unwrap();
    let config = SolidConfig::default();
    let mut solid =
        Solid::new(block.particles, block.spacing, 1100.0, material, WendlandC2, config, &serial).unwrap();
    solid.velocities_mut().fill(speed);
    let mut scene = Scene::new(fluid);
    scene.add_structure(&serial, Box::new(ElasticBody::new(solid)), Slip::Free).unwrap();
    scene
}

/// Taken from positions they were multiples of the last place over the step, 1e-4 m/s here.
#[test]
fn the_fluid_sees_the_velocity_of_a_slow_body_and_not_the_last_place_of_its_positions() {
    let speed = 7e-4;
    for substeps in [1, 4, 16] {
        let mut scene = gliding(Vector::from([speed, 0.0]));
        scene.min_substeps = substeps;
        for step in 0..5 {
            let dt = scene.step(&Parallel::serial(), f32::INFINITY).unwrap();
            let grain = 0.5 * f32::EPSILON / dt;
            assert!(grain > 0.1 * speed, "a step of {dt} s does not show it: {grain} m/s");
            let boundary = scene.fluid().boundary();
            for u in &boundary.velocity[boundary.reactive()] {
                let off = (u.x / speed - 1.0).abs();
                assert!(off < 0.01, "{substeps} sub-steps, step {step}: {} m/s", u.x);
            }
        }
    }
}
