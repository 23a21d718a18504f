//! Bodies that are pressed together slide almost freely.

use crate::scene::{V, block, contact, mean, solid};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::contact::Elastic;
use mps_solid::materials::CorotationalHooke;
use mps_solid::{Solid, SolidConfig};

/// A block is pressed on a long one and slides over it: what it loses of its speed over the pressing force is the
/// friction that is left.
#[test]
fn sliding_is_nearly_free() {
    let serial = Parallel::serial();
    for (pressure, twist) in [(0.01, 0.0), (0.05, 0.0), (0.01, 0.1)] {
        let l = 0.1;
        let material = CorotationalHooke::new(1e6, 0.3).unwrap();
        let modulus = material.moduli.lambda + 2.0 * material.moduli.mu;
        let under = body::block(V::zeros(), V::new(8.0, 0.6), [80, 6], &[Face::lower(1)]).unwrap();
        let mut under = solid(under.particles, under.spacing, material, SolidConfig::default());
        let spacing = l * (1.0 + twist);
        let mut over = block(V::new(1.0, 0.6), [10, 6], spacing, material);
        let speed = 0.02 * over.wave_speed();
        let mut contact = contact(&[&under, &over]);
        // Pressed by a body force that grows slowly, to leave no bouncing.
        let push = pressure * modulus * 10.0 * spacing / over.len() as f64;
        let mut force = vec![V::zeros(); over.len()];
        let step = 0.5 * over.max_step(&serial);
        let settle = 6000;
        for k in 0..settle {
            let ramp = (2.0 * f64::from(k) / f64::from(settle)).min(1.0);
            force.fill(V::new(0.0, -push * ramp));
            let slow = |solid: &mut Solid<f64, 2, CorotationalHooke<f64>>| {
                solid.velocities_mut().iter_mut().for_each(|u| *u *= 0.995);
            };
            slow(&mut under);
            slow(&mut over);
            let bodies: &mut [&mut dyn Elastic<f64, 2>] = &mut [&mut under, &mut over];
            let external = |body| if body == 1 { &force[..] } else { &[] };
            contact.advance(&serial, bodies, external, &V::zeros(), step, 1).unwrap();
        }
        over.velocities_mut().iter_mut().for_each(|u| *u += V::new(speed, 0.0));
        let mass: f64 = over.masses().iter().sum();
        let (start, begin) = (over.momentum(&serial).x, mean(over.positions()).x);
        let time0 = over.time();
        while mean(over.positions()).x < begin + 30.0 * l {
            let bodies: &mut [&mut dyn Elastic<f64, 2>] = &mut [&mut under, &mut over];
            let external = |body| if body == 1 { &force[..] } else { &[] };
            contact.advance(&serial, bodies, external, &V::zeros(), step, 1).unwrap();
            assert!(over.time() < time0 + 100.0 * l / speed, "it got stuck");
        }
        let (lost, time) = (start - over.momentum(&serial).x, over.time() - time0);
        let friction = lost / (push * over.len() as f64 * time);
        let vibration = {
            let mean = mean(over.velocities());
            let of = |(u, m): (&V, &f64)| 0.5 * m * (u - mean).norm_squared();
            over.velocities().iter().zip(over.masses()).map(of).sum::<f64>() / (0.5 * mass * speed * speed)
        };
        eprintln!(
            "sliding 30 spacings at 0.02 c under {pressure} of the modulus, spacings {l} and {spacing:.3}: friction {friction:.2e}, speed lost {:.2e}, vibration {vibration:.2e} of the kinetic energy",
            lost / start
        );
        assert!(friction.abs() < 0.02, "{friction}");
    }
}
