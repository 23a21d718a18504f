//! What an error costs (nothing), and what a restart changes (nothing).

use crate::folded::slotted;
use crate::scene::{V, block, contact, none, rubber, solid};
use mps_kernel::Vector;
use mps_neighbors::Parallel;
use mps_solid::contact::{Contact, ContactError, Elastic};
use mps_solid::materials::NeoHookean;
use mps_solid::{Solid, SolidConfig};

pub(crate) type Body = Solid<f64, 2, NeoHookean<f64>>;

pub(crate) fn square(corner: V, velocity: V) -> Body {
    let mut square = block(corner, [6, 6], 0.1, NeoHookean::new(1e6, 0.3).unwrap());
    square.velocities_mut().fill(velocity);
    square
}

pub(crate) fn state(bodies: &[Body]) -> Vec<u64> {
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
