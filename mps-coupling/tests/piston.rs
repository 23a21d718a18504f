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

/// A column of water, endless sideways, between a floor and a piston of the given mass and spring.
fn column(mass: f64, stiffness: f64, speed: f64) -> Column {
    let parallel = Parallel::serial();
    let mut config = FluidConfig::water(L0, C);
    config.tension = Tension::Keep;
    let particles = FluidParticles::at_rest(lattice([0.0; 2], [COLUMNS, ROWS], L0));
    let mut boundary = Boundary::default();
    boundary.add_wall(&lattice([0.0, -3.0 * L0], [COLUMNS, 3], L0), Slip::Free).unwrap();
    let domain = PeriodicBox::new(Vector::zeros(), [Some(WIDTH), None]).unwrap();
    let fluid = Fluid::new(config, Rational, |_| (), domain, particles, boundary).unwrap();
    let mut scene = Scene::new(fluid);
    let mut piston = Piston::new(lattice([0.0, HEIGHT], [COLUMNS, 4], L0), L0, mass, stiffness);
    piston.v = speed;
    piston.max_step = 2e-4;
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
        let mut scene = column(mass, stiffness, 1e-3);
        let (found, truth) = (measured(&mut scene), expected(mass, stiffness));
        assert!((found / truth - 1.0).abs() < 0.01, "{found} rad/s instead of {truth} rad/s");
    }
}

#[test]
fn a_piston_neither_gains_energy_nor_loses_much_of_it_in_a_period() {
    let parallel = Parallel::serial();
    let mut scene = column(20.0, 0.0, 1e-3);
    let total = |scene: &Column| {
        let (fluid, piston) = scene.energy(&parallel);
        fluid.total() + piston.total()
    };
    let start = total(&scene);
    let mut largest = start;
    while scene.fluid().time() < 0.3 {
        scene.step(&parallel, f64::INFINITY).unwrap();
        largest = largest.max(total(&scene));
    }
    assert!(largest < 1.002 * start, "{}", largest / start);
    assert!(total(&scene) > 0.95 * start, "{}", total(&scene) / start);
}
