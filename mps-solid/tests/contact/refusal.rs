//! What contact refuses: bodies in each other, faces that are not where they are drawn, steps that are no numbers.

use crate::failure::{Body, square, state};
use crate::scene::{V, contact, none, solid};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::contact::{Contact, ContactConfig, ContactError, Elastic, Shape};
use mps_solid::materials::NeoHookean;
use mps_solid::{SolidConfig, SolidEnergy, SolidError};

#[test]
fn bodies_that_are_drawn_into_each_other_are_refused_before_they_move() {
    let serial = Parallel::serial();
    let mut bodies = vec![square(V::zeros(), V::zeros()), square(V::new(0.0, 0.57), V::zeros())];
    let start = state(&bodies);
    let mut drawn = contact(&[&bodies[0], &bodies[1]]);
    let mut all: Vec<&mut dyn Elastic<f64, 2>> = Vec::new();
    bodies.iter_mut().for_each(|body| all.push(body));
    let dt = drawn.max_step(&serial, &all).unwrap();
    let result = drawn.advance(&serial, &mut all, none, &V::zeros(), dt, 1);
    let Err(error @ ContactError::Overlap { body: 0, other: 1, .. }) = result else { panic!("{result:?}") };
    assert!(error.to_string().contains("draw them apart"), "{error}");
    // One that goes on under pressure is let in.
    let config = ContactConfig { initial_overlap: 1.0, ..ContactConfig::default() };
    let mut restored = Contact::new(config).unwrap();
    all.iter().for_each(|body| assert!(restored.add(&body.shape()).is_ok()));
    restored.advance(&serial, &mut all, none, &V::zeros(), dt, 1).unwrap();
    assert!(state(&bodies) != start);
}

/// A block that is drawn on a wall lies on it; on a clamped face it would be half a spacing inside.
#[test]
fn a_wall_is_where_it_is_drawn() {
    let serial = Parallel::serial();
    let material = NeoHookean::new(1e6, 0.3).unwrap();
    let (lower, upper) = (V::new(-0.5, -0.2), V::new(1.1, 0.0));
    let wall = body::wall(lower, upper, [16, 2]).unwrap();
    let mut wall = solid(wall.particles, wall.spacing, material, SolidConfig::default());
    let clamped = body::block(lower, upper, [16, 3], &[Face::upper(1)]).unwrap();
    let mut clamped = solid(clamped.particles, V::repeat(0.1), material, SolidConfig::default());
    let mut lying = square(V::zeros(), V::zeros());
    let dt = 0.5 * lying.max_step(&serial);
    let mut go = |under: &mut Body| {
        let mut contact = contact(&[&*under, &lying]);
        let mut all: [&mut dyn Elastic<f64, 2>; 2] = [under, &mut lying];
        contact.advance(&serial, &mut all, none, &V::zeros(), 100.0 * dt, 100)
    };
    let result = go(&mut clamped);
    let Err(error @ (ContactError::Overlap { .. } | ContactError::Passed { .. })) = result else {
        panic!("{result:?}")
    };
    assert!(error.to_string().contains("body::wall"), "{error}");
    go(&mut wall).unwrap();
    let fastest = lying.velocities().iter().map(|u| u.norm()).fold(0.0, f64::max);
    assert!(fastest < 1e-3 * lying.wave_speed(), "{fastest}");
    assert_eq!(wall.positions(), wall.particles().reference_positions());
}

#[test]
fn cells_that_are_not_square_are_refused() {
    let block = body::block(V::zeros(), V::repeat(0.6), [6, 12], &[]).unwrap();
    let material = NeoHookean::new(1e6, 0.3).unwrap();
    let flat = solid(block.particles, block.spacing, material, SolidConfig::default());
    let result = Contact::new(ContactConfig::default()).unwrap().add(&flat.shape());
    assert!(matches!(result, Err(ContactError::Uneven { body: 0, ratio, .. }) if ratio > 1.9), "{result:?}");
}

/// A body whose step is no number.
struct Lost(Body);

impl Elastic<f64, 2> for Lost {
    fn shape(&self) -> Shape<'_, f64, 2> {
        self.0.shape()
    }

    fn positions(&self) -> &[V] {
        self.0.positions()
    }

    fn max_step(&self, _: &Parallel) -> f64 {
        f64::NAN
    }

    fn kick(&mut self, parallel: &Parallel, force: &[V], dt: f64) -> Result<(), SolidError> {
        self.0.kick(parallel, force, dt)
    }

    fn advance(&mut self, p: &Parallel, force: &[V], gravity: &V, dt: f64) -> Result<(), SolidError> {
        self.0.advance(p, force, gravity, dt, 1)
    }

    fn energy(&self, parallel: &Parallel, gravity: &V) -> SolidEnergy<f64> {
        self.0.energy(parallel, gravity)
    }
}

#[test]
fn a_step_that_is_no_number_is_not_hidden_by_another() {
    let serial = Parallel::serial();
    let (mut one, mut lost) = (square(V::zeros(), V::zeros()), Lost(square(V::new(2.0, 0.0), V::zeros())));
    let mut contact = contact(&[&one, &lost]);
    let all: [&mut dyn Elastic<f64, 2>; 2] = [&mut one, &mut lost];
    let result = contact.max_step(&serial, &all);
    assert!(matches!(result, Err(ContactError::Step { body: 1, value }) if value.is_nan()), "{result:?}");
}
