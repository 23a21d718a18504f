//! A structure of another make: a rigid piston on a spring, on a column of water.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::column::{C, Column, HEIGHT, L0, STIFFNESS, WATER, WIDTH, column, column_under, piston, total};
use core::f64::consts::PI;
use mps_coupling::Fixed;
use mps_fluid::Slip;
use mps_kernel::Vector;
use mps_neighbors::Parallel;

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
    for (mass, stiffness) in [(WATER, 0.0), (WATER, 2.0 * STIFFNESS), (4.0 * WATER, 0.0)] {
        let mut scene = column(mass, stiffness, 1e-3, (0.5, 2e-4));
        let (found, truth) = (measured(&mut scene), expected(mass, stiffness));
        assert!((found / truth - 1.0).abs() < 0.01, "{found} rad/s instead of {truth} rad/s");
    }
}

/// Largest total energy over that of the start, in 0.3 s after the piston was pushed.
fn largest_energy(cfl: f64, sub_step: f64) -> f64 {
    let parallel = Parallel::serial();
    let mut scene = column(20.0, 0.0, 1e-3, (cfl, sub_step));
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

/// Mass of a piston, four particles thick, of a density relative to the water's.
fn of_density(density: f64) -> f64 {
    density * 1000.0 * 4.0 * L0 * WIDTH
}

/// A piston without a spring for 0.05 s, a hundred steps of the water: largest energy over that of the start, infinite where
/// the run ends, and the most sub-steps in a step.
fn pushed(mass: f64, cfl: f64, least: usize, open: bool) -> (f64, usize) {
    let mut scene = column_under(mass, 0.0, 1e-3, (cfl, f64::INFINITY), open);
    scene.min_substeps = least;
    let start = total(&scene);
    let (mut largest, mut most) = (0.0_f64, 0);
    while scene.fluid().time() < 0.05 {
        match scene.step(&Parallel::serial(), f64::INFINITY) {
            Ok(_) => largest = largest.max(total(&scene) / start),
            Err(_) => return (f64::INFINITY, most),
        }
        most = most.max(scene.substeps());
    }
    (largest, most)
}

/// The fluid at the interface is a spring that the structure does not know of: a body lighter than a twentieth of a layer of
/// particles bursts when it takes one sub-step a step, and is calm with four (`docs/coupling.md`, examples/stability_map).
#[test]
fn a_piston_much_lighter_than_a_layer_of_water_needs_more_sub_steps_than_its_spring_asks_for() {
    // A hundredth of the water's density, four particles thick, is 0.04 layers of water.
    let largest = |density: f64, least: usize| pushed(of_density(density), 0.5, least, false).0;
    assert!(largest(0.01, 1) > 100.0, "the border has moved: {}", largest(0.01, 1));
    // The energy at the ends of symplectic steps swings by some tenths.
    assert!(largest(0.01, 4) < 1.5, "{}", largest(0.01, 4));
    assert!(largest(0.2, 1) < 1.5, "{}", largest(0.2, 1));
}

#[test]
fn a_piston_that_tells_its_mass_gets_the_sub_steps_it_needs() {
    for (cfl, density) in [(0.5, 0.01), (0.5, 0.015), (0.5, 0.03), (0.25, 0.003)] {
        let (largest, substeps) = pushed(of_density(density), cfl, 1, true);
        // At 0.6 of the border the energy at the ends of the steps swings by up to 1/(1 - 0.6).
        assert!(largest < 2.5 && substeps > 1, "{density}: {largest} with {substeps} sub-steps");
    }
    assert_eq!(pushed(of_density(1.0), 0.5, 1, true).1, 1, "and a heavy one no more than before");
}

/// The water between two bodies is the spring of each of them for itself.
#[test]
fn a_neighbour_does_not_change_the_border_of_a_body() {
    let border = |crowded: bool| {
        let mut scene = column_under(of_density(0.1), 0.0, 1e-3, (0.5, f64::INFINITY), true);
        if crowded {
            // A plate in the water, within reach of the same particles as the piston.
            let plate: Vec<_> =
                (0..10).map(|k| Vector::from([(f64::from(k) + 0.5) * L0, HEIGHT - 2.0 * L0])).collect();
            let volumes = vec![L0 * L0; plate.len()];
            scene
                .add_structure(&Parallel::serial(), Box::new(Fixed::new(plate, volumes, L0)), Slip::Free)
                .unwrap();
        }
        let _ = scene.step(&Parallel::serial(), 1e-5).unwrap();
        scene.interface_border(0).unwrap()
    };
    let [alone, crowded] = [false, true].map(border);
    assert!((crowded / alone - 1.0).abs() < 1e-12, "{crowded} for {alone}");
}

/// Lighter still, a body turns by more than half a turn on the spring of the fluid in a step, and no number of sub-steps helps; the step
/// of the water has to be shorter.
#[test]
fn a_piston_far_too_light_grows_whatever_its_sub_steps() {
    let turns = |cfl: f64| {
        let mut scene = column_under(of_density(0.003), 0.0, 1e-3, (cfl, f64::INFINITY), true);
        let _ = scene.step(&Parallel::serial(), 1e-5).unwrap();
        2.0 * cfl * L0 / C / scene.interface_border(0).unwrap() / PI
    };
    assert!(turns(0.5) > 1.0 && turns(0.25) < 1.0, "half turns: {} and {}", turns(0.5), turns(0.25));
    let [long, short] = [0.5, 0.25].map(|cfl| pushed(of_density(0.003), cfl, 32, false).0);
    assert!(long > 100.0 && short < 1.5, "{long} and {short}");
}

/// The border in the mass, between what bursts and what does not, where the sub-step has a given number in a step: measured against
/// `2/sqrt(lambda)`.
#[test]
fn the_border_of_stability_is_where_the_spring_of_the_fluid_says() {
    // The last number is the share of the table in `docs/coupling.md`.
    for (cfl, substeps, found) in [(0.5, 1, 0.98), (0.25, 1, 0.99), (0.25, 2, 0.83)] {
        let (mut bursts, mut calm) = (of_density(1e-4), of_density(1.0));
        while calm / bursts > 1.02 {
            let middle = (calm * bursts).sqrt();
            if pushed(middle, cfl, substeps, false).0 < 1e4 { calm = middle } else { bursts = middle }
        }
        let mut scene = column_under(calm, 0.0, 1e-3, (cfl, f64::INFINITY), true);
        let _ = scene.step(&Parallel::serial(), 1e-5).unwrap();
        let share = cfl * L0 / C / substeps as f64 / scene.interface_border(0).unwrap();
        assert!((0.8..1.05).contains(&share), "Courant number {cfl}, {substeps} sub-steps: {share}");
        assert!((share - found).abs() < 0.02, "Courant number {cfl}, {substeps} sub-steps: {share}");
    }
}
