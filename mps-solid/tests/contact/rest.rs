//! Bodies that lie on each other and bear what presses them together.

use crate::scene::{V, contact, none, ring_particles, rubber, solid};
use approx::assert_relative_eq;
use core::f64::consts::PI;
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::contact::Elastic;
use mps_solid::materials::CorotationalHooke;
use mps_solid::{Placement, Solid, SolidConfig, SolidParticles};

/// A heavy block on a supported one: the weight is borne, the gap in the middle is that of the drawing less the overlap at
/// this pressure. With spacings that differ by a factor of two the coarse body pushes the second row of the fine one as
/// well, and the overlap is smaller by up to a fifth. Along the rim of a contact, as wide as the reach of its field, particles
/// see only a part of the other body and bear less: four coarse particles across are nearly all rim, and
/// sink by half as much again.
#[test]
fn a_block_rests_on_another() {
    let serial = Parallel::serial();
    let narrow = [(0.8, 0.1, 0.95..1.03), (0.8, 0.2, 1.3..1.6), (0.8, 0.05, 0.8..1.0)];
    let wide = [(1.6, 0.1, 0.95..1.03), (1.6, 0.2, 0.8..1.03), (1.6, 0.05, 0.8..1.03)];
    for (width, l_upper, allowed) in narrow.into_iter().chain(wide) {
        let config = SolidConfig { damping: 8.0, ..SolidConfig::default() };
        let material = CorotationalHooke::new(1e6, 0.0).unwrap();
        let under = body::block(
            V::new(0.4, 0.05),
            V::new(0.4 + width, 0.8),
            [(10.0 * width) as usize, 8],
            &[Face::lower(1)],
        )
        .unwrap();
        let l_under = under.spacing.y;
        let mut under = solid(under.particles, under.spacing, material, config);
        let (lower, upper) = (V::new(0.4, 0.8), V::new(0.4 + width, 1.6));
        let counts = [width, 0.8].map(|length: f64| (length / l_upper).round() as usize);
        let over = body::block(lower, upper, counts, &[]).unwrap();
        let mut over = solid(over.particles, over.spacing, material, config);
        let mut contact = contact(&[&under, &over]);
        let gravity = V::new(0.0, -10.0);
        let bodies: &mut [&mut dyn Elastic<f64, 2>] = &mut [&mut under, &mut over];
        for _ in 0..60 {
            let dt = contact.max_step(&serial, bodies).unwrap();
            contact.advance(&serial, bodies, none, &gravity, 60.0 * dt, 60).unwrap();
        }
        let weight = 1000.0 * 0.8 * width * 10.0;
        let borne: f64 = contact.forces(1).iter().map(|f| f.y).sum();
        // In the middle of the contact.
        let row = |solid: &Solid<f64, 2, CorotationalHooke<f64>>, wanted: f64| {
            let x0 = solid.particles().reference_positions();
            let rows = solid.positions().iter().zip(x0);
            let inner: Vec<_> = rows
                .filter(|(_, x0)| {
                    (x0.y - wanted).abs() < 0.3 * solid.spacing().y && (x0.x - 0.4 - 0.5 * width).abs() < 0.21
                })
                .map(|(x, _)| x.y)
                .collect();
            inner.iter().sum::<f64>() / inner.len() as f64
        };
        let gap = row(&over, 0.8 + 0.5 * l_upper) - row(&under, 0.8 - 0.5 * l_under);
        let overlap = 0.5 * (l_under + l_upper) - gap;
        let expected = weight / width / contact.stiffness(0, 1).unwrap();
        eprintln!(
            "rest, width {width}, spacings {l_under:.3} and {l_upper}: borne {:.5}, overlap {:.4} spacings, {:.3} of p/K, deepest {:.3}",
            borne / weight,
            overlap / l_under,
            overlap / expected,
            contact.overlap(0, 1) / expected
        );
        // Gravity is damped with the velocity it makes in a sub-step, contact is not: c dt/4.
        assert_relative_eq!(borne, weight, max_relative = 5e-3);
        assert!(allowed.contains(&(overlap / expected)), "{overlap} instead of {expected}");
    }
}

/// A ring between two plates that close until its inner sides meet: it bears them and does not pass through itself.
#[test]
fn a_ring_squeezed_flat_does_not_pass_through_itself() {
    let serial = Parallel::serial();
    let (l, layers) = (0.0025, 3);
    let number = (2.0 * PI * 0.03625 / l).round() as usize;
    let config = SolidConfig { damping: 60.0, ..SolidConfig::default() };
    let particles = ring_particles(V::zeros(), [0.0325, 0.04], layers, number);
    let mut ring = solid(particles, V::repeat(l), rubber(), config);
    let plate = |y: f64| {
        let mut particles = SolidParticles::new();
        for k in 0..72 {
            for row in 0..2 {
                let x = V::new(l * (f64::from(k) - 35.5), y + l * (f64::from(row) - 0.5));
                particles.push(x, l * l, true);
            }
        }
        solid(particles, V::repeat(l), rubber(), config)
    };
    // From a free gap of a tenth of a spacing to a little less than four walls of three layers would need undeformed.
    let (start, end) = (0.04 + 1.1 * l, 0.0075 + 0.4 * l);
    let (mut above, mut below) = (plate(start), plate(-start));
    let time = 0.08;
    let closed = move |t: f64| (start - end) * 0.5 * (1.0 - (PI * (t / time).min(1.0)).cos());
    above.move_supports(|_| true, move |t| Placement::shifted(V::new(0.0, -closed(t)))).unwrap();
    below.move_supports(|_| true, move |t| Placement::shifted(V::new(0.0, closed(t)))).unwrap();
    let mut contact = contact(&[&ring, &above, &below]);
    let mut met = 0.0;
    while ring.time() < 1.1 * time {
        let bodies: &mut [&mut dyn Elastic<f64, 2>] = &mut [&mut ring, &mut above, &mut below];
        let dt = contact.max_step(&serial, bodies).unwrap();
        contact.advance(&serial, bodies, none, &V::zeros(), 10.0 * dt, 10).unwrap();
        if met == 0.0 && contact.overlap(0, 0) > 0.0 {
            met = ring.time();
        }
    }
    // Particles of the inner layer in the middle.
    let inner = ring.positions().chunks(layers).map(|across| across[0]).filter(|x| x.x.abs() < 2.0 * l);
    let (up, down): (Vec<V>, Vec<V>) = inner.partition(|x| x.y > 0.0);
    let lowest = up.iter().map(|x| x.y).fold(f64::MAX, f64::min);
    let highest = down.iter().map(|x| x.y).fold(f64::MIN, f64::max);
    let gap = (lowest - highest) / l;
    let bears: f64 = contact.forces(1).iter().map(|f| f.y).sum();
    eprintln!(
        "squeezed ring: sides met at {:.2} of the motion, gap {gap:.3} spacings, overlap with itself {:.3}, with the plate {:.3} spacings, plate bears {bears:.0} N/m",
        met / time,
        contact.overlap(0, 0) / l,
        contact.overlap(0, 1) / l
    );
    assert!(met > 0.0 && up.len() > 2 && down.len() > 2, "{} above, {} below", up.len(), down.len());
    assert!((0.6..1.05).contains(&gap), "{gap}");
    let below: f64 = contact.forces(2).iter().map(|f| f.y).sum();
    assert!(bears > 0.0);
    assert_relative_eq!(bears, -below, max_relative = 0.05);
}
