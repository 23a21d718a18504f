//! A body that meets itself: where there is a gap in it, and nowhere else.

use crate::scene::{V, block, contact, rubber, solid};
use mps_kernel::{Tensor, Vector};
use mps_neighbors::Parallel;
use mps_solid::SolidConfig;
use mps_solid::SolidParticles;
use mps_solid::contact::Elastic;
use mps_solid::materials::NeoHookean;

const ARM: usize = 20;

/// A U on its side: two arms of three rows with a slot of `slot` spacings between their surfaces, and a foot that
/// joins them. The first particles are the facing rows, lower and upper in turn, from the foot on.
pub(crate) fn slotted(slot: f64) -> SolidParticles<f64, 2> {
    let mut particles = SolidParticles::new();
    let across = 1.0 + slot;
    for row in 0..3 {
        for k in 0..ARM {
            let (x, y) = (k as f64, f64::from(row));
            particles.push(V::new(x, -y), 1.0, false);
            particles.push(V::new(x, across + y), 1.0, false);
        }
    }
    let rows = (across + 5.0).round();
    for column in 1..=3 {
        for row in 0..rows as usize {
            let l = (across + 4.0) / (rows - 1.0);
            particles.push(V::new(-f64::from(column), l * row as f64 - 2.0), l, false);
        }
    }
    particles
}

#[test]
fn the_sides_of_a_narrow_slot_bear_each_other() {
    let serial = Parallel::serial();
    for (slot, pressure) in [(0.9, 0.01), (0.9, 0.05), (1.5, 0.02), (1.5, 0.05), (3.0, 0.03)] {
        let config = SolidConfig { damping: 60.0, ..SolidConfig::default() };
        let mut body = solid(slotted(slot), V::repeat(1.0), rubber(), config);
        let modulus = body.shape().modulus;
        let (foot, mut force) = (6 * ARM, vec![V::zeros(); body.len()]);
        let mut contact = contact(&[&body]);
        let rounds = 150;
        for round in 0..rounds {
            let push = pressure * modulus * (2.0 * f64::from(round) / f64::from(rounds)).min(1.0);
            for k in 0..ARM {
                force[foot - 2 - 2 * k] = V::new(0.0, push);
                force[foot - 1 - 2 * k] = V::new(0.0, -push);
            }
            let bodies: &mut [&mut dyn Elastic<f64, 2>] = &mut [&mut body];
            let dt = contact.max_step(&serial, bodies).unwrap();
            contact.advance(&serial, bodies, |_| &force, &V::zeros(), 20.0 * dt, 20).unwrap();
        }
        let x = body.positions();
        let apart: Vec<f64> = (0..ARM).map(|k| x[2 * k + 1].y - x[2 * k].y).collect();
        let least = apart.iter().copied().fold(f64::MAX, f64::min);
        eprintln!("slot {slot} under {pressure} of the modulus: apart {least:.3}, {apart:.2?}");
        assert!(contact.overlap(0, 0) > 0.0, "they meet");
        assert!(least > 0.5, "{least}");
    }
}

/// A body whose particles keep their neighbours has nothing to meet, however strongly it is strained.
#[test]
fn a_strained_body_does_not_meet_itself() {
    let serial = Parallel::serial();
    let material = NeoHookean::new(1e6, 0.3).unwrap();
    let plane = [
        [[3.0, 0.0], [0.0, 1.0 / 3.0]],
        [[4.0, 0.0], [0.0, 0.25]],
        [[1.0, 0.0], [0.0, 0.35]],
        [[0.3, 0.0], [0.0, 1.0]],
        [[1.0, 3.0], [0.0, 1.0]],
        [[0.4, 0.0], [0.0, 0.4]],
    ];
    for counts in [[12, 12], [20, 3], [30, 6], [20, 5]] {
        let body = block(V::zeros(), counts, 0.1, material);
        let mut contact = contact(&[&body]);
        for f in plane {
            let f = Tensor::<f64, 2>::new(f[0][0], f[0][1], f[1][0], f[1][1]);
            let places: Vec<V> = body.positions().iter().map(|x| f * x).collect();
            contact.update(&serial, |_| &places).unwrap();
            assert_eq!(contact.energy(), 0.0, "{counts:?} {f}");
        }
    }
    let thin = 1.0 / 3.0_f64.sqrt();
    let space = [[0.5, 0.5, 0.5], [3.0, thin, thin], [4.0, 0.5, 0.5], [1.0, 1.0, 0.35], [1.0, 0.3, 1.0]];
    for counts in [[8, 8, 8], [10, 10, 3]] {
        let body = block(Vector::<f64, 3>::zeros(), counts, 0.1, material);
        let mut contact = contact(&[&body]);
        for stretch in space {
            let stretch = Vector::from(stretch);
            let places: Vec<_> = body.positions().iter().map(|x| x.component_mul(&stretch)).collect();
            contact.update(&serial, |_| &places).unwrap();
            assert_eq!(contact.energy(), 0.0, "{counts:?} {stretch}");
        }
        let mut shear = Tensor::<f64, 3>::identity();
        shear[(0, 1)] = 3.0;
        let places: Vec<_> = body.positions().iter().map(|x| shear * x).collect();
        contact.update(&serial, |_| &places).unwrap();
        assert_eq!(contact.energy(), 0.0, "{counts:?} {shear}");
    }
}

/// A bar that was bent into a ring is joined by nothing where its ends meet.
#[test]
fn the_ends_of_a_bar_meet_when_it_is_bent() {
    let serial = Parallel::serial();
    let mut bar = block(V::zeros(), [40, 3], 0.1, NeoHookean::new(1e6, 0.3).unwrap());
    let radius = 3.98 / core::f64::consts::TAU;
    for x in bar.positions_mut() {
        let (s, r) = (x.x / radius, radius + 0.15 - x.y);
        *x = V::new(r * s.sin(), -r * s.cos());
    }
    let mut contact = contact(&[&bar]);
    contact.update(&serial, |_| bar.positions()).unwrap();
    assert!(contact.overlap(0, 0) > 0.0);
}
