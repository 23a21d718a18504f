//! The free surface is found on shapes whose surface is known.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{Noise, fill, lattice, tank, water};
use mps_fluid::surface::Surface;
use mps_fluid::surface::Surface::{Detached, Free, Inner};
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidParticles};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Domain, Open, Parallel, PeriodicBox};

const L0: f64 = 0.01;

/// Classes in the order of creation.
fn classify<const D: usize, P: Domain<f64, D>>(fluid: &mut Fluid<f64, D, Rational, (), P>) -> Vec<Surface> {
    let parallel = Parallel::serial();
    fluid.begin_step(&parallel).unwrap();
    let mut sorted = Vec::new();
    fluid.classify_surface(&parallel, &mut sorted).unwrap();
    let mut found = sorted.clone();
    for (class, &id) in sorted.iter().zip(&fluid.particles().id) {
        found[id as usize] = *class;
    }
    found
}

fn classes<const D: usize>(points: &[Vector<f64, D>]) -> Vec<Surface> {
    let particles = FluidParticles::at_rest(points.to_vec());
    let config = FluidConfig::water(L0, 10.0);
    classify(&mut Fluid::new(config, Rational, |_| (), Open, particles, Boundary::default()).unwrap())
}

/// Cell of a point along an axis.
fn cell<const D: usize>(r: &Vector<f64, D>, axis: usize) -> usize {
    (r[axis] / L0) as usize
}

#[test]
fn a_square_has_its_rim_as_surface_and_nothing_else() {
    let points = lattice::<f64, 2>([0.0; 2], [12, 9], L0);
    for (r, class) in points.iter().zip(classes(&points)) {
        let (x, y) = (cell(r, 0), cell(r, 1));
        let rim = x == 0 || y == 0 || x == 11 || y == 8;
        assert_eq!(class, if rim { Free } else { Inner }, "cell {x}, {y}");
    }
}

#[test]
fn a_full_lattice_has_no_surface() {
    let points = lattice::<f64, 2>([0.0; 2], [10, 10], L0);
    let domain = PeriodicBox::new(Vector::zeros(), [Some(10.0 * L0); 2]).unwrap();
    let (config, particles) = (FluidConfig::water(L0, 10.0), FluidParticles::at_rest(points));
    let mut fluid = Fluid::new(config, Rational, |_| (), domain, particles, Boundary::default()).unwrap();
    assert!(classify(&mut fluid).iter().all(|&class| class == Inner));
}

#[test]
fn only_the_top_row_of_a_tank_is_free() {
    let mut fluid = tank::<f64, 2, ()>([12, 10], water(L0, 0.1), |_| ());
    let points = fluid.particles().position.clone();
    for (r, class) in points.iter().zip(classify(&mut fluid)) {
        assert_eq!(class == Free, cell(r, 1) == 9, "cell {}, {}", cell(r, 0), cell(r, 1));
        assert_ne!(class, Detached);
    }
}

#[test]
fn single_particles_and_pairs_are_spray() {
    assert_eq!(classes(&[Vector::<f64, 2>::zeros()]), [Detached]);
    assert_eq!(classes(&[Vector::<f64, 3>::zeros()]), [Detached]);
    assert_eq!(classes(&[Vector::<f64, 2>::zeros(), Vector::<f64, 2>::new(L0, 0.0)]), [Detached; 2]);
}

/// Wherever the centre lies: the last ring is surface, what has two rings around it is not.
#[test]
fn a_round_drop_has_its_rim_as_surface() {
    for (k, radius) in [(0, 6.3), (1, 6.0), (2, 7.7), (3, 9.2)] {
        let center = Vector::<f64, 2>::new(0.17 * f64::from(k), 0.31 * f64::from(k)) * L0;
        let depth = |r: &Vector<f64, 2>| radius - (r - center).norm() / L0;
        let points = fill([-0.12; 2], [0.12; 2], L0, |r| depth(r) > 0.0);
        let classes = classes(&points);
        for (r, class) in points.iter().zip(&classes) {
            assert!(depth(r) > 0.7 || *class != Inner, "radius {radius}, depth {}: {class:?}", depth(r));
            assert!(depth(r) < 2.0 || *class == Inner, "radius {radius}, depth {}: {class:?}", depth(r));
        }
        assert!(!classes.contains(&Detached), "radius {radius}");
    }
}

/// Drops of one particle two spacings apart and a round one, thrown together.
#[test]
fn a_cloud_of_droplets_is_spray_that_flies_without_pressure() {
    let mut noise = Noise::new(3);
    let mut points = fill([0.0; 2], [0.4; 2], 2.0 * L0, |_| true);
    points.iter_mut().for_each(|r| *r += noise.vector::<f64, 2>(0.3 * L0));
    let cloud = points.len();
    points.extend(fill([0.5, 0.0], [0.7, 0.2], L0, |r| (r - Vector::<f64, 2>::new(0.6, 0.1)).norm() < 0.08));
    let mut config = FluidConfig::<f64, 2>::water(L0, 10.0);
    config.gravity.y = -9.81;
    let mut particles = FluidParticles::at_rest(points.clone());
    particles.velocity.fill(Vector::from([2.0, 3.0]));
    let mut fluid = Fluid::new(config, Rational, |_: &_| (), Open, particles, Boundary::default()).unwrap();
    assert!(classify(&mut fluid)[..cloud].iter().all(|&class| class == Detached));
    for _ in 0..100 {
        fluid.step(&Parallel::serial()).unwrap();
        assert!(fluid.particles().pressure.iter().all(|p| *p == 0.0), "step {}", fluid.steps());
    }
    let water = fluid.particles();
    let speed = Vector::<f64, 2>::new(2.0, 3.0 - 9.81 * fluid.time());
    let way = water.position[0] - points[water.id[0] as usize];
    for ((r, u), &id) in water.position.iter().zip(&water.velocity).zip(&water.id) {
        assert!((u - speed).norm() < 1e-12 && (r - points[id as usize] - way).norm() < 1e-12, "{id}");
    }
    assert!((way.x - 2.0 * fluid.time()).abs() < 1e-12);
    let after = classify(&mut fluid);
    assert!(after[..cloud].iter().all(|&class| class == Detached));
    assert!(after[cloud..].iter().all(|&class| class != Detached));
}

#[test]
fn films_are_free_on_both_sides_and_spray_when_one_particle_thin() {
    for (layers, expected) in [(1, vec![Detached]), (2, vec![Free; 2]), (3, vec![Free, Inner, Free])] {
        let points = lattice::<f64, 2>([0.0; 2], [20, layers], L0);
        for (r, class) in points.iter().zip(classes(&points)) {
            // The ends of a film are thinner still.
            if (3..17).contains(&cell(r, 0)) {
                assert_eq!(class, expected[cell(r, 1)], "{layers} layers, row {}", cell(r, 1));
            }
        }
    }
}

#[test]
fn a_cavity_has_a_surface_and_a_missing_particle_has_none() {
    let all = lattice::<f64, 2>([0.0; 2], [21, 21], L0);
    let around = |half: usize| {
        let gone = |k: usize| (10 - half..=10 + half).contains(&k);
        let points: Vec<_> =
            all.iter().filter(|r| !(gone(cell(r, 0)) && gone(cell(r, 1)))).copied().collect();
        let classes = classes(&points);
        let inside = |k: usize| (2..19).contains(&k);
        points
            .into_iter()
            .zip(classes)
            .filter(|(r, _)| inside(cell(r, 0)) && inside(cell(r, 1)))
            .map(|(r, class)| (cell(&r, 0).abs_diff(10).max(cell(&r, 1).abs_diff(10)) - half, r, class))
            .collect::<Vec<_>>()
    };
    assert!(around(0).iter().all(|(_, _, class)| *class == Inner), "a single hole");
    for (distance, r, class) in around(3) {
        // The four corners of the cavity see fluid on three sides.
        let corner = cell(&r, 0).abs_diff(10) == cell(&r, 1).abs_diff(10);
        if distance > 1 || !corner {
            assert_eq!(class == Free, distance == 1, "{distance} from the cavity");
        }
        assert_ne!(class, Detached);
    }
}

#[test]
fn a_cube_has_its_faces_as_surface() {
    let n = 9;
    let points = lattice::<f64, 3>([0.0; 3], [n; 3], L0);
    for (r, class) in points.iter().zip(classes(&points)) {
        let at_faces = (0..3).filter(|&axis| [0, n - 1].contains(&cell(r, axis))).count();
        match at_faces {
            0 => assert_eq!(class, Inner, "{r}"),
            1 | 2 => assert_eq!(class, Free, "{r}"),
            // With 0.30 n0 the very corner is below the limit of spray.
            _ => assert_ne!(class, Inner, "{r}"),
        }
    }
}

#[test]
fn the_surface_can_be_asked_for_before_the_first_step() {
    let mut fluid = tank::<f64, 2, ()>([12, 10], water(L0, 0.1), |_| ());
    let mut surface = Vec::new();
    fluid.classify_surface(&Parallel::serial(), &mut surface).unwrap();
    assert_eq!(surface.iter().filter(|&&class| class == Free).count(), 12);
}
