//! What an error costs (nothing), and what a restart changes (nothing).

use crate::folded::slotted;
use crate::scene::{V, block, contact, none, rubber, solid};
use mps_kernel::Vector;
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::contact::{Contact, ContactConfig, ContactError, Elastic, Shape};
use mps_solid::materials::NeoHookean;
use mps_solid::{Solid, SolidConfig, SolidEnergy, SolidError};

type Body = Solid<f64, 2, NeoHookean<f64>>;

fn square(corner: V, velocity: V) -> Body {
    let mut square = block(corner, [6, 6], 0.1, NeoHookean::new(1e6, 0.3).unwrap());
    square.velocities_mut().fill(velocity);
    square
}

fn state(bodies: &[Body]) -> Vec<u64> {
    let of = |body: &Body| {
        let vectors = body.positions().iter().chain(body.velocities()).chain(body.mean_velocities());
        let bits: Vec<u64> = vectors.flat_map(|x| x.iter().map(|x| x.to_bits())).collect();
        bits.into_iter().chain([body.time().to_bits()])
    };
    bodies.iter().flat_map(of).collect()
}

/// One flies alone, two at each other, so fast that they pass through one another.
#[test]
fn after_an_error_all_bodies_are_where_they_were() {
    let serial = Parallel::serial();
    let speed = square(V::zeros(), V::zeros()).wave_speed();
    let mut bodies = vec![
        square(V::new(0.0, 3.0), V::new(speed, 0.0)),
        square(V::zeros(), V::new(speed, 0.0)),
        square(V::new(0.65, 0.0), V::new(-speed, 0.0)),
    ];
    let mut contact = contact(&[&bodies[0], &bodies[1], &bodies[2]]);
    let (dt, nothing): (f64, [&[V]; 3]) = (0.01 / speed, [&[]; 3]);
    let mut go = |bodies: &mut [Body], external: &[&[V]], dt: f64, substeps: usize| {
        let mut all: Vec<&mut dyn Elastic<f64, 2>> = Vec::new();
        bodies.iter_mut().for_each(|body| all.push(body));
        contact.advance(&serial, &mut all, |body| external[body], &V::zeros(), dt, substeps)
    };
    go(&mut bodies, &nothing, dt, 2).unwrap();
    let before = state(&bodies);

    let few = vec![V::zeros(); 7];
    let result = go(&mut bodies, &[&[], &[], &few], dt, 1);
    assert!(matches!(result, Err(ContactError::Length { body: 2, got: 7, .. })), "{result:?}");
    assert!(state(&bodies) == before);
    for bad in [f64::NAN, -dt, 0.0] {
        let result = go(&mut bodies, &nothing, bad, 1);
        assert!(matches!(result, Err(ContactError::Parameter { name: "dt", .. })), "{result:?}");
    }
    assert!(state(&bodies) == before);

    let result = go(&mut bodies, &nothing, 12.0 * dt, 12);
    let Err(error @ (ContactError::Passed { .. } | ContactError::Body { .. })) = result else {
        panic!("{result:?}")
    };
    eprintln!("{error}");
    assert!(state(&bodies) == before, "all bodies are taken back");
    // So that the advice can be followed: less at once goes well.
    go(&mut bodies, &nothing, 0.5 * dt, 1).unwrap();
    assert!(bodies.iter().all(|body| body.time() == bodies[0].time()));
}

/// Moves bodies and, each time, their twins in contact that knows nothing of what was before. They touch and part.
fn goes_on_like_a_twin(mut bodies: Vec<Body>, rounds: usize) {
    let serial = Parallel::serial();
    let built = |bodies: &[Body]| {
        let all: Vec<&dyn Elastic<f64, 2>> = bodies.iter().map(|body| body as _).collect();
        contact(&all)
    };
    let step = |contact: &mut Contact<f64, 2>, bodies: &mut [Body]| {
        let mut all: Vec<&mut dyn Elastic<f64, 2>> = Vec::new();
        bodies.iter_mut().for_each(|body| all.push(body));
        let dt = contact.max_step(&serial, &all).unwrap();
        contact.advance(&serial, &mut all, none, &Vector::zeros(), 2.0 * dt, 2).unwrap();
        dt
    };
    let mut old = built(&bodies);
    let (mut touched, mut parted) = (false, false);
    for round in 0..rounds {
        let mut twins = bodies.clone();
        let mut new = built(&twins);
        let (dt, twin_dt) = (step(&mut old, &mut bodies), step(&mut new, &mut twins));
        assert_eq!(dt.to_bits(), twin_dt.to_bits(), "round {round}: {dt} and {twin_dt}");
        assert!(state(&bodies) == state(&twins), "round {round}");
        assert_eq!(old.energy().to_bits(), new.energy().to_bits(), "round {round}");
        touched |= old.energy() > 0.0;
        parted |= touched && old.energy() == 0.0;
    }
    assert!(touched && parted);
}

#[test]
fn contact_that_was_built_anew_goes_on_with_the_same_bits() {
    let speed = 0.05 * square(V::zeros(), V::zeros()).wave_speed();
    let (left, right) =
        (square(V::zeros(), V::new(speed, 0.0)), square(V::new(0.8, 0.13), V::new(-speed, 0.2 * speed)));
    goes_on_like_a_twin(vec![left, right], 120);
    // The arms of one that clap together.
    let mut body = solid(slotted(1.5), V::repeat(1.0), rubber(), SolidConfig::default());
    let clap: Vec<_> =
        body.positions().iter().map(|x| V::new(0.0, 0.1 * x.x.max(0.0) * (1.25 - x.y).signum())).collect();
    body.velocities_mut().copy_from_slice(&clap);
    goes_on_like_a_twin(vec![body], 150);
}

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
