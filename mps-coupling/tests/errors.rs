//! What a scene refuses, and that it says which structure it means.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::{Piston, lattice};
use mps_coupling::{CouplingError, Scene};
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidParticles, Slip};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Open, Parallel};

const L0: f64 = 0.01;

fn pool() -> Scene<f64, 2> {
    let particles = FluidParticles::at_rest(lattice([0.0; 2], [8, 8], L0));
    let config = FluidConfig::water(L0, 10.0);
    Scene::new(Fluid::new(config, Rational, |_| (), Open, particles, Boundary::default()).unwrap())
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
        Err(CouplingError::Lengths { index: 1, positions: 32, volumes: 31 }) => {}
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_position_that_is_no_number_is_refused() {
    let mut lost = piston();
    lost.position[3].x = f64::NAN;
    assert!(matches!(add(&mut pool(), lost), Err(CouplingError::Interface(_))));
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
    scene.max_substeps = 20_000;
    scene.step(&Parallel::serial(), 1e-4).unwrap();
    assert!(scene.substeps() >= 10_000);

    for limit in [0.0, f64::NAN] {
        let mut scene = pool();
        add(&mut scene, stiff(limit)).unwrap();
        let error = scene.step(&Parallel::serial(), 1e-4).unwrap_err();
        assert!(matches!(error, CouplingError::SubSteps { index: 0, .. }), "{limit}: {error}");
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
