//! What contact promises: forces from an energy, a limit of the step, the same bits, refusals by name.

use crate::common::Noise;
use crate::scene::{V, block, contact, none, solid};
use mps_kernel::Vector;
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::contact::{Contact, ContactConfig, ContactError, Elastic};
use mps_solid::materials::{CorotationalHooke, NeoHookean};
use mps_solid::{Solid, SolidConfig};

/// Central differences of the energy give the forces: between bodies, and where a body is folded.
#[test]
fn forces_are_the_gradient_of_the_energy() {
    let serial = Parallel::serial();
    let material = CorotationalHooke::new(1e6, 0.3).unwrap();
    let one = block(V::zeros(), [8, 3], 0.1, material);
    let other = block(V::new(0.13, 0.28), [7, 3], 0.11, material);
    let mut contact = contact(&[&one, &other]);
    let mut noise = Noise::new(7);
    let mut places = [one.positions().to_vec(), other.positions().to_vec()];
    places.iter_mut().flatten().for_each(|x| *x += noise.vector::<f64, 2>() * 0.01);
    // The ends of the first are bent towards each other until its surface meets itself.
    let bend = |x: &mut V| {
        let (s, r) = (x.x / 0.119, 0.393 - x.y);
        *x = V::new(r * s.sin(), -r * s.cos());
    };
    for folded in [false, true] {
        if folded {
            places[0].iter_mut().for_each(bend);
            places[1].iter_mut().for_each(|x| x.y += 5.0);
        }
        contact.update(&serial, |body| &places[body]).unwrap();
        assert_eq!(contact.overlap(0, 0) > 0.0, folded);
        assert_eq!(contact.overlap(0, 1) > 0.0, !folded);
        let forces = [contact.forces(0).to_vec(), contact.forces(1).to_vec()];
        let largest = forces.iter().flatten().map(V::norm).fold(0.0, f64::max);
        assert!(largest > 0.0);
        let h = 1e-6;
        for body in 0..2 {
            for i in 0..places[body].len() {
                for axis in 0..2 {
                    let mut energy_at = |shift: f64| {
                        let mut moved = places.clone();
                        moved[body][i][axis] += shift;
                        contact.update(&serial, |body| &moved[body]).unwrap();
                        contact.energy()
                    };
                    let slope = -(energy_at(h) - energy_at(-h)) / (2.0 * h);
                    assert!(
                        (slope - forces[body][i][axis]).abs() < 1e-5 * largest,
                        "{body} {i} {axis}: {slope} {}",
                        forces[body][i]
                    );
                }
            }
        }
    }
}

/// Two blocks held at their outer faces, `closer` than they are thick, with both safety factors at 1.
struct Pressed {
    blocks: [Solid<f64, 2, CorotationalHooke<f64>>; 2],
    contact: Contact<f64, 2>,
}

impl Pressed {
    fn new(nu: f64, closer: f64) -> Self {
        let material = CorotationalHooke::new(1e6, nu).unwrap();
        let build = |y: f64, face: Face| {
            let part = body::block(V::new(0.0, y), V::new(0.8, y + 0.35), [8, 4], &[face]).unwrap();
            let config = SolidConfig { cfl: 1.0, ..SolidConfig::default() };
            solid(part.particles, part.spacing, material, config)
        };
        let blocks = [build(0.0, Face::lower(1)), build(0.35 - closer, Face::upper(1))];
        let config = ContactConfig { cfl: 1.0, ..ContactConfig::default() };
        let mut contact = Contact::new(config).unwrap();
        blocks.iter().for_each(|block| assert!(contact.add(&block.shape()).is_ok()));
        Self { blocks, contact }
    }

    fn limit(&mut self) -> f64 {
        let [under, over] = &mut self.blocks;
        self.contact.max_step(&Parallel::serial(), &[under, over]).unwrap()
    }

    fn advance(&mut self, dt: f64, substeps: usize) -> Result<(), ContactError> {
        let [under, over] = &mut self.blocks;
        let bodies: &mut [&mut dyn Elastic<f64, 2>] = &mut [under, over];
        self.contact.advance(&Parallel::serial(), bodies, none, &V::zeros(), dt * substeps as f64, substeps)
    }

    /// Mean square of the speeds.
    fn speed2(&self) -> f64 {
        let all = self.blocks.iter().flat_map(|block| block.velocities());
        all.map(|u| u.norm_squared()).sum::<f64>() / 64.0
    }

    fn energy(&self) -> f64 {
        let of = |block: &Solid<f64, 2, _>| block.energy(&Parallel::serial(), &V::zeros()).total();
        self.blocks.iter().map(of).sum::<f64>() + self.contact.energy()
    }
}

/// At the limit that is given two blocks that are pressed together keep their energy: what moves in them does not grow.
#[test]
fn the_stability_limit_is_respected() {
    for nu in [0.0, 0.3, 0.45] {
        // Let down until the vibration that follows does not open the contact.
        let mut resting = Pressed::new(nu, 0.002);
        let dt = 0.5 * resting.limit();
        for _ in 0..4000 {
            resting.advance(dt, 1).unwrap();
            resting
                .blocks
                .iter_mut()
                .for_each(|block| block.velocities_mut().iter_mut().for_each(|u| *u *= 0.98));
        }
        let grows = |factor: f64| {
            let (blocks, contact) = (resting.blocks.clone(), resting.contact.clone());
            let mut pressed = Pressed { blocks, contact };
            let mut noise = Noise::new(3);
            for block in &mut pressed.blocks {
                block.velocities_mut().iter_mut().for_each(|u| *u = noise.vector::<f64, 2>() * 1e-3);
            }
            let (start, dt) = (pressed.speed2(), factor * pressed.limit());
            let mut most = 0.0_f64;
            for _ in 0..200 {
                if pressed.advance(dt, 30).is_err() {
                    return f64::INFINITY;
                }
                most = most.max(pressed.speed2());
            }
            (most / start).sqrt()
        };
        let at_limit = [0.9, 0.98, 1.0].map(grows);
        let border = (1..20).map(|k| 1.0 + 0.03 * f64::from(k)).find(|&factor| grows(factor) > 2.0);
        eprintln!(
            "nu = {nu}: speeds grow to {at_limit:.3?} of those at the start at 0.9, 0.98 and 1 times the limit, unstable from {border:?} on"
        );
        assert!(at_limit.iter().all(|growth| *growth < 2.0), "{at_limit:?}");
    }
}

/// Blocks that knock without damping for 18 000 sub-steps. Every particle that comes or goes is a kink in its force, at a random place of a
/// step: short steps do not mind.
#[test]
fn knocking_blocks_keep_their_energy_with_short_steps() {
    let gain = |factor: f64| {
        let mut knocking = Pressed::new(0.3, 0.002);
        let mut noise = Noise::new(3);
        for block in &mut knocking.blocks {
            block.velocities_mut().iter_mut().for_each(|u| *u = noise.vector::<f64, 2>() * 1e-3);
        }
        // Which finds the contact as well.
        let dt = factor * knocking.limit();
        let start = knocking.energy();
        knocking.advance(dt, 18_000).unwrap();
        knocking.energy() / start
    };
    let (short, usual) = (gain(0.4), gain(0.8));
    eprintln!("knocking: energy {short:.3} of that at the start at 0.4 times the limit, {usual:.3} at 0.8");
    assert!((0.8..1.05).contains(&short), "{short}");
    assert!(usual < 5.0, "{usual}");
}

fn state_after(threads: usize) -> Vec<u64> {
    let parallel = Parallel::new(threads).unwrap();
    let material = NeoHookean::new(1e6, 0.3).unwrap();
    let mut under = block(Vector::<f64, 3>::zeros(), [26, 4, 26], 0.1, material);
    let mut over = block(Vector::<f64, 3>::new(0.03, 0.41, 0.02), [26, 4, 26], 0.1, material);
    let speed = 0.05 * over.wave_speed();
    over.velocities_mut().fill(Vector::<f64, 3>::new(0.0, -speed, 0.3 * speed));
    let mut contact = contact(&[&under, &over]);
    let bodies: &mut [&mut dyn Elastic<f64, 3>] = &mut [&mut under, &mut over];
    for _ in 0..8 {
        let dt = contact.max_step(&parallel, bodies).unwrap();
        contact.advance(&parallel, bodies, none, &Vector::zeros(), dt, 1).unwrap();
    }
    assert!(contact.energy() > 0.0);
    let both = under.velocities().iter().chain(over.velocities());
    both.flat_map(|u| u.iter().map(|x| x.to_bits())).chain([contact.energy().to_bits()]).collect()
}

#[test]
fn same_bits_for_any_number_of_threads() {
    let serial = state_after(1);
    for threads in [2, 3, 8] {
        assert!(state_after(threads) == serial, "{threads} threads");
    }
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let serial = Parallel::serial();
    let material = CorotationalHooke::new(1e6, 0.3).unwrap();
    let mut one = block(V::zeros(), [8, 8], 0.1, material);
    let mut other = block(V::new(0.0, 0.7), [8, 8], 0.1, material);
    let mut contact = contact(&[&one, &other]);
    let bodies: &mut [&mut dyn Elastic<f64, 2>] = &mut [&mut one, &mut other];
    let dt = 1e-5;
    let result = contact.advance(&serial, bodies, none, &V::zeros(), dt, 1);
    let Err(error @ ContactError::Passed { body: 0, other: 1, .. }) = result else { panic!("{result:?}") };
    assert!(error.to_string().contains("nearest there: particle"), "{error}");
    let fewer = &mut bodies[..1];
    let result = contact.advance(&serial, fewer, none, &V::zeros(), dt, 1);
    assert_eq!(result, Err(ContactError::Bodies { got: 1, expected: 2 }));
    let result = contact.update(&serial, |_| &[]);
    assert!(matches!(result, Err(ContactError::Length { body: 0, name: "positions", .. })));
    for bad in [f64::NAN, -1.0, 2.0] {
        let config = ContactConfig { cfl: bad, ..ContactConfig::default() };
        assert!(matches!(Contact::<f64, 2>::new(config), Err(ContactError::Parameter { name: "cfl", .. })));
    }
}
