//! Bodies that fly at each other keep momenta and energy, and bounce as they should.

use crate::scene::{V, block, contact, kept, mean, none, ring, total};
use approx::assert_relative_eq;
use mps_kernel::Vector;
use mps_neighbors::Parallel;
use mps_solid::Solid;
use mps_solid::contact::Elastic;
use mps_solid::materials::{CorotationalHooke, NeoHookean};

struct Collision {
    restitution: f64,
    touched: f64,
    /// Largest change of the energy over the kinetic energy of the approach.
    swing: f64,
}

/// Two rings fly at each other with 0.059 times the speed of sound each, past the centres by `offset`.
fn rings(layers: usize, offset: f64, fraction: f64) -> Collision {
    let serial = Parallel::serial();
    let speed = 0.059 * (3.25e6_f64 / 1000.0).sqrt();
    let mut left = ring(V::new(-0.0405, -0.5 * offset), layers);
    let mut right = ring(V::new(0.0405, 0.5 * offset), layers);
    left.velocities_mut().fill(V::new(speed, 0.0));
    right.velocities_mut().fill(V::new(-speed, 0.0));
    let (momentum0, spin0) = kept(&[&left, &right]);
    let scale = speed * left.masses().iter().sum::<f64>();
    let mut contact = contact(&[&left, &right]);
    let energy0 = total(&[&left, &right], &contact);
    let step = fraction * {
        let bodies: [&mut dyn Elastic<f64, 2>; 2] = [&mut left, &mut right];
        contact.max_step(&serial, &bodies).unwrap()
    };
    let (mut touched, mut swing) = ([f64::MAX, 0.0], 0.0_f64);
    let rounds = (0.04 / (5.0 * step)).ceil() as usize;
    for round in 0..rounds {
        let bodies: &mut [&mut dyn Elastic<f64, 2>] = &mut [&mut left, &mut right];
        contact.advance(&serial, bodies, none, &V::zeros(), 5.0 * step, 5).unwrap();
        if contact.energy() > 0.0 {
            let now = round as f64 * 5.0 * step;
            touched = [touched[0].min(now), touched[1].max(now)];
        }
        swing = swing.max((total(&[&left, &right], &contact) / energy0 - 1.0).abs());
        let (momentum, spin) = kept(&[&left, &right]);
        assert!((momentum - momentum0).norm() < 1e-12 * scale, "momentum {momentum} at {round}");
        assert!((spin - spin0).norm() < 1e-12 * scale * 0.08, "spin {spin} at {round}");
    }
    assert_eq!(contact.energy(), 0.0, "still in contact");
    let closing = mean(left.velocities()) - mean(right.velocities());
    Collision { restitution: -closing.x / (2.0 * speed), touched: touched[1] - touched[0], swing }
}

#[test]
fn rings_bounce_and_keep_everything() {
    let coarse = rings(4, 0.0, 1.0);
    // Every particle that comes or goes has a kink in its force, at a random place of a step: the order needs a span.
    let fine = rings(4, 0.0, 0.0625);
    let order = (coarse.swing / fine.swing).log(16.0);
    let oblique = rings(4, 0.03, 1.0);
    eprintln!(
        "rings: restitution {:.3} ({:.3} with a sixteenth of the step), in contact for {:.2} ms, energy swing {:.1e} and {:.1e}, order {order:.2}; oblique: {:.3}, swing {:.1e}",
        coarse.restitution,
        fine.restitution,
        1e3 * coarse.touched,
        coarse.swing,
        fine.swing,
        oblique.restitution,
        oblique.swing,
    );
    assert!((0.3..1.0).contains(&coarse.restitution));
    assert_relative_eq!(coarse.restitution, fine.restitution, epsilon = 0.03);
    assert!(coarse.swing < 5e-3 && oblique.swing < 5e-3);
    assert!((1.5..3.5).contains(&order), "{order}");
}

/// Bars without Poisson's effect: the struck one takes over the velocity, after the time `2L/c`.
#[test]
fn bars_exchange_their_velocities() {
    let serial = Parallel::serial();
    for n in [20, 40] {
        let (l, e) = (1.0 / n as f64, 1e6);
        let material = CorotationalHooke::new(e, 0.0).unwrap();
        let mut left = block(V::zeros(), [n, 4], l, material);
        let mut right = block(V::new(1.0 + 0.01 * l, 0.0), [n, 4], l, material);
        let c = (e / 1000.0_f64).sqrt();
        let speed = 0.001 * c;
        left.velocities_mut().fill(V::new(speed, 0.0));
        let mut contact = contact(&[&left, &right]);
        let step = 0.5 * left.max_step(&serial);
        let (mut first, mut last) = (f64::MAX, 0.0_f64);
        while left.time() < 3.0 / c {
            let bodies: &mut [&mut dyn Elastic<f64, 2>] = &mut [&mut left, &mut right];
            contact.advance(&serial, bodies, none, &V::zeros(), step, 1).unwrap();
            if contact.energy() > 0.0 {
                (first, last) = (first.min(left.time()), last.max(left.time()));
            }
        }
        let (a, b) = (mean(left.velocities()).x / speed, mean(right.velocities()).x / speed);
        let internal = {
            let of = |s: &Solid<f64, 2, CorotationalHooke<f64>>| s.energy(&serial, &V::zeros()).total();
            let whole: f64 = left.masses().iter().sum();
            (of(&left) + of(&right)) / (0.5 * whole * speed * speed) - a * a - b * b
        };
        let duration = (last - first) * c / 2.0;
        eprintln!(
            "bars of {n}: velocities {a:.4} and {b:.4}, contact for {duration:.3} times 2L/c, vibration keeps {internal:.4}"
        );
        assert_relative_eq!(a + b, 1.0, epsilon = 1e-12);
        assert!(b > 0.97, "{b}");
        assert!((duration - 1.0).abs() < 0.1, "{duration}");
    }
}

/// Cubes that meet off their centres and turned.
#[test]
fn cubes_collide_and_keep_momenta_and_energy() {
    let serial = Parallel::serial();
    let l = 0.1;
    let material = NeoHookean::new(1e6, 0.3).unwrap();
    let mut left = block(Vector::<f64, 3>::zeros(), [6, 6, 6], l, material);
    let mut right = block(Vector::<f64, 3>::new(0.63, 0.22, -0.17), [6, 6, 6], l, material);
    let speed = 0.03 * left.wave_speed();
    left.velocities_mut().fill(Vector::<f64, 3>::new(speed, 0.1 * speed, 0.0));
    right.velocities_mut().fill(Vector::<f64, 3>::new(-speed, 0.0, 0.2 * speed));
    let (momentum0, spin0) = kept(&[&left, &right]);
    let scale = speed * left.masses().iter().sum::<f64>();
    let mut contact = contact(&[&left, &right]);
    let energy0 = total(&[&left, &right], &contact);
    let (mut swing, mut most) = (0.0_f64, 0.0_f64);
    for _ in 0..60 {
        let bodies: &mut [&mut dyn Elastic<f64, 3>] = &mut [&mut left, &mut right];
        let dt = contact.max_step(&serial, bodies).unwrap();
        contact.advance(&serial, bodies, none, &Vector::zeros(), 3.0 * dt, 3).unwrap();
        swing = swing.max((total(&[&left, &right], &contact) / energy0 - 1.0).abs());
        most = most.max(contact.energy() / energy0);
        let (momentum, spin) = kept(&[&left, &right]);
        assert!((momentum - momentum0).norm() < 1e-12 * scale, "{momentum}");
        assert!((spin - spin0).norm() < 1e-12 * scale, "{spin}");
    }
    eprintln!("cubes: energy swing {swing:.1e}, contact held {most:.2} of the energy");
    assert!(most > 0.01 && contact.energy() == 0.0, "{most} {}", contact.energy());
    assert!(swing < 0.02, "{swing}");
    assert!(left.momentum(&serial).x < 0.0);
}
