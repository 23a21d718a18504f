//! A structure of another make: a rigid piston on a spring, on a column of water.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{Piston, lattice};
use core::f64::consts::PI;
use mps_coupling::Scene;
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidParticles, Slip, Tension};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Parallel, PeriodicBox};

const L0: f64 = 0.01;
const C: f64 = 10.0;
const COLUMNS: usize = 10;
const ROWS: usize = 20;
const WIDTH: f64 = COLUMNS as f64 * L0;
const HEIGHT: f64 = ROWS as f64 * L0;

type Column = Scene<f64, 2, Rational, (), PeriodicBox<f64, 2>>;

/// A column of water, endless sideways, between a floor and a piston of the given mass and spring that
/// moves in sub-steps of at most `sub_step`, with the Courant number of the water.
fn column(mass: f64, stiffness: f64, speed: f64, (cfl, sub_step): (f64, f64)) -> Column {
    let parallel = Parallel::serial();
    let mut config = FluidConfig::water(L0, C);
    config.tension = Tension::Keep;
    config.cfl = cfl;
    let particles = FluidParticles::at_rest(lattice([0.0; 2], [COLUMNS, ROWS], L0));
    let mut boundary = Boundary::default();
    boundary.add_wall(&lattice([0.0, -3.0 * L0], [COLUMNS, 3], L0), Slip::Free).unwrap();
    let domain = PeriodicBox::new(Vector::zeros(), [Some(WIDTH), None]).unwrap();
    let fluid = Fluid::new(config, Rational, |_| (), domain, particles, boundary).unwrap();
    let mut scene = Scene::new(fluid);
    let mut piston = Piston::new(lattice([0.0, HEIGHT], [COLUMNS, 4], L0), L0, mass, stiffness);
    piston.v = speed;
    piston.max_step = sub_step;
    scene.add_structure(&parallel, Box::new(piston), Slip::Free).unwrap();
    scene
}

fn piston(scene: &Column) -> &Piston {
    scene.structure(0).unwrap().as_any().downcast_ref::<Piston>().unwrap()
}

/// Slowest angular frequency of the piston: `m w^2 = k + rho c w cot(w H/c)` per unit of width.
fn expected(mass: f64, stiffness: f64) -> f64 {
    let defect = |w: f64| mass * w * w - stiffness - WIDTH * 1000.0 * C * w / (w * HEIGHT / C).tan();
    let (mut low, mut high) = (1e-6, PI * C / HEIGHT * (1.0 - 1e-9));
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if defect(middle) < 0.0 { low = middle } else { high = middle }
    }
    low
}

/// Angular frequency from the crossings of zero, two whole periods.
fn measured(scene: &mut Column) -> f64 {
    let parallel = Parallel::serial();
    let (mut crossings, mut last) = (Vec::new(), 0.0);
    while crossings.len() < 4 {
        scene.step(&parallel, f64::INFINITY).unwrap();
        let (time, y) = (scene.fluid().time(), piston(scene).y);
        if last * y < 0.0 {
            crossings.push(time);
        }
        last = y;
        assert!(time < 5.0, "the piston swings");
    }
    // Four crossings, three half periods apart.
    3.0 * PI / (crossings[3] - crossings[0])
}

#[test]
fn a_piston_swings_on_the_water_with_the_frequency_of_its_mass_spring_and_the_sound() {
    let water = 1000.0 * WIDTH * HEIGHT;
    let column_stiffness = 1000.0 * C * C * WIDTH / HEIGHT;
    for (mass, stiffness) in [(water, 0.0), (water, 2.0 * column_stiffness), (4.0 * water, 0.0)] {
        let mut scene = column(mass, stiffness, 1e-3, (0.5, 2e-4));
        let (found, truth) = (measured(&mut scene), expected(mass, stiffness));
        assert!((found / truth - 1.0).abs() < 0.01, "{found} rad/s instead of {truth} rad/s");
    }
}

/// Largest total energy over that of the start, in 0.3 s after the piston was pushed.
fn largest_energy(cfl: f64, sub_step: f64) -> f64 {
    let parallel = Parallel::serial();
    let mut scene = column(20.0, 0.0, 1e-3, (cfl, sub_step));
    let total = |scene: &Column| {
        let (fluid, piston) = scene.energy(&parallel);
        fluid.total() + piston.total()
    };
    let start = total(&scene);
    let mut largest = 0.0_f64;
    while scene.fluid().time() < 0.3 {
        scene.step(&parallel, f64::INFINITY).unwrap();
        largest = largest.max(total(&scene) / start);
    }
    // What density diffusion takes of a wave twenty particles long in two periods is a few percent a period.
    assert!(total(&scene) > 0.85 * start, "{} is left", total(&scene) / start);
    largest
}

/// The energy read at the ends of the steps of a symplectic scheme swings by the share `w dt/2`, and sub-steps
/// add a gain of the same order, because the velocity of the water is held meanwhile. Without viscosity both
/// can be seen here; both have to go with the step.
#[test]
fn what_a_piston_gains_in_energy_goes_with_the_step() {
    for substeps in [1.0, 4.0] {
        let gain = [0.5, 0.25, 0.125].map(|cfl| {
            let dt = cfl * L0 / C;
            largest_energy(cfl, dt / (substeps - 0.5)) - 1.0
        });
        assert!(gain[0] < 0.02, "{substeps} sub-steps: {gain:?}");
        assert!(gain.windows(2).all(|w| w[1] < 0.7 * w[0]), "{substeps} sub-steps: {gain:?}");
    }
}
