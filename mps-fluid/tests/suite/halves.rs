//! The halves of a step in any order: what is out of turn is left undone, and said.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{Noise, tank, water};
use mps_fluid::{ArtificialViscosity, Dpc, Fluid, FluidError, Shifting};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::Parallel;

type Water = Fluid<f64, 2, Rational, ArtificialViscosity<f64>>;

/// A shaken tank that collides and shifts, two steps old.
fn shaken() -> Water {
    let mut config = water::<f64, 2>(0.01, 0.1);
    (config.collisions, config.shifting) = (Some(Dpc::default()), Some(Shifting::default()));
    let c = config.sound_speed;
    let mut fluid = tank([10, 10], config, |r| ArtificialViscosity::new::<2>(0.05, c, r));
    let mut noise = Noise::new(5);
    fluid.particles_mut().velocity.iter_mut().for_each(|u| *u = noise.vector(0.5));
    fluid.keep_books();
    for _ in 0..2 {
        fluid.step(&Parallel::serial()).unwrap();
    }
    fluid
}

#[test]
fn a_step_that_has_not_begun_is_not_finished() {
    let parallel = Parallel::serial();
    // Before the first step as well, where there are no rows yet.
    let fresh = tank([10, 10], water::<f64, 2>(0.01, 0.1), |r| ArtificialViscosity::new::<2>(0.05, 10.0, r));
    for mut fluid in [fresh, shaken()] {
        let (before, steps) = (fluid.particles().clone(), fluid.steps());
        fluid.finish_step(&parallel, 1e-5);
        assert!(*fluid.particles() == before && fluid.steps() == steps);
        let error = fluid.begin_step(&parallel).unwrap_err();
        assert!(matches!(error, FluidError::Turn { call: "finish_step" }), "{error}");
        // Said once; nothing else has happened.
        fluid.step(&parallel).unwrap();
        assert_eq!(fluid.steps(), steps + 1);
    }
}

#[test]
fn a_step_of_no_length_is_not_made() {
    let parallel = Parallel::serial();
    for dt in [f64::NAN, 0.0, -1e-5, f64::INFINITY] {
        let (mut fluid, mut twin) = (shaken(), shaken());
        fluid.begin_step(&parallel).unwrap();
        fluid.finish_step(&parallel, dt);
        let error = fluid.begin_step(&parallel).unwrap_err();
        assert!(matches!(error, FluidError::StepLength { .. }), "{dt}: {error}");
        // It goes on as if it had not been asked.
        fluid.step(&parallel).unwrap();
        twin.step(&parallel).unwrap();
        assert!(fluid.particles() == twin.particles() && fluid.budget() == twin.budget(), "{dt}");
    }
}

#[test]
fn a_step_begun_twice_is_regularised_once() {
    let parallel = Parallel::serial();
    let (mut twice, mut once) = (shaken(), shaken());
    twice.begin_step(&parallel).unwrap();
    twice.add_acceleration(&parallel, |_| Vector::from([1e3, 0.0]));
    for fluid in [&mut twice, &mut once] {
        fluid.step(&parallel).unwrap();
    }
    assert_eq!(twice.particles(), once.particles());
    assert_eq!(twice.budget(), once.budget());
    assert_eq!(twice.budget().unwrap().field, 0.0);
}

#[test]
fn nor_after_one_that_has_failed() {
    let parallel = Parallel::serial();
    let (mut fluid, mut twin) = (shaken(), shaken());
    fluid.begin_step(&parallel).unwrap();
    let density = fluid.particles().density[17];
    fluid.particles_mut().density[17] = f64::NAN;
    assert!(matches!(fluid.begin_step(&parallel), Err(FluidError::NotFinite { .. })));
    // Nor can such a step be finished.
    let before = fluid.particles().position.clone();
    fluid.finish_step(&parallel, 1e-5);
    assert_eq!(fluid.particles().position, before);
    assert!(matches!(fluid.begin_step(&parallel), Err(FluidError::Turn { .. })));
    fluid.particles_mut().density[17] = density;
    fluid.step(&parallel).unwrap();
    twin.step(&parallel).unwrap();
    assert_eq!(fluid.particles(), twin.particles());
}

#[test]
fn an_acceleration_between_steps_does_nothing_and_is_not_booked() {
    let parallel = Parallel::serial();
    let (mut fluid, mut twin) = (shaken(), shaken());
    fluid.add_acceleration(&parallel, |_| Vector::from([1e3, 0.0]));
    let error = fluid.begin_step(&parallel).unwrap_err();
    assert!(matches!(error, FluidError::Turn { call: "add_acceleration" }), "{error}");
    fluid.step(&parallel).unwrap();
    twin.step(&parallel).unwrap();
    assert!(fluid.particles() == twin.particles() && fluid.budget() == twin.budget());
}

#[test]
fn particles_and_points_that_come_or_go_in_a_step_are_refused() {
    type Spoil = fn(&mut Water);
    let spoils: [Spoil; 3] = [
        |fluid| fluid.particles_mut().position.truncate(50),
        |fluid| fluid.particles_mut().density.truncate(50),
        |fluid| fluid.boundary_mut().velocity.truncate(50),
    ];
    for spoil in spoils {
        let parallel = Parallel::serial();
        let mut fluid = shaken();
        let dt = fluid.begin_step(&parallel).unwrap();
        spoil(&mut fluid);
        fluid.finish_step(&parallel, dt);
        let error = fluid.begin_step(&parallel).unwrap_err();
        assert!(
            matches!(error, FluidError::FieldLength { .. } | FluidError::BoundaryLength { .. }),
            "{error}"
        );
    }
}
