//! What a scene refuses, and that it says which structure it means.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::{Piston, Rubber, block, lattice, rubber};
use mps_coupling::{CouplingError, Scene, Structure};
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidParticles, Slip};
use mps_kernel::weights::{Rational, WendlandC2};
use mps_kernel::{State, Vector};
use mps_neighbors::{Open, Parallel};
use mps_solid::materials::CorotationalHooke;
use mps_solid::{Solid, SolidConfig};
use std::any::Any;

const L0: f64 = 0.01;

fn pool() -> Scene<f64, 2> {
    let particles = FluidParticles::at_rest(lattice([0.0; 2], [8, 8], L0));
    let config = FluidConfig::water(L0, 10.0);
    Scene::new(Fluid::new(config, Rational, |_| (), Open, particles, Boundary::default()).unwrap())
}

fn saved(scene: &mut Scene<f64, 2>) -> State {
    State::save(|transfer| scene.transfer(&Parallel::serial(), transfer)).unwrap()
}

fn restore(scene: &mut Scene<f64, 2>, state: &State) {
    state.restore(|transfer| scene.transfer(&Parallel::serial(), transfer)).unwrap();
}

fn piston() -> Piston {
    Piston::new(lattice([0.0, 8.0 * L0], [8, 4], L0), L0, 1.0, 0.0)
}

fn add(scene: &mut Scene<f64, 2>, piston: Piston) -> Result<usize, CouplingError> {
    scene.add_structure(&Parallel::serial(), Box::new(piston), Slip::Free)
}

#[test]
fn structures_get_ascending_numbers_and_take_at_least_one_substep() {
    let mut scene = pool();
    assert_eq!(add(&mut scene, piston()).unwrap(), 0);
    let far = Piston::new(lattice([1.0, 1.0], [4, 4], L0), L0, 1.0, 0.0);
    assert_eq!(add(&mut scene, far).unwrap(), 1);
    scene.step(&Parallel::serial(), f64::INFINITY).unwrap();
    // An infinite limit still means one sub-step.
    assert_eq!(scene.substeps(), 1);
    scene.update_interfaces(&Parallel::serial());
    assert!(scene.interface(0).unwrap().wetted_count() >= 8, "one stands on the fluid");
    assert_eq!(scene.interface(1).unwrap().wetted_count(), 0, "the other is far away");
}

#[test]
fn a_step_is_no_longer_than_told() {
    let mut scene = pool();
    add(&mut scene, piston()).unwrap();
    assert_eq!(scene.step(&Parallel::serial(), 1e-7).unwrap(), 1e-7);
    assert_eq!(scene.fluid().time(), 1e-7);
}

#[test]
fn structures_after_the_first_step_are_too_late() {
    let mut scene = pool();
    scene.step(&Parallel::serial(), f64::INFINITY).unwrap();
    match add(&mut scene, piston()) {
        Err(error @ CouplingError::TooLate { steps: 1 }) => assert!(error.to_string().contains("before")),
        other => panic!("{other:?}"),
    }
}

#[test]
fn positions_without_volumes_are_refused() {
    let mut scene = pool();
    add(&mut scene, piston()).unwrap();
    let mut short = piston();
    short.volume.pop();
    match add(&mut scene, short) {
        Err(CouplingError::Lengths { index: 1, positions: 32, what: "volumes", got: 31 }) => {}
        other => panic!("{other:?}"),
    }
    let mut short = piston();
    short.mean.clear();
    let refused = add(&mut scene, short).unwrap_err();
    assert!(matches!(refused, CouplingError::Lengths { what: "mean velocities", got: 0, .. }), "{refused}");
    for volume in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let mut odd = piston();
        odd.volume[7] = volume;
        let refused = add(&mut scene, odd).unwrap_err();
        assert!(matches!(refused, CouplingError::Volume { index: 1, .. }), "{refused}");
    }
}

#[test]
fn a_step_without_length_is_refused_and_changes_nothing() {
    let mut scene = pool();
    add(&mut scene, piston()).unwrap();
    let parallel = Parallel::serial();
    scene.step(&parallel, f64::INFINITY).unwrap();
    let before = scene.fluid().particles().density.clone();
    for longest in [0.0, -1e-5, f64::NAN] {
        let refused = scene.step(&parallel, longest).unwrap_err();
        assert!(matches!(refused, CouplingError::Step { .. }), "{refused}");
        assert_eq!(scene.fluid().particles().density, before);
    }
    scene.step(&parallel, f64::INFINITY).unwrap();
}

#[test]
fn a_position_that_is_no_number_is_refused() {
    let mut lost = piston();
    lost.position[3].x = f64::NAN;
    let refused = add(&mut pool(), lost).unwrap_err();
    assert!(matches!(refused, CouplingError::NoNumber { index: 0, point: 3, .. }), "{refused}");
}

#[test]
fn a_structure_of_too_many_substeps_is_refused_until_they_are_allowed() {
    let stiff = |limit: f64| Piston { max_step: limit, ..piston() };
    let mut scene = pool();
    add(&mut scene, piston()).unwrap();
    add(&mut scene, stiff(1e-8)).unwrap();
    match scene.step(&Parallel::serial(), 1e-4) {
        Err(CouplingError::SubSteps { index: 1, substeps, limit, dt }) => {
            assert!((substeps - 1e4).abs() <= 1.0 && limit == 1e-8 && dt == 1e-4);
        }
        other => panic!("{other:?}"),
    }
    // The fluid has begun a step that nobody has ended.
    scene.max_substeps = 20_000;
    let refused = scene.step(&Parallel::serial(), 1e-4).unwrap_err();
    assert!(matches!(refused, CouplingError::Broken { time: 0.0 }), "{refused}");

    let mut scene = pool();
    add(&mut scene, stiff(1e-8)).unwrap();
    scene.max_substeps = 20_000;
    scene.step(&Parallel::serial(), 1e-4).unwrap();
    assert!(scene.substeps() >= 10_000);

    for limit in [0.0, f64::NAN] {
        let mut scene = pool();
        add(&mut scene, stiff(limit)).unwrap();
        let error = scene.step(&Parallel::serial(), 1e-4).unwrap_err();
        assert!(matches!(error, CouplingError::Limit { index: 0, .. }), "{limit}: {error}");
    }
}

#[test]
fn the_words_of_a_structure_are_passed_on() {
    let mut scene = pool();
    add(&mut scene, piston()).unwrap();
    add(&mut scene, Piston { breaks: true, ..piston() }).unwrap();
    let error = scene.step(&Parallel::serial(), f64::INFINITY).unwrap_err();
    assert!(matches!(error, CouplingError::Structure { index: 1, .. }));
    let words = error.to_string();
    assert!(words.contains("structure 1") && words.contains("the piston rod broke"), "{words}");
}

#[test]
fn errors_of_the_fluid_come_through() {
    let mut scene = pool();
    scene.fluid_mut().particles_mut().velocity[5] = Vector::<f64, 2>::new(f64::NAN, 0.0);
    let error = scene.step(&Parallel::serial(), f64::INFINITY).unwrap_err();
    assert!(matches!(error, CouplingError::Fluid(_)), "{error}");
}

/// It would have the velocities of the collisions twice, and bodies that have moved further than others.
#[test]
fn after_a_step_that_failed_there_is_none_until_a_state_is_restored() {
    let parallel = Parallel::serial();
    let mut scene = pool();
    let body = rubber([0.0, 8.0 * L0], [8.0 * L0, 12.0 * L0], [8, 4], &[], 1e5);
    scene.add_structure(&parallel, Box::new(body), Slip::Free).unwrap();
    scene.step(&parallel, f64::INFINITY).unwrap();
    let state = saved(&mut scene);
    // One particle of it is thrown through the others.
    scene.max_substeps = 100_000;
    let body = scene.structure_mut(0).unwrap() as &mut dyn Any;
    body.downcast_mut::<Rubber>().unwrap().solid_mut().velocities_mut()[12].x = 1e5;
    let error = scene.step(&parallel, f64::INFINITY).unwrap_err();
    assert!(matches!(error, CouplingError::Structure { index: 0, .. }), "{error}");
    for _ in 0..2 {
        let refused = scene.step(&parallel, f64::INFINITY).unwrap_err();
        assert!(matches!(refused, CouplingError::Broken { .. }), "{refused}");
    }
    restore(&mut scene, &state);
    scene.step(&parallel, f64::INFINITY).unwrap();
}

#[test]
fn what_an_elastic_body_holds_can_be_changed_between_steps() {
    let mut scene = pool();
    let body = rubber([0.0, 8.0 * L0], [8.0 * L0, 12.0 * L0], [8, 4], &[], 1e5);
    scene.add_structure(&Parallel::serial(), Box::new(body), Slip::Free).unwrap();
    assert!(scene.structure_mut(1).is_none());
    let body = scene.structure_mut(0).unwrap() as &mut dyn Any;
    let solid = body.downcast_mut::<Rubber>().unwrap().solid_mut();
    solid.velocities_mut().fill(Vector::from([0.0, 0.5]));
    scene.step(&Parallel::serial(), 1e-4).unwrap();
    let mean = scene.structure(0).unwrap().mean_velocities()[5];
    assert!((mean.y - 0.5).abs() < 0.05, "{mean}");
}

/// The spring of the fluid needs the rest of the border.
#[test]
fn an_elastic_body_leaves_room_for_the_spring_of_the_fluid() {
    for cfl in [0.3, 0.8, 0.95, 1.0] {
        let solid = block([0.0; 2], [8.0 * L0, 4.0 * L0], [8, 4], &[], 1e5);
        let config = SolidConfig { cfl, ..SolidConfig::default() };
        let (particles, spacing) = (solid.particles().clone(), *solid.spacing());
        let material = CorotationalHooke::new(1e5, 0.4).unwrap();
        let serial = Parallel::serial();
        let solid = Solid::new(particles, spacing, 1100.0, material, WendlandC2, config, &serial).unwrap();
        let border = solid.max_step(&serial) / cfl;
        let step = Rubber::<2>::new(solid).max_step(&serial);
        assert!((step / border - cfl.min(0.8)).abs() < 1e-12, "{cfl}: {}", step / border);
    }
}
