//! Bad states are reported by the name of the particle; a lost one does not stop the others.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]
#![allow(unsafe_code, reason = "counting memory takes a global allocator")]

use crate::common::{tank, water};
use mps_fluid::{ArtificialViscosity, Fluid, FluidError, Tension};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::Parallel;
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

struct Largest;

static LARGEST: AtomicUsize = AtomicUsize::new(0);

// SAFETY: hands everything to the system allocator unchanged.
unsafe impl GlobalAlloc for Largest {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        LARGEST.fetch_max(layout.size(), Ordering::Relaxed);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller's promises are passed on.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Largest = Largest;

type Tank = Fluid<f64, 2, Rational, ArtificialViscosity<f64>>;

fn small_tank() -> Tank {
    let config = water::<f64, 2>(0.01, 0.15);
    let c = config.sound_speed;
    tank([15, 15], config, |r| ArtificialViscosity::new::<2>(0.05, c, r))
}

#[test]
fn a_particle_thrown_a_million_metres_away_neither_stops_the_run_nor_costs_memory() {
    let parallel = Parallel::serial();
    let mut fluid = small_tank();
    let top = fluid.particles().id.len() - 1;
    fluid.particles_mut().position[top] = Vector::<f64, 2>::new(1e6, -1e6);
    fluid.particles_mut().velocity[top] = Vector::<f64, 2>::new(10.0, 3.0);
    for _ in 0..200 {
        fluid.step(&parallel).unwrap();
    }
    assert!(fluid.rebuilds() > 10, "{} rebuilds", fluid.rebuilds());
    // The tank is 30 kB a field; a grid from here to there would be terabytes.
    let largest = LARGEST.load(Ordering::Relaxed);
    assert!(largest < 4 << 20, "{largest} bytes in one piece");
    let particles = fluid.particles();
    let far = particles.id.iter().position(|&id| id as usize == top).unwrap();
    assert!((particles.position[far].x - 1e6 - 10.0 * fluid.time()).abs() < 1e-6);
    let others = particles.position.iter().enumerate().filter(|(i, _)| *i != far);
    assert!(others.into_iter().all(|(_, r)| r.norm() < 0.3), "the tank stays");
}

fn spoilt(spoil: impl FnOnce(&mut Tank, usize)) -> FluidError {
    let parallel = Parallel::serial();
    let mut fluid = small_tank();
    for _ in 0..3 {
        fluid.step(&parallel).unwrap();
    }
    let i = fluid.particles().id.iter().position(|&id| id == 117).unwrap();
    spoil(&mut fluid, i);
    fluid.begin_step(&parallel).unwrap_err()
}

#[test]
fn a_velocity_that_is_no_number_names_its_particle() {
    let error = spoilt(|fluid, i| fluid.particles_mut().velocity[i].y = f64::NAN);
    assert!(matches!(error, FluidError::NotFinite { id: 117, quantity: "speed", step: 3, .. }), "{error}");
    assert!(error.to_string().contains("117"), "{error}");
    let error = spoilt(|fluid, i| fluid.particles_mut().velocity[i].x = f64::INFINITY);
    assert!(matches!(error, FluidError::NotFinite { id: 117, .. }), "{error}");
}

#[test]
fn a_density_that_is_no_number_names_its_particle() {
    let error = spoilt(|fluid, i| fluid.particles_mut().density[i] = f64::NAN);
    assert!(matches!(error, FluidError::NotFinite { id: 117, quantity: "density", .. }), "{error}");
}

#[test]
fn a_position_that_is_no_number_is_refused() {
    let error = spoilt(|fluid, i| fluid.particles_mut().position[i].y = f64::NAN);
    assert!(matches!(error, FluidError::Neighbors(_)), "{error}");
}

#[test]
fn a_particle_beyond_all_speeds_is_named_and_the_run_given_up() {
    let error = spoilt(|fluid, i| fluid.particles_mut().velocity[i].x = 1e5);
    match error {
        FluidError::TimeStep { id, speed, .. } => assert!(id == 117 && speed > 1e4, "{error}"),
        _ => panic!("{error}"),
    }
}

/// Nobody is near to be spoilt by it, and its pressure is none.
#[test]
fn a_lone_particle_whose_density_is_no_number_is_named() {
    let parallel = Parallel::serial();
    for tension in [Tension::Clip, Tension::Keep] {
        let mut config = water::<f64, 2>(0.01, 0.15);
        config.tension = tension;
        let mut fluid = tank([15, 15], config, |_| ());
        fluid.particles_mut().position[7] = Vector::from([5.0, 5.0]);
        fluid.step(&parallel).unwrap();
        let i = fluid.particles().id.iter().position(|&id| id == 7).unwrap();
        fluid.particles_mut().density[i] = f64::NAN;
        let error = fluid.begin_step(&parallel).unwrap_err();
        assert!(matches!(error, FluidError::NotFinite { id: 7, quantity: "density", .. }), "{error}");
    }
}
