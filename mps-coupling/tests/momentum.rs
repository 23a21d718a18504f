//! What the structure gains the fluid loses, to round-off.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{Wet, floating, floating_in, gate, lattice, solid_of};
use mps_coupling::Fixed;
use mps_fluid::Slip;
use mps_kernel::Vector;
use mps_neighbors::Parallel;

fn momenta<const D: usize>(scene: &Wet<D>) -> [Vector<f64, D>; 2] {
    let parallel = Parallel::serial();
    [scene.fluid().momentum(&parallel), solid_of(scene).momentum(&parallel)]
}

fn keeps_the_total_momentum<const D: usize>(mut scene: Wet<D>, steps: usize) {
    let parallel = Parallel::serial();
    scene.audit_interval = 1;
    let start = momenta(&scene);
    let fluid = scene.fluid();
    let mass = fluid.config().particle_mass();
    let size: f64 = fluid.particles().velocity.iter().map(|u| mass * u.norm()).sum();
    for _ in 0..steps {
        scene.step(&parallel, f64::INFINITY).unwrap();
        let now = momenta(&scene);
        let defect = (now[0] + now[1] - start[0] - start[1]).norm() / size;
        assert!(defect < 1e-12, "step {}: {defect:e}", scene.fluid().steps());
    }
    assert!(scene.substeps() > 1, "sub-cycled: {}", scene.substeps());
    assert!(scene.budget().residual < 1e-12, "action and reaction: {:e}", scene.budget().residual);
    let handed_over = momenta(&scene)[1] - start[1];
    assert!(handed_over.norm() > 1e-3 * size, "much has been handed over: {}", handed_over.norm() / size);
    // The books say the same.
    let booked = (scene.budget().impulse() - handed_over).norm() / size;
    assert!(booked < 1e-12, "{booked:e}");
}

/// A post stands in the way of the blob: the block is handed what it gains, and both together what is in the books.
#[test]
fn every_structure_has_its_own_impulse() {
    let parallel = Parallel::serial();
    let mut scene = floating(0.3);
    let l0 = 0.01;
    let post = lattice([24.0 * l0, 6.0 * l0], [4, 12], l0);
    let volumes = vec![l0 * l0; post.len()];
    scene.add_structure(&parallel, Box::new(Fixed::new(post, volumes, l0)), Slip::None).unwrap();
    let [fluid, start] = momenta(&scene);
    for _ in 0..50 {
        scene.step(&parallel, f64::INFINITY).unwrap();
    }
    let [block, post] = [0, 1].map(|k| scene.budget().handed[k].push.force);
    let size = scene.budget().impulse().norm() + block.norm();
    assert!(post.x > 0.05 * size && block.norm() > 1e-3 * size, "{post} {block}");
    assert!((momenta(&scene)[1] - start - block).norm() < 1e-12 * size);
    // Nothing else pushes the blob: what it has lost is what both were handed.
    let mass = scene.fluid().config().particle_mass();
    let moved: f64 = scene.fluid().particles().velocity.iter().map(|u| mass * u.norm()).sum();
    assert!((momenta(&scene)[0] - fluid + block + post).norm() < 1e-12 * moved);
}

#[test]
fn a_block_floating_in_a_blob_keeps_the_total_momentum() {
    keeps_the_total_momentum(floating(0.3), 50);
    keeps_the_total_momentum(floating_in::<3>(0.3, 14, 6), 50);
}

#[test]
fn action_is_reaction_at_a_gate_in_every_step() {
    let parallel = Parallel::serial();
    for slip in [Slip::Free, Slip::None] {
        let mut scene = gate([20, 40], slip);
        scene.audit_interval = 1;
        for _ in 0..50 {
            scene.step(&parallel, f64::INFINITY).unwrap();
        }
        let budget = scene.budget();
        assert_eq!(budget.audits, 50);
        assert!(budget.residual < 1e-12, "{slip:?}: {:e}", budget.residual);
        assert!(budget.impulse().x > 0.0, "the water pushes the gate outwards: {}", budget.impulse());
        assert!(budget.work() > 0.0, "and does work on it: {}", budget.work());
    }
}

#[test]
fn the_audit_can_be_switched_off_and_forces_are_those_on_the_structure() {
    let parallel = Parallel::serial();
    let mut scene = gate([20, 40], Slip::Free);
    scene.audit_interval = 0;
    scene.step(&parallel, f64::INFINITY).unwrap();
    assert_eq!(scene.budget().audits, 0);
    let forces = scene.forces(0).unwrap();
    assert_eq!(forces.len(), solid_of(&scene).len());
    let sum = forces.iter().sum::<Vector<f64, 2>>();
    // Hydrostatic: the gate is the lower half of 0.1 m.
    let expected = 1000.0 * 9.81 * 0.05 * 0.075;
    assert!((sum.x / expected - 1.0).abs() < 0.1, "{} N instead of {expected} N", sum.x);
    assert!(scene.forces(1).is_none() && scene.structure(1).is_none() && scene.interface(1).is_none());
}
