//! A coupled scene that was saved and restored into a twin goes on with the bits of one that was not: between any two steps, for any number
//! of threads.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::column::column;
use common::{Noise, Rubber, Wet, block, floating, floating_in, gate, lattice};
use mps_coupling::{Fixed, Scene};
use mps_fluid::{Slip, Viscosity};
use mps_kernel::{Kernel, State, Vector};
use mps_neighbors::{Domain, Parallel};
use mps_solid::Placement;
use mps_solid::body::{self, Face};

fn save<const D: usize, K: Kernel<f64>, V: Viscosity<f64, D>, P: Domain<f64, D>>(
    scene: &mut Scene<f64, D, K, V, P>,
) -> State {
    State::save(|transfer| scene.transfer(&Parallel::serial(), transfer)).unwrap()
}

/// As for the fluid alone: every moment from the first step to the second rebuild of the rows.
fn assert_goes_on<const D: usize>(build: impl Fn() -> Wet<D>, steps: usize) {
    let serial = Parallel::serial();
    let mut scene = build();
    let (mut states, mut rebuilds, mut most) = (vec![save(&mut scene)], vec![0], 0);
    for _ in 0..steps {
        scene.step(&serial, f64::INFINITY).unwrap();
        most = most.max(scene.substeps());
        states.push(save(&mut scene));
        rebuilds.push(scene.fluid().rebuilds());
    }
    assert!(most > 1, "structures take sub-steps");
    let rebuilt: Vec<usize> = (2..steps).filter(|k| rebuilds[*k] > rebuilds[k - 1]).collect();
    let (one, next) = (rebuilt[0], rebuilt[1]);
    for moment in (0..=next + 1).step_by(3).chain([one - 1, one, one + 1, next - 1]) {
        let parallel = Parallel::new(1 + moment % 3).unwrap();
        let mut twin = build();
        states[moment].restore(|transfer| twin.transfer(&parallel, transfer)).unwrap();
        assert!(save(&mut twin) == states[moment], "what was restored at step {moment}");
        for (step, state) in states.iter().enumerate().skip(moment + 1) {
            twin.step(&parallel, f64::INFINITY).unwrap();
            assert!(save(&mut twin) == *state, "saved at step {moment}, differs at {step}");
        }
    }
}

fn stirred(mut scene: Wet) -> Wet {
    let mut noise = Noise::new(11);
    scene.fluid_mut().particles_mut().velocity.iter_mut().for_each(|u| *u = noise.vector(0.5));
    scene
}

#[test]
fn a_gate_without_slip_goes_on() {
    assert_goes_on(|| stirred(gate([40, 30], Slip::None)), 30);
}

#[test]
fn a_floating_block_goes_on() {
    assert_goes_on(|| floating(0.5), 30);
}

/// A second structure, which only feels.
#[test]
fn two_structures_go_on() {
    let build = || {
        let mut scene = stirred(gate([24, 20], Slip::Free));
        let l0 = 2.5e-3;
        let points = lattice([10.0 * l0, 0.0], [4, 4], l0);
        let volumes = vec![l0 * l0; points.len()];
        let post = Box::new(Fixed::new(points, volumes, l0));
        scene.add_structure(&Parallel::serial(), post, Slip::Free).unwrap();
        scene
    };
    assert_goes_on(build, 25);
}

/// A block in a blob in space, and beside it a post on a support that swings; the books of both sides are kept.
fn swinging() -> Wet<3> {
    let (l0, across) = (0.01, 10);
    let mut scene = floating_in::<3>(0.4, across, 4);
    let side = across as f64 * l0;
    let (lower, upper) = ([side, 3.0 * l0, 3.0 * l0], [side + 4.0 * l0, 7.0 * l0, 7.0 * l0]);
    let clamp = [Face::upper(0)];
    let counts = body::counts(&lower.into(), &upper.into(), l0, &clamp);
    let mut post = block(lower, upper, counts, &clamp, 1e6);
    let swing = |time: f64| Placement::shifted(Vector::from([0.0, 2e-3 * (1.0 - (200.0 * time).cos()), 0.0]));
    post.move_supports(|_| true, swing).unwrap();
    scene.add_structure(&Parallel::serial(), Box::new(Rubber::new(post)), Slip::None).unwrap();
    scene.keep_books(Vector::from([0.02, -0.03, 0.05]));
    scene
}

#[test]
fn in_space_two_bodies_a_moved_support_and_the_books_go_on() {
    let mut scene = swinging();
    for _ in 0..30 {
        scene.step(&Parallel::serial(), f64::INFINITY).unwrap();
    }
    // There is something to be saved of all of them.
    let (then, now) = (swinging(), scene.structure(1).unwrap().positions());
    let then = then.structure(1).unwrap().positions();
    assert!(now.iter().zip(then).any(|(now, then)| (now - then).norm() > 1e-3), "the support has moved");
    assert!(scene.budget().closure().is_some_and(|closure| closure.off_line > 0.0));
    assert!(scene.budget().handed.iter().all(|handed| handed.size[0] > 0.0), "both are pushed");
    assert_goes_on(swinging, 30);
}

#[test]
fn a_structure_that_has_no_state_is_named() {
    let mut scene = column(1.0, 0.0, 0.1, (0.5, f64::INFINITY));
    let refused = State::save(|transfer| scene.transfer(&Parallel::serial(), transfer)).unwrap_err();
    let words = refused.to_string();
    assert!(
        words.starts_with("structure 0/body: ") && words.contains("implement `Structure::transfer`"),
        "{words}"
    );
}

#[test]
fn a_step_that_failed_leaves_no_state() {
    let serial = Parallel::serial();
    let mut scene = gate([24, 20], Slip::Free);
    scene.max_substeps = 1;
    scene.step(&serial, f64::INFINITY).unwrap_err();
    let refused = State::save(|transfer| scene.transfer(&serial, transfer)).unwrap_err();
    assert!(refused.to_string().contains("save the state between two steps"), "{refused}");
}
