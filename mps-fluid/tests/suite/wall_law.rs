//! Walls with a law: what they take from the fluid is what the law says, and what they give back is the same.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{Noise, lattice};
use approx::assert_relative_eq;
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidError, FluidParticles, Slip, WallLaw};
use mps_kernel::Vector;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::{Parallel, PeriodicBox};

const L0: f64 = 0.01;
const COLUMNS: usize = 12;
const SPEED: f64 = 1.7;
const LAW: WallLaw<f64> = WallLaw { viscosity: 1e-6 };

type Sheet<const D: usize> = Fluid<f64, D, WendlandGradient, (), PeriodicBox<f64, D>>;

/// A sheet of fluid that slides without weight over a bed that feels it, its lowest row `lift` spacings too high.
fn sheet<const D: usize>(rows: usize, lift: f64, along: Vector<f64, D>) -> Sheet<D> {
    let mut count = [COLUMNS; D];
    count[1] = rows;
    let mut corner = [0.0; D];
    corner[1] = lift * L0;
    let mut water = FluidParticles::at_rest(lattice::<f64, D>(corner, count, L0));
    water.velocity.fill(along);
    (count, corner) = ([2 * COLUMNS; D], [0.0; D]);
    (count[1], corner[1]) = (8, -4.0 * L0);
    let bed = lattice::<f64, D>(corner, count, 0.5 * L0);
    let mut boundary = Boundary::default();
    boundary.add_structure(&bed, core::iter::repeat(0.5_f64.powi(D as i32)), Slip::Law);
    let mut period = [Some(COLUMNS as f64 * L0); D];
    period[1] = None;
    let channel = PeriodicBox::new(Vector::zeros(), period).unwrap();
    let mut config = FluidConfig::<f64, D>::water(L0, 20.0);
    config.radius_ratio = 4.0;
    Fluid::new(config, WendlandGradient, |_| (), channel, water, boundary).unwrap()
}

/// Force on the bed \[N\] at the first step.
fn force_on_bed<const D: usize>(fluid: &mut Sheet<D>) -> Vector<f64, D> {
    fluid.begin_step(&Parallel::serial()).unwrap();
    fluid.boundary().force.iter().sum()
}

/// Of a film or of deep water; where the rows do not lie as on the lattice, on average over where they lie.
#[test]
fn a_stretch_of_wall_feels_the_stress_of_the_law() {
    let length = COLUMNS as f64 * L0;
    let expected = 1000.0 * LAW.stress(SPEED, 0.5 * L0) * length;
    for (rows, lifts) in [(1, [0.0, 0.0]), (6, [0.0, 0.0]), (6, [-0.2, 0.2]), (6, [-0.3, 0.3])] {
        let along = Vector::from([SPEED, 0.0]);
        let force = lifts
            .iter()
            .map(|lift| force_on_bed(&mut sheet::<2>(rows, *lift, along)))
            .sum::<Vector<f64, 2>>()
            / 2.0;
        assert_relative_eq!(force.x, expected, max_relative = 1e-3);
        let along = Vector::from([0.6 * SPEED, 0.0, -0.8 * SPEED]);
        let force = lifts
            .iter()
            .map(|lift| force_on_bed(&mut sheet::<3>(rows, *lift, along)))
            .sum::<Vector<f64, 3>>()
            / 2.0;
        assert_relative_eq!(force.x, 0.6 * expected * length, max_relative = 1e-3);
        assert_relative_eq!(force.z, -0.8 * expected * length, max_relative = 1e-3);
    }
}

#[test]
fn the_wall_gives_back_what_it_takes() {
    let mut fluid = sheet::<2>(5, 0.0, Vector::from([SPEED, 0.0]));
    let mut noise = Noise::new(5);
    for (r, u) in {
        let water = fluid.particles_mut();
        water.position.iter_mut().zip(&mut water.velocity)
    } {
        *r += noise.vector::<f64, 2>(0.2 * L0);
        *u += noise.vector::<f64, 2>(0.5);
    }
    let force = force_on_bed(&mut fluid);
    let push = fluid.push_by_structures(&Parallel::serial(), &Vector::zeros()).force;
    let mass = fluid.config().particle_mass();
    let gained: Vector<f64, 2> = fluid.acceleration().iter().sum::<Vector<f64, 2>>() * mass;
    assert!(force.x > 0.5, "the bed is dragged along: {force}");
    assert!((force + push).norm() < 1e-12 * force.norm());
    assert!((force + gained).norm() < 1e-11 * force.norm(), "{force} on the bed, {gained} on the water");
}

/// `du/dt = -k u^(7/4)`: a film of one row has nothing else that acts on it.
#[test]
fn a_film_slows_down_as_the_law_says() {
    let parallel = Parallel::serial();
    let mut film = sheet::<2>(1, 0.0, Vector::from([SPEED, 0.0]));
    film.keep_books();
    let before = film.energy(&parallel).kinetic;
    while film.time() < 1.0 {
        film.step(&parallel).unwrap();
    }
    let rate = LAW.stress(1.0, 0.5 * L0) / L0;
    let expected = (SPEED.powf(-0.75) + 0.75 * rate * film.time()).powf(-4.0 / 3.0);
    let speed = film.particles().velocity.iter().map(|u| u.x).sum::<f64>() / COLUMNS as f64;
    assert!(speed < 0.7 * SPEED, "slowed down to {speed}");
    assert_relative_eq!(speed, expected, max_relative = 1e-3);
    let lost = film.energy(&parallel).kinetic - before;
    assert_relative_eq!(film.budget().unwrap().viscosity, lost, max_relative = 1e-6);
}

#[test]
fn what_moves_with_the_wall_feels_nothing() {
    let along = Vector::from([SPEED, 0.0]);
    let mut fluid = sheet::<2>(4, 0.0, along);
    fluid.boundary_mut().velocity.fill(along);
    // The velocity of the wall is a mean over its points, rounded.
    assert!(force_on_bed(&mut fluid).x.abs() < 1e-12);
}

/// Water between walls whose points are the cells of `solid`, all moving with `along`.
fn between(
    solid: impl Fn(i32, i32) -> bool,
    water: [[i32; 2]; 2],
    along: Vector<f64, 2>,
) -> Fluid<f64, 2, WendlandGradient> {
    let place = |x: i32, y: i32| Vector::from([f64::from(x) + 0.5, f64::from(y) + 0.5]) * L0;
    let [[x0, x1], [y0, y1]] = water;
    let mut particles =
        FluidParticles::at_rest((x0..x1).flat_map(|x| (y0..y1).map(move |y| place(x, y))).collect());
    particles.velocity.fill(along);
    let fine = |k: i32| (-10..40).flat_map(move |x| (-10..40).map(move |y| (2 * x + k % 2, 2 * y + k / 2)));
    let points: Vec<_> = (0..4)
        .flat_map(fine)
        .filter(|(x, y)| solid(x.div_euclid(2), y.div_euclid(2)))
        .map(|(x, y)| Vector::from([f64::from(x) + 0.5, f64::from(y) + 0.5]) * (0.5 * L0))
        .collect();
    let mut boundary = Boundary::default();
    boundary.add_structure(&points, core::iter::repeat(0.25), Slip::Law);
    let mut config = FluidConfig::<f64, 2>::water(L0, 20.0);
    config.radius_ratio = 4.0;
    Fluid::new(config, WendlandGradient, |_| (), mps_neighbors::Open, particles, boundary).unwrap()
}

/// The points of the other wall of a corner lie level with a particle far from both.
#[test]
fn in_a_corner_only_the_rows_at_the_walls_are_dragged() {
    let along = Vector::from([-SPEED, 0.3]);
    let mut water = between(|x, y| (x < 0 || y < 0) && x < 14 && y < 14, [[0, 10], [0, 10]], along);
    let dt = water.begin_step(&Parallel::serial()).unwrap();
    let mut dragged = 0;
    for (i, r) in water.particles().position.iter().enumerate() {
        let explained = water.explain(i, dt).unwrap().acceleration;
        let rest = (explained.total() - water.acceleration()[i]).norm();
        assert!(rest < 1e-10 * (1.0 + water.acceleration()[i].norm()), "terms leave {rest}");
        if r.min() > 1.6 * L0 {
            assert_eq!(explained.structure_shear.norm(), 0.0, "dragged at {r}");
        } else if r.max() > 4.2 * L0 {
            let speed = if r.y < L0 { along.x } else { along.y };
            let expected = LAW.stress(speed.abs(), 0.5 * L0) / L0;
            if r.min() < L0 {
                assert_relative_eq!(explained.structure_shear.norm(), expected, max_relative = 1e-6);
                dragged += 1;
            } else {
                assert!(explained.structure_shear.norm() < 1e-9 * expected, "the second row at {r}");
            }
        }
    }
    assert_eq!(dragged, 12, "the first rows of both walls away from the corner");
}

/// Each wall of a gap feels its own stress, though both are in reach of all rows.
#[test]
fn both_walls_of_a_gap_are_felt_once() {
    // Of three the middle one is dragged a little: where the nearer wall is it learns from rounding.
    for rows in [2, 4, 5] {
        let along = Vector::from([SPEED, 0.0]);
        let mut water =
            between(|x, y| (y < 0 || y >= rows) && (-8..38).contains(&x), [[0, 30], [0, rows]], along);
        let force = {
            water.begin_step(&Parallel::serial()).unwrap();
            water.boundary().force.iter().map(|f| f.x).sum::<f64>()
        };
        let mass = water.config().particle_mass();
        let pressed: f64 = water.acceleration().iter().map(|a| a.x).sum::<f64>() * mass;
        let expected = 2.0 * 1000.0 * LAW.stress(SPEED, 0.5 * L0) * 30.0 * L0;
        assert_relative_eq!(force, expected, max_relative = 1e-3);
        assert_relative_eq!(pressed, -expected, max_relative = 1e-3);
    }
}

#[test]
fn a_viscous_fluid_is_told_to_stick() {
    let water = FluidParticles::at_rest(lattice::<f64, 2>([0.0; 2], [4, 4], L0));
    let mut boundary = Boundary::default();
    boundary.add_wall(&lattice::<f64, 2>([0.0, -4.0 * L0], [4, 4], L0), Slip::Law).unwrap();
    let mut config = FluidConfig::<f64, 2>::water(L0, 20.0);
    config.wall_viscosity = 0.1;
    let open = mps_neighbors::Open;
    let error = Fluid::new(config, WendlandGradient, |_| (), open, water, boundary).unwrap_err();
    assert!(matches!(error, FluidError::Parameter { name: "wall_viscosity", .. }), "{error}");
    assert!(error.to_string().contains("no slip"), "{error}");
}
