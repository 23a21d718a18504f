//! Momentum and angular momentum are booked on both sides of the interface, and by the structures themselves; all agree.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{Wet, floating_in, gate, solid_of};
use mps_coupling::{Closure, Momenta};
use mps_fluid::{Push, Slip};
use mps_kernel::Vector;
use mps_neighbors::{Parallel, state_hash};

/// A block in a blob that turns about it and passes it, with its books about a point beside both.
fn turning<const D: usize>(across: usize, wide: usize) -> (Wet<D>, Vector<f64, D>) {
    let mut scene = floating_in::<D>(0.0, across, wide);
    let middle = Vector::repeat(0.005 * across as f64);
    let particles = scene.fluid_mut().particles_mut();
    particles.density.fill(1.005);
    for (u, r) in particles.velocity.iter_mut().zip(&particles.position) {
        let r = r - middle;
        *u = Vector::from_fn(|axis, _| match axis {
            0 => 0.2 - 3.0 * r[1],
            1 => 3.0 * r[0],
            _ => 0.1,
        });
    }
    let center = Vector::from_fn(|axis, _| 0.3 - 0.1 * axis as f64);
    scene.keep_books(center);
    (scene, center)
}

fn of_fluid<const D: usize>(scene: &Wet<D>, center: &Vector<f64, D>) -> Momenta<f64, D> {
    let (water, mass) = (scene.fluid().particles(), scene.fluid().config().particle_mass());
    let parts = water.position.iter().zip(&water.velocity);
    parts.fold(Push::default(), |sum, (r, u)| sum + Push::at(&(r - center), &(*u * mass)))
}

fn of_block<const D: usize>(scene: &Wet<D>, center: &Vector<f64, D>) -> Momenta<f64, D> {
    scene.structure(0).unwrap().momenta(&Parallel::serial(), center).unwrap()
}

/// Largest differences in momentum and angular momentum.
fn apart<const D: usize>(a: Momenta<f64, D>, b: Momenta<f64, D>, size: [f64; 2]) -> [f64; 2] {
    [(a.force - b.force).norm() / size[0], (a.moment - b.moment).norm() / size[1]]
}

fn all_books_agree<const D: usize>(across: usize, wide: usize) {
    let (mut scene, center) = turning::<D>(across, wide);
    scene.min_substeps = 3;
    let start = [of_fluid(&scene, &center), of_block(&scene, &center)];
    for _ in 0..40 {
        scene.step(&Parallel::serial(), f64::INFINITY).unwrap();
    }
    let budget = scene.budget();
    let Closure { momentum, angular, off_line } = budget.closure().unwrap();
    assert!(momentum < 1e-12 && angular < 1e-12, "{D}D, between the sides: {momentum:e}, {angular:e}");
    // What is off the lines of the pairs is small, but far above round-off.
    assert!((1e-9..1e-3).contains(&off_line), "{D}D: {off_line:e}");
    let handed = &budget.handed[0];
    assert!(
        handed.push.force.norm() > 0.1 * handed.size[0] && handed.push.moment.norm() > 0.1 * handed.size[1]
    );
    let gained = |now: Momenta<f64, D>, then: Momenta<f64, D>| now + then * -1.0;
    let by_block = gained(of_block(&scene, &center), start[1]);
    let defect = apart(by_block, handed.push, handed.size);
    assert!(defect.iter().all(|d| *d < 1e-12), "{D}D, the block's own books: {defect:?}");
    // The blob moves much more than it hands over; its viscosity is central.
    let by_blob = gained(of_fluid(&scene, &center), start[0]);
    let defect = apart(by_blob, budget.fluid.unwrap(), handed.size);
    assert!(defect.iter().all(|d| *d < 1e-9), "{D}D, the fluid's own books: {defect:?}");
}

#[test]
fn structure_fluid_and_coupling_book_the_same_momenta() {
    all_books_agree::<2>(24, 8);
    all_books_agree::<3>(14, 6);
}

/// The pairs of a step act along the lines of its start, and the points move off them by less than the way of a step.
#[test]
fn the_angular_momentum_off_the_lines_is_of_first_order_in_the_step_and_gone_with_one_sub_step() {
    let off_line = |cfl: f64, substeps: usize| {
        let (mut scene, _) = turning::<2>(24, 8);
        scene.min_substeps = substeps;
        while scene.fluid().time() < 0.02 - 1e-9 {
            let longest = (cfl * 1e-3).min(0.02 - scene.fluid().time());
            scene.step(&Parallel::serial(), longest).unwrap();
        }
        assert_eq!(scene.substeps(), substeps);
        scene.budget().closure().unwrap().off_line
    };
    let found = [0.4, 0.2, 0.1].map(|cfl| off_line(cfl, 8));
    assert!(found.windows(2).all(|w| (0.4..0.6).contains(&(w[1] / w[0]))), "{found:?}");
    // A force that acts at the start of the step acts on the lines; what comes later is off by (1 - 1/m) of the way.
    let alone = off_line(0.1, 1);
    assert!(alone < 1e-15, "{alone:e}");
    let two = off_line(0.1, 2);
    assert!((two / found[2] / ((1.0 - 1.0 / 2.0) / (1.0 - 1.0 / 8.0)) - 1.0).abs() < 0.1, "{two:e}");
}

#[test]
fn at_a_gate_momentum_closes_with_shear_as_well_and_keeping_books_changes_nothing() {
    let parallel = Parallel::serial();
    let run = |slip: Slip, books: bool| {
        let mut scene = gate([20, 40], slip);
        if books {
            scene.keep_books(Vector::from([0.0, 0.05]));
        }
        for _ in 0..30 {
            scene.step(&parallel, f64::INFINITY).unwrap();
        }
        scene
    };
    for slip in [Slip::Free, Slip::None] {
        let (mut with, mut without) = (run(slip, true), run(slip, false));
        let closure = with.budget().closure().unwrap();
        assert!(closure.momentum < 1e-12, "{slip:?}: {:e}", closure.momentum);
        // The viscosity of this water acts along the lines of the pairs.
        assert!(closure.angular < 1e-12, "{slip:?}: {:e}", closure.angular);
        let moment = with.budget().handed[0].push.moment[(0, 1)];
        // The water pushes below the hinge line at half the height: towards +x at a smaller y.
        assert!(moment > 0.0, "{moment}");
        assert!(without.budget().closure().is_none());
        let hash = |scene: &mut Wet| state_hash(scene.fluid_mut().particles_mut());
        assert_eq!(hash(&mut with), hash(&mut without));
        assert_eq!(with.budget().handed[0].push.force, without.budget().handed[0].push.force);
        assert_eq!(solid_of(&with).positions(), solid_of(&without).positions());
    }
}
