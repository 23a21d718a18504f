//! The energy of the fluid changes by what the books say.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{Noise, lattice, water};
use mps_fluid::{
    ArtificialViscosity, Boundary, CompactViscosity, Dpc, EnergyBudget, Fluid, FluidConfig, FluidParticles,
    Shifting, Slip, Tension, Viscosity,
};
use mps_kernel::weights::WendlandGradient;
use mps_kernel::{Kernel, Vector};
use mps_neighbors::{Domain, Open, Parallel, PeriodicBox};

const L0: f64 = 0.01;

/// Change of the energy and what the books say of it, over a span of time.
fn run<const D: usize, K: Kernel<f64>, V: Viscosity<f64, D>, P: Domain<f64, D>>(
    fluid: &mut Fluid<f64, D, K, V, P>,
    span: f64,
    step: impl Fn(&mut Fluid<f64, D, K, V, P>, &Parallel),
) -> (f64, EnergyBudget<f64>) {
    let parallel = Parallel::serial();
    fluid.keep_books();
    let (start, end) = (fluid.energy(&parallel).total(), fluid.time() + span);
    while fluid.time() < end {
        step(fluid, &parallel);
    }
    (fluid.energy(&parallel).total() - start, fluid.budget().unwrap())
}

fn plain_step<const D: usize, K: Kernel<f64>, V: Viscosity<f64, D>, P: Domain<f64, D>>(
    fluid: &mut Fluid<f64, D, K, V, P>,
    parallel: &Parallel,
) {
    fluid.step(parallel).unwrap();
}

/// A column that falls over in a basin, disturbed and with everything that dissipates.
fn splash(cfl: f64) -> (f64, EnergyBudget<f64>) {
    let mut config = water::<f64, 2>(L0, 0.2);
    (config.cfl, config.radius_ratio) = (cfl, 4.0);
    config.collisions = Some(Dpc::default());
    config.shifting = Some(Shifting::default());
    let mut noise = Noise::new(3);
    let mut particles = FluidParticles::at_rest(lattice([0.0; 2], [10, 20], L0));
    for u in &mut particles.velocity {
        *u = noise.vector(0.2);
    }
    let mut basin = Boundary::default();
    let inside = |r: &Vector<f64, 2>| r.x > 0.0 && r.x < 0.2 && r.y > 0.0;
    let mut points = lattice([-0.04, -0.04], [56, 70], 0.5 * L0);
    points.retain(|r| !inside(r));
    basin.add_fine_wall(&points, 0.25, Slip::None).unwrap();
    let c = config.sound_speed;
    let viscosity = |r: &_| ArtificialViscosity::new::<2>(0.1, c, r);
    let mut fluid = Fluid::new(config, WendlandGradient, viscosity, Open, particles, basin).unwrap();
    run(&mut fluid, 0.3, plain_step)
}

#[test]
fn a_splash_loses_what_the_books_say() {
    let (change, budget) = splash(0.25);
    assert!(budget.viscosity < 0.0 && budget.collisions < 0.0, "{budget:?}");
    for part in [budget.viscosity, budget.collisions] {
        assert!(part < 0.02 * change && change < 0.0, "none of them is negligible: {change} J, {budget:?}");
    }
    let open = (change - budget.total()).abs() / change.abs();
    assert!(open < 0.01, "{open} of {change} J is unexplained: {budget:?}");
}

#[test]
fn what_is_left_over_belongs_to_the_time_steps() {
    let open = [0.5, 0.125].map(|cfl| {
        let (change, budget) = splash(cfl);
        (change - budget.total()).abs()
    });
    // 0.055 and 0.035 J of 7; 0.016 J with half the step once more.
    assert!(open[1] < 0.75 * open[0], "{open:?} J");
}

#[test]
fn the_work_of_a_piston_arrives_in_the_water() {
    let mut config = FluidConfig::<f64, 2>::water(L0, 20.0);
    (config.radius_ratio, config.collisions, config.tension) = (4.0, None, Tension::Keep);
    config.cfl = 0.1;
    let particles = FluidParticles::at_rest(lattice([0.0; 2], [10, 10], L0));
    // Three walls, and the piston on the left.
    let mut walls = Boundary::default();
    let mut points = lattice([-0.1, -0.04], [48, 36], 0.5 * L0);
    points.retain(|r| !(r.y > 0.0 && r.y < 0.1 && r.x < 0.1));
    walls.add_fine_wall(&points, 0.25, Slip::Free).unwrap();
    let piston = walls.add_fine_wall(&lattice([-0.05, 0.0], [10, 20], 0.5 * L0), 0.25, Slip::Free).unwrap();
    let mut fluid = Fluid::new(config, WendlandGradient, |_: &_| (), Open, particles, walls).unwrap();
    let (amplitude, omega) = (2e-4, 60.0);
    let (change, budget) = run(&mut fluid, 0.05, |fluid, parallel| {
        let place = |t: f64| 0.5 * amplitude * (1.0 - (omega * t).cos());
        let dt = fluid.begin_step(parallel).unwrap();
        let by = Vector::from([place(fluid.time() + dt) - place(fluid.time()), 0.0]);
        fluid.boundary_mut().velocity[piston.clone()].fill(by / dt);
        fluid.finish_step(parallel, dt);
        fluid.boundary_mut().position[piston.clone()].iter_mut().for_each(|r| *r += by);
    });
    assert!(budget.boundary > 0.0, "{budget:?}");
    let open = (change - budget.total()).abs() / budget.boundary;
    assert!(open < 0.01, "{open} of {change} J is unexplained: {budget:?}");
}

#[test]
fn a_field_from_outside_is_booked() {
    let mut config = FluidConfig::<f64, 2>::water(L0, 10.0);
    config.collisions = None;
    let particles = FluidParticles::at_rest(lattice([-0.05; 2], [10, 10], L0));
    let mut fluid =
        Fluid::new(config, WendlandGradient, |_: &_| (), Open, particles, Boundary::default()).unwrap();
    // Towards the middle, from rest: the water is squeezed.
    let (change, budget) = run(&mut fluid, 0.02, |fluid, parallel| {
        let dt = fluid.begin_step(parallel).unwrap();
        fluid.add_acceleration(parallel, |r| r * -400.0);
        fluid.finish_step(parallel, dt);
    });
    assert!(budget.field > 0.0);
    assert!((change - budget.total()).abs() < 0.02 * budget.field, "{change} J, {budget:?}");
}

#[test]
fn books_change_nothing_and_are_closed_by_default() {
    let build = || crate::common::tank([8, 8], water::<f64, 2>(L0, 0.08), |_| ());
    let (mut open, mut closed) = (build(), build());
    open.keep_books();
    for _ in 0..20 {
        open.step(&Parallel::serial()).unwrap();
        closed.step(&Parallel::serial()).unwrap();
    }
    assert_eq!(open.particles(), closed.particles());
    assert!(closed.budget().is_none());
}

/// A channel between `walls` that goes round along the first axis.
fn channel(
    config: FluidConfig<f64, 2>,
    walls: Boundary<f64, 2>,
    nu: f64,
) -> Fluid<f64, 2, WendlandGradient, CompactViscosity<f64>, PeriodicBox<f64, 2>> {
    let particles = FluidParticles::at_rest(lattice([0.0; 2], [12, 10], L0));
    let domain = PeriodicBox::new(Vector::zeros(), [Some(12.0 * L0), None]).unwrap();
    let viscosity = |r: &_| CompactViscosity::new::<2>(nu, r);
    Fluid::new(config, WendlandGradient, viscosity, domain, particles, walls).unwrap()
}

/// Gravity along the channel drives it round and round: what it has given is more than the kinetic energy, and not a potential.
#[test]
fn gravity_along_a_periodic_axis_is_the_work_of_a_field() {
    let mut config = FluidConfig::<f64, 2>::water(L0, 20.0);
    config.gravity.x = 10.0;
    config.shifting = Some(Shifting::default());
    let mut walls = Boundary::default();
    for y in [-3.0, 10.0] {
        walls.add_wall(&lattice([0.0, y * L0], [12, 3], L0), Slip::None).unwrap();
    }
    let mut fluid = channel(config, walls, 2e-3);
    let start: f64 = fluid.particles().position.iter().map(|r| r.x).sum();
    let (change, budget) = run(&mut fluid, 0.4, plain_step);
    // Some went round once, some twice: a potential would have jumped.
    let speed = fluid.particles().velocity.iter().map(|u| u.x).sum::<f64>() / 120.0;
    assert!(speed > 0.4 && start > 0.0, "{speed} m/s");
    assert!(budget.viscosity < -0.2 * budget.field, "{budget:?}");
    let open = (change - budget.total()).abs() / budget.field;
    assert!(open < 0.01, "{open} of {} J is unexplained: {change} J, {budget:?}", budget.field);
}

/// A plate begins to slide: what it gives is its force times its speed, what viscosity does is a loss.
#[test]
fn a_plate_that_slides_gives_its_force_times_its_speed() {
    let config = FluidConfig { collisions: None, ..FluidConfig::<f64, 2>::water(L0, 10.0) };
    let mut walls = Boundary::default();
    walls.add_wall(&lattice([0.0, -3.0 * L0], [12, 3], L0), Slip::None).unwrap();
    let points = lattice([0.0, 10.0 * L0], [12, 3], L0);
    let plate = walls.add_structure(&points, core::iter::repeat(1.0), Slip::None);
    let speed = 0.2;
    walls.velocity[plate.clone()].fill(Vector::from([speed, 0.0]));
    let mut fluid = channel(config, walls, 1e-3);
    let given = core::cell::Cell::new(0.0);
    let (change, budget) = run(&mut fluid, 0.05, |fluid, parallel| {
        let dt = fluid.begin_step(parallel).unwrap();
        let force: f64 = fluid.boundary().force[plate.clone()].iter().map(|f| f.x).sum();
        given.set(given.get() - force * speed * dt);
        fluid.finish_step(parallel, dt);
    });
    let given = given.get();
    assert!(budget.viscosity < 0.0 && budget.boundary > 0.0, "{budget:?}");
    assert!((budget.boundary / given - 1.0).abs() < 1e-3, "{given} J, {budget:?}");
    assert!(change > 0.0 && (change - budget.total()).abs() < 0.01 * given, "{change} J, {budget:?}");
}
