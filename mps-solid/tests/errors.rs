//! What is refused, and what the message says.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::block;
use mps_kernel::{ParticleStore, Vector, weights::WendlandC2};
use mps_neighbors::{FrozenError, Parallel};
use mps_solid::materials::{CorotationalHooke, Moduli, SaintVenantKirchhoff};
use mps_solid::{Solid, SolidConfig, SolidError, SolidParticles};

type Plane = Solid<f64, 2, CorotationalHooke<f64>>;

fn build(particles: SolidParticles<f64, 2>, density: f64) -> Result<Plane, SolidError> {
    let rubber = CorotationalHooke::new(1e6, 0.4).unwrap();
    let (config, parallel) = (SolidConfig::default(), Parallel::serial());
    Solid::new(particles, Vector::<f64, 2>::repeat(1.0), density, rubber, WendlandC2, config, &parallel)
}

fn grid(columns: usize, rows: usize) -> SolidParticles<f64, 2> {
    let mut particles = SolidParticles::new();
    for k in 0..columns * rows {
        particles.push(Vector::<f64, 2>::new((k % columns) as f64, (k / columns) as f64), 1.0, false);
    }
    particles
}

#[test]
fn a_body_one_particle_thick_is_refused() {
    let error = build(grid(5, 1), 1000.0).unwrap_err();
    assert!(matches!(error, SolidError::Collinear { id: 0, neighbors: 1, .. }));
    assert!(error.to_string().contains("at least 2 particles thick"));
}

#[test]
fn unusable_bodies_are_refused() {
    assert_eq!(build(SolidParticles::new(), 1000.0).unwrap_err(), SolidError::Empty);
    for density in [0.0, -1.0, f64::NAN] {
        assert!(matches!(build(grid(3, 3), density), Err(SolidError::Parameter { name: "density", .. })));
    }
    for volume in [0.0, -1.0, f64::NAN] {
        let mut particles = grid(3, 3);
        particles.push(Vector::<f64, 2>::new(3.0, 0.0), volume, false);
        assert!(matches!(build(particles, 1.0), Err(SolidError::Volume { id: 9, .. })));
    }
    let mut twice = grid(3, 3);
    twice.push(Vector::<f64, 2>::new(1.0, 1.0), 1.0, false);
    let expected = FrozenError::Coincident { first: 4, second: 9 };
    assert_eq!(build(twice, 1.0).unwrap_err(), SolidError::Reference(expected));
    let mut lost = grid(3, 3);
    lost.push(Vector::<f64, 2>::new(f64::NAN, 1.0), 1.0, false);
    assert!(matches!(build(lost, 1.0), Err(SolidError::Reference(FrozenError::Search(_)))));
}

/// Moduli that no body has, of a material that was put together by hand.
#[test]
fn impossible_moduli_are_refused_by_name() {
    let of = |lambda: f64, mu: f64| {
        let material = CorotationalHooke { moduli: Moduli { lambda, mu } };
        let (config, parallel) = (SolidConfig::default(), Parallel::serial());
        let spacing = Vector::<f64, 2>::repeat(1.0);
        Solid::new(grid(3, 3), spacing, 1.0, material, WendlandC2, config, &parallel).map(|_| ())
    };
    for (lambda, mu, part) in [
        (1.0, -1.0, "the shear modulus"),
        (1.0, 0.0, "the shear modulus"),
        (f64::NAN, 1.0, "lambda + 2 mu/D"),
        (-1.0, 1.0, "lambda + 2 mu/D"),
        (-3.0, 1.0, "lambda + 2 mu/D"),
        (f64::INFINITY, 1.0, "lambda + 2 mu/D"),
    ] {
        let error = of(lambda, mu).unwrap_err();
        assert!(matches!(error, SolidError::Parameter { .. }) && error.to_string().contains(part), "{error}");
    }
    assert!(of(-0.9, 1.0).is_ok(), "auxetic");
}

#[test]
fn unusable_steps_are_refused_and_move_nothing() {
    let parallel = Parallel::serial();
    let mut solid = block([5, 4], &[], CorotationalHooke::new(1e6, 0.3).unwrap());
    let (rest, gravity) = (vec![Vector::<f64, 2>::zeros(); 20], Vector::<f64, 2>::zeros());
    let before = solid.positions().to_vec();
    assert!(matches!(
        solid.advance(&parallel, &rest[1..], &gravity, 1e-6, 1),
        Err(SolidError::Length { got: 19, particles: 20, .. })
    ));
    for dt in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            solid.advance(&parallel, &rest, &gravity, dt, 1),
            Err(SolidError::Parameter { name: "dt", .. })
        ));
    }
    assert!(matches!(
        solid.advance(&parallel, &rest, &gravity, 1e-6, 0),
        Err(SolidError::Parameter { name: "substeps", .. })
    ));
    assert_eq!(solid.positions(), before);
}

/// A particle pushed through its neighbours: fenris has `todo!()` here, we name the particle.
#[test]
fn an_inverted_particle_is_named() {
    let parallel = Parallel::serial();
    let mut solid = block([5, 4], &[], SaintVenantKirchhoff::new(1e6, 0.3).unwrap());
    let push = 0.03;
    solid.positions_mut()[0].x += push;
    let error = solid.refresh(&parallel).unwrap_err();
    let SolidError::Inverted { id: 0, position, determinant } = &error else { panic!("{error}") };
    assert!(*determinant < 0.0 && position[0] > push);
    assert!(error.to_string().contains("halve the sub-step"));
}

#[test]
fn a_force_that_is_not_a_number_is_found() {
    let parallel = Parallel::serial();
    let mut solid = block([5, 4], &[], CorotationalHooke::new(1e6, 0.3).unwrap());
    let mut force = vec![Vector::<f64, 2>::zeros(); 20];
    force[7].y = f64::NAN;
    let dt = solid.max_step(&parallel);
    let error = solid.advance(&parallel, &force, &Vector::<f64, 2>::zeros(), dt, 1).unwrap_err();
    assert!(matches!(error, SolidError::NotFinite { .. }), "{error}");
}

#[test]
fn a_step_above_the_limit_ends_in_an_error_not_in_a_panic() {
    let parallel = Parallel::serial();
    let mut solid = block([8, 6], &[], CorotationalHooke::new(1e6, 0.3).unwrap());
    solid.velocities_mut()[0].x = 1.0;
    let rest = vec![Vector::<f64, 2>::zeros(); solid.len()];
    let dt = 1.1 * solid.stability_limit();
    let failed =
        (0..1000).find_map(|_| solid.advance(&parallel, &rest, &Vector::<f64, 2>::zeros(), dt, 1).err());
    assert!(matches!(failed, Some(SolidError::Inverted { .. } | SolidError::NotFinite { .. })));
}

#[test]
fn store_has_one_name_for_each_field() {
    struct Names(Vec<&'static str>);
    impl mps_kernel::FieldVisitor for Names {
        fn visit<F: mps_kernel::Pod + Send + Sync>(&mut self, name: &'static str, field: &mut Vec<F>) {
            assert_eq!(field.len(), 20, "{name}");
            self.0.push(name);
        }
    }
    let mut solid = block([5, 4], &[], CorotationalHooke::new(1e6, 0.3).unwrap());
    assert_eq!(ParticleStore::len(&solid), 20);
    let mut names = Names(Vec::new());
    solid.for_each_field(&mut names);
    let count = names.0.len();
    names.0.sort_unstable();
    names.0.dedup();
    assert_eq!(names.0.len(), count);
}
