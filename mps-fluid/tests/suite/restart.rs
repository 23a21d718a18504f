//! A fluid that was saved and restored into a twin goes on with the bits of one that was not: at any moment between two rebuilds of its
//! rows, for any number of threads.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

use crate::common::{Noise, closed_walls, lattice, tank, water};
use crate::openings::channel;
use mps_fluid::{
    ArtificialViscosity, Boundary, Diffusion, Fluid, FluidConfig, FluidParticles, LaminarViscosity, Limit,
    PressureForm, Shifting, Slip, Tension, Viscosity,
};
use mps_kernel::weights::{Rational, WendlandGradient};
use mps_kernel::{Kernel, Real, State, StateError, Vector};
use mps_neighbors::{Domain, Open, Parallel, PeriodicBox};

fn save<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>>(
    fluid: &mut Fluid<T, D, K, V, P>,
) -> State {
    State::save(|transfer| fluid.transfer(&Parallel::serial(), transfer)).unwrap()
}

/// Runs `steps` steps in one piece, then again from states around the rebuilds, and compares the last states.
fn assert_goes_on<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>>(
    build: impl Fn() -> Fluid<T, D, K, V, P>,
    steps: usize,
) {
    assert_goes_on_by(build, steps, |fluid, parallel| assert!(fluid.step(parallel).is_ok()));
}

/// The same with steps in which somebody else has a hand.
fn assert_goes_on_by<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>>(
    build: impl Fn() -> Fluid<T, D, K, V, P>,
    steps: usize,
    step: impl Fn(&mut Fluid<T, D, K, V, P>, &Parallel),
) {
    let serial = Parallel::serial();
    let mut fluid = build();
    let (mut states, mut rebuilds) = (vec![save(&mut fluid)], vec![0]);
    for _ in 0..steps {
        step(&mut fluid, &serial);
        states.push(save(&mut fluid));
        rebuilds.push(fluid.rebuilds());
    }
    // Before the first step, before, at and after a rebuild, and in the middle between two.
    let rebuilt: Vec<usize> = (2..steps).filter(|k| rebuilds[*k] > rebuilds[k - 1]).collect();
    assert!(rebuilt.len() >= 2, "{} rebuilds in {steps} steps", rebuilt.len());
    let (one, next) = (rebuilt[0], rebuilt[1]);
    let moments = [0, 1, one - 1, one, one + 1, (one + next) / 2, next - 1, steps - 1];
    for (k, moment) in moments.into_iter().enumerate() {
        let parallel = Parallel::new(1 + k % 3).unwrap();
        let mut twin = build();
        states[moment].restore(|transfer| twin.transfer(&parallel, transfer)).unwrap();
        assert!(save(&mut twin) == states[moment], "what was restored at step {moment}");
        for (count, state) in states.iter().enumerate().skip(moment + 1) {
            step(&mut twin, &parallel);
            assert!(save(&mut twin) == *state, "saved at step {moment}, differs at {count} of {steps}");
        }
    }
}

fn stirred<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>>(
    mut fluid: Fluid<T, D, K, V, P>,
    speed: f64,
) -> Fluid<T, D, K, V, P> {
    let mut noise = Noise::new(3);
    fluid.particles_mut().velocity.iter_mut().for_each(|u| *u = noise.vector(speed));
    fluid
}

fn splash<T: Real, const D: usize>(
    counts: [usize; D],
    change: impl Fn(&mut FluidConfig<T, D>),
) -> Fluid<T, D, Rational, ArtificialViscosity<T>> {
    let mut config = water::<T, D>(0.02, 0.02 * counts[D - 1] as f64);
    change(&mut config);
    let c = config.sound_speed;
    let mut fluid = stirred(tank(counts, config, |r| ArtificialViscosity::new::<D>(T::of(0.05), c, r)), 1.0);
    fluid.keep_books();
    fluid
}

#[test]
fn a_splash_with_walls_collisions_shifting_and_books() {
    assert_goes_on(
        || {
            splash::<f64, 2>([40, 30], |config| {
                config.shifting = Some(Shifting { strength: 2.0, iterations: 2 })
            })
        },
        40,
    );
}

#[test]
fn the_corrected_form_and_the_hydrostatic_diffusion() {
    assert_goes_on(
        || splash::<f64, 2>([20, 15], |config| config.pressure_form = PressureForm::Corrected),
        40,
    );
    assert_goes_on(|| splash::<f64, 2>([20, 15], |config| config.diffusion = Diffusion::Hydrostatic), 40);
}

#[test]
fn in_space_and_in_single_precision() {
    assert_goes_on(|| splash::<f32, 3>([7, 6, 6], |_| ()), 30);
}

#[test]
fn a_periodic_box_that_its_fluid_fills() {
    let build = || {
        let mut config = FluidConfig::<f64, 2>::water(0.02, 10.0);
        config.tension = Tension::Keep;
        config.density_relaxation = 0.01;
        config.background_pressure = 2000.0;
        let domain = PeriodicBox::new(Vector::zeros(), [Some(0.4), Some(0.4)]).unwrap();
        let particles = FluidParticles::at_rest(lattice([0.0; 2], [20, 20], 0.02));
        let nothing = Boundary::default();
        let fluid = Fluid::new(config, WendlandGradient, |_| (), domain, particles, nothing).unwrap();
        stirred(fluid, 1.0)
    };
    assert_goes_on(build, 40);
}

#[test]
fn walls_that_move() {
    let build = || {
        let config = FluidConfig::<f64, 2>::water(0.02, 10.0);
        let particles = FluidParticles::at_rest(lattice([0.0; 2], [15, 15], 0.02));
        let mut boundary = Boundary::default();
        boundary.add_wall(&closed_walls([15, 15], 0.02), Slip::None).unwrap();
        boundary.velocity.fill(Vector::from([1.0, 0.5]));
        let viscosity = |r: &_| LaminarViscosity::new::<2>(0.01, r);
        stirred(Fluid::new(config, Rational, viscosity, Open, particles, boundary).unwrap(), 0.5)
    };
    let moved = |fluid: &Fluid<f64, 2, _, _>| fluid.boundary().position[0];
    let start = moved(&build());
    assert_goes_on_by(build, 40, |fluid, parallel| {
        let dt = fluid.begin_step(parallel).unwrap();
        fluid.finish_step(parallel, dt);
        let Boundary { position, velocity, .. } = fluid.boundary_mut();
        position.iter_mut().zip(velocity).for_each(|(r, u)| *r += *u * dt);
        assert!(moved(fluid) != start, "the walls move");
    });
}

#[test]
fn fluid_enters_and_leaves() {
    assert_goes_on(
        || {
            let viscosity = |r: &_| LaminarViscosity::new::<2>(0.01, r);
            let mut fluid = channel(Slip::None, viscosity, |_, t| 2.0 + t, true);
            fluid.particles_mut().velocity.iter_mut().for_each(|u| u[0] = 2.0);
            fluid
        },
        60,
    );
}

/// What the tests above would not see if neighbour rows were searched anew: the bits depend on when that happens.
#[test]
fn particles_alone_are_no_state() {
    let serial = Parallel::serial();
    let mut fluid = splash::<f64, 2>([20, 15], |_| ());
    (0..3).for_each(|_| assert!(fluid.step(&serial).is_ok()));
    let mut twin = splash::<f64, 2>([20, 15], |_| ());
    *twin.particles_mut() = fluid.particles().clone();
    for _ in 0..20 {
        fluid.step(&serial).unwrap();
        twin.step(&serial).unwrap();
    }
    assert!(fluid.particles().position != twin.particles().position);
}

#[test]
fn a_state_of_another_fluid_is_refused_with_the_reason() {
    let serial = Parallel::serial();
    let state = save(&mut splash::<f64, 2>([20, 15], |_| ()));
    let into = |twin: &mut Fluid<f64, 2, Rational, ArtificialViscosity<f64>>| {
        state.restore(|transfer| twin.transfer(&serial, transfer)).unwrap_err()
    };
    let wider = into(&mut splash::<f64, 2>([21, 15], |_| ()));
    assert!(
        matches!(&wider, StateError::Length { section, .. } if section == "boundary/position"),
        "{wider}"
    );
    let c = 10.0;
    let closed = |r: &_| ArtificialViscosity::new::<2>(0.05, c, r);
    let unbooked = into(&mut tank([20, 15], water(0.02, 0.3), closed));
    assert!(unbooked.to_string().contains("has 1 for 'books' and here are 0"), "{unbooked}");
    let mut single = splash::<f32, 2>([20, 15], |_| ());
    let single = state.restore(|transfer| single.transfer(&serial, transfer)).unwrap_err();
    assert!(single.to_string().contains("use the precision"), "{single}");
    let left = State::from(state.sections()[..20].to_vec());
    let missing = left.restore(|transfer| splash::<f64, 2>([20, 15], |_| ()).transfer(&serial, transfer));
    assert!(matches!(missing, Err(StateError::Missing { .. })), "{missing:?}");
}

#[test]
fn a_step_that_has_begun_has_no_state() {
    let serial = Parallel::serial();
    let mut fluid = splash::<f64, 2>([20, 15], |_| ());
    let dt = fluid.begin_step(&serial).unwrap();
    let halfway = State::save(|transfer| fluid.transfer(&serial, transfer)).unwrap_err();
    assert!(halfway.to_string().contains("between two steps"), "{halfway}");
    fluid.finish_step(&serial, dt);
    save(&mut fluid);
}

#[test]
fn the_courant_number_and_what_limited_the_last_step_are_restored() {
    let serial = Parallel::serial();
    let build = || {
        let mut fluid = splash::<f64, 2>([20, 15], |config| config.cfl = 0.4);
        // So fast that its acceleration limits the step.
        fluid.particles_mut().density[40] = 1.5;
        fluid
    };
    let mut fluid = build();
    fluid.set_courant_number(0.1).unwrap();
    fluid.step(&serial).unwrap();
    assert_eq!(fluid.limit(), Limit::Acceleration);
    let state = save(&mut fluid);
    let mut twin = build();
    state.restore(|transfer| twin.transfer(&serial, transfer)).unwrap();
    assert_eq!((twin.limit(), twin.config().cfl), (Limit::Acceleration, 0.1));
    for _ in 0..3 {
        assert_eq!(fluid.step(&serial).unwrap(), twin.step(&serial).unwrap());
    }
    assert!(fluid.particles() == twin.particles());
}
