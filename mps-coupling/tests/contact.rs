//! What nothing keeps apart is not left to pass through each other: an error names both and the place. What touches from the start, or
//! glides along, goes on.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::{Driven, Piston, lattice};
use mps_coupling::{CouplingError, Fixed, Scene};
use mps_fluid::{ArtificialViscosity, Boundary, Fluid, FluidConfig, FluidParticles, Slip};
use mps_kernel::weights::{Rational, WendlandGradient};
use mps_kernel::{Kernel, Vector};
use mps_neighbors::{Open, Parallel};

const L0: f64 = 0.01;

/// A bit of water far away from these walls, and nothing else.
fn pool<const D: usize>(walls: &[Vector<f64, D>], fineness: f64) -> Scene<f64, D> {
    let particles = FluidParticles::at_rest(lattice([-5.0; D], [4; D], L0));
    let mut boundary = Boundary::default();
    boundary.add_fine_wall(walls, fineness.powi(D as i32), Slip::Free).unwrap();
    let config = FluidConfig::water(L0, 10.0);
    Scene::new(Fluid::new(config, Rational, |_| (), Open, particles, boundary).unwrap())
}

fn fixed<const D: usize>(points: Vec<Vector<f64, D>>, spacing: f64) -> Box<Fixed<f64, D>> {
    let volumes = vec![spacing.powi(D as i32); points.len()];
    Box::new(Fixed::new(points, volumes, spacing))
}

/// The error with which a scene ends before it has come to `end` \[s\], if any.
fn ends<const D: usize>(scene: &mut Scene<f64, D>, end: f64) -> Option<CouplingError> {
    while scene.fluid().time() < end {
        if let Err(error) = scene.step(&Parallel::serial(), f64::INFINITY) {
            return Some(error);
        }
    }
    None
}

/// A block of `spacing` falls with 1 m/s onto a floor four layers thick, from 3 spacings above it, shifted sideways by `offset` spacings of the
/// floor. How deep its surface is in the floor when it is found, in spacings of the fluid.
fn depth<const D: usize>(fineness: f64, spacing: f64, offset: f64) -> f64 {
    let l1 = fineness * L0;
    let mut counts = [24; D];
    counts[1] = (4.0 / fineness) as usize;
    let mut corner = [-12.0 * l1 + offset * l1; D];
    corner[1] = -4.0 * L0;
    let mut scene = pool(&lattice(corner, counts, l1), fineness);
    let mut lower = [-2.0 * spacing; D];
    lower[1] = 3.0 * L0;
    let mut down = Vector::zeros();
    down[1] = -1.0;
    let block = Driven::new(lattice(lower, [4; D], spacing), spacing, down);
    scene.add_structure(&Parallel::serial(), Box::new(block), Slip::Free).unwrap();
    match ends(&mut scene, 0.2) {
        Some(CouplingError::Contact { index: 0, other: None, place, time, .. }) => {
            assert!(place[1].abs() < 2.0 * L0, "{place:?}");
            (time - 0.03) / L0
        }
        other => panic!("{D}D, floor {fineness}, body {spacing} m, offset {offset}: {other:?}"),
    }
}

#[test]
fn a_body_is_stopped_at_the_surface_of_a_wall_however_its_points_lie() {
    for fineness in [1.0, 0.5] {
        for spacing in [L0, 0.5 * L0] {
            for offset in [0.0, 0.2, 0.5] {
                let [flat, space] =
                    [depth::<2>(fineness, spacing, offset), depth::<3>(fineness, spacing, offset)];
                // Half a spacing, and what it moves between two rebuilds.
                assert!((0.0..0.9).contains(&flat), "{fineness} {spacing} {offset}: {flat}");
                assert!((0.0..0.9).contains(&space), "{fineness} {spacing} {offset}: {space} in space");
            }
        }
    }
}

#[test]
fn two_bodies_that_meet_are_both_named() {
    let across = |x: f64, y: f64, speed: f64| {
        let points = lattice([x * L0, y * L0], [4, 4], L0);
        Box::new(Driven::new(points, L0, Vector::from([speed, 0.0])))
    };
    let mut scene = pool(&lattice([0.0, 1.0], [4, 4], L0), 1.0);
    for body in [across(-20.0, 0.0, 0.0), across(-10.0, 0.0, 1.0), across(10.0, 0.5, -1.0)] {
        scene.add_structure(&Parallel::serial(), body, Slip::Free).unwrap();
    }
    let error = ends(&mut scene, 0.2).unwrap();
    let words = error.to_string();
    assert!(matches!(error, CouplingError::Contact { index: 1, other: Some(2), .. }), "{words}");
    for part in ["structure 1", "structure 2", "not modelled", "pass through"] {
        assert!(words.contains(part), "{words}");
    }
    let again = scene.step(&Parallel::serial(), f64::INFINITY).unwrap_err();
    assert!(matches!(again, CouplingError::Broken { .. }), "{again}");
}

/// How a block of `density` ends that is let go in a tank of water with walls of `fineness`, within a second: the error, and where its lowest points
/// are then, in spacings above the floor.
fn sunk<K: Kernel<f64>>(kernel: K, radius: f64, fineness: f64, density: f64) -> (Option<CouplingError>, f64) {
    let (columns, rows) = (16, 14);
    let mut config = FluidConfig::water(L0, 15.0);
    config.gravity = Vector::from([0.0, -9.81]);
    config.radius_ratio = radius;
    let inside = |r: &Vector<f64, 2>| (5.0..11.0).contains(&(r.x / L0)) && (4.0..8.0).contains(&(r.y / L0));
    let (block, water): (Vec<_>, Vec<_>) =
        lattice([0.0; 2], [columns, rows], L0).into_iter().partition(inside);
    let mut water = FluidParticles::at_rest(water);
    for (n, r) in water.density.iter_mut().zip(&water.position) {
        *n += 9.81 * (rows as f64 * L0 - r.y) / (15.0 * 15.0);
    }
    let outside = |r: &Vector<f64, 2>| r.x < 0.0 || r.x > columns as f64 * L0 || r.y < 0.0;
    let counts = [columns + 8, rows + 12].map(|n| (n as f64 / fineness) as usize);
    let mut walls = lattice([-4.0 * L0; 2], counts, fineness * L0);
    walls.retain(outside);
    let mut boundary = Boundary::default();
    boundary.add_fine_wall(&walls, fineness * fineness, Slip::Free).unwrap();
    let viscosity = |r: &_| ArtificialViscosity::new::<2>(0.1, 15.0, r);
    let fluid = Fluid::new(config, kernel, viscosity, Open, water, boundary).unwrap();
    let mut scene = Scene::new(fluid);
    let mass = density * L0 * L0 * block.len() as f64;
    let block = Piston::new(block, L0, mass, 0.0);
    scene.add_structure(&Parallel::serial(), Box::new(block), Slip::Free).unwrap();
    let mut error = None;
    while error.is_none() && scene.fluid().time() < 1.0 {
        error = scene.step(&Parallel::serial(), f64::INFINITY).err();
    }
    (error, scene.structure(0).unwrap().positions()[0].y / L0)
}

/// It fell through the floor, and the run was complete.
#[test]
fn a_heavy_block_does_not_leave_a_tank_through_its_floor() {
    let ends = [
        sunk(Rational, 3.1, 1.0, 4000.0),
        sunk(WendlandGradient, 4.0, 0.5, 4000.0),
        sunk(WendlandGradient, 4.0, 0.5, 2000.0),
    ];
    for (error, lowest) in ends {
        match error {
            Some(CouplingError::Contact { index: 0, other: None, .. }) => {}
            other => panic!("its lowest points are {lowest} spacings above the floor: {other:?}"),
        }
        // They are half a spacing above where they touch it.
        assert!((-0.5..0.5).contains(&lowest), "{lowest}");
    }
}

/// Along a wall that it touches, and past bodies, with points of any spacing.
#[test]
fn a_body_that_glides_along_a_wall_goes_on() {
    for fineness in [1.0, 0.5] {
        for spacing in [L0, 0.5 * L0] {
            let l1 = fineness * L0;
            let floor =
                lattice([0.0, -2.0 * L0], [(40.0 / fineness) as usize, (2.0 / fineness) as usize], l1);
            let mut scene = pool(&floor, fineness);
            let body = Driven::new(lattice([0.0; 2], [4, 4], spacing), spacing, Vector::from([2.0, 0.0]));
            scene.add_structure(&Parallel::serial(), Box::new(body), Slip::Free).unwrap();
            let ceiling = lattice([0.0, 4.0 * spacing], [40, 2], L0);
            scene.add_structure(&Parallel::serial(), fixed(ceiling, L0), Slip::Free).unwrap();
            let ended = ends(&mut scene, 0.15);
            assert!(ended.is_none(), "{fineness} {spacing}: {ended:?}");
        }
    }
}

/// Where two are one inside the other from the start, somebody holds the one in the other.
#[test]
fn what_was_inside_from_the_start_may_move_there_and_out_again() {
    let mut scene = pool(&lattice([0.0, 0.0], [12, 4], L0), 1.0);
    let post = lattice([4.0 * L0, 2.0 * L0], [4, 2], L0);
    let body = Box::new(Driven::new(post, L0, Vector::from([0.3, 0.5])));
    scene.add_structure(&Parallel::serial(), body, Slip::Free).unwrap();
    let beside = lattice([3.5 * L0, 2.2 * L0], [2, 8], L0);
    scene.add_structure(&Parallel::serial(), fixed(beside, L0), Slip::Free).unwrap();
    let ended = ends(&mut scene, 0.1);
    assert!(ended.is_none(), "{ended:?}");
}

#[test]
fn whoever_models_contact_himself_can_switch_the_question_off() {
    let mut scene = pool(&lattice([0.0, 0.0], [8, 4], L0), 1.0);
    let body = Driven::new(lattice([0.0, 6.0 * L0], [4, 4], L0), L0, Vector::from([0.0, -1.0]));
    scene.add_structure(&Parallel::serial(), Box::new(body), Slip::Free).unwrap();
    scene.refuse_contacts = false;
    assert!(ends(&mut scene, 0.1).is_none());
}
