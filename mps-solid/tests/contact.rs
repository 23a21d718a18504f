//! Contact of bodies with each other and with themselves.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use approx::assert_relative_eq;
use common::Noise;
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Real, Tensor, Vector};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::contact::{Contact, ContactConfig, ContactError, Elastic};
use mps_solid::materials::{CorotationalHooke, Moduli, NeoHookean};
use mps_solid::{ConstitutiveModel, Placement, Solid, SolidConfig, SolidParticles};
use std::f64::consts::PI;

type V = Vector<f64, 2>;

fn solid<T: Real, const D: usize, M: ConstitutiveModel<T, D>>(
    particles: SolidParticles<T, D>,
    spacing: Vector<T, D>,
    material: M,
    config: SolidConfig<T>,
) -> Solid<T, D, M> {
    let serial = Parallel::serial();
    Solid::new(particles, spacing, T::of(1000.0), material, WendlandC2, config, &serial).unwrap()
}

/// A block of `counts` particles `l` apart from the corner `lower`.
fn block<const D: usize, M: ConstitutiveModel<f64, D>>(
    lower: Vector<f64, D>,
    counts: [usize; D],
    l: f64,
    material: M,
) -> Solid<f64, D, M> {
    let upper = lower + Vector::from_fn(|axis, _| l * counts[axis] as f64);
    let block = body::block(lower, upper, counts, &[]).unwrap();
    solid(block.particles, block.spacing, material, SolidConfig::default())
}

/// The rubber of the rings of Swegle: K = 3.25 MPa, G = 0.715 MPa.
fn rubber() -> NeoHookean<f64> {
    NeoHookean { moduli: Moduli::from_bulk_and_shear(3.25e6, 0.715e6).unwrap() }
}

/// A ring of layers of particles, `number` in each; its volumes add up to its area.
fn ring_particles(center: V, radii: [f64; 2], layers: usize, number: usize) -> SolidParticles<f64, 2> {
    let mut particles = SolidParticles::new();
    let width = (radii[1] - radii[0]) / layers as f64;
    for k in 0..number {
        // Not the same on the left and the right, above and below.
        let angle = 2.0 * PI * (k as f64 + 0.3) / number as f64;
        for layer in 0..layers {
            let r = radii[0] + width * (layer as f64 + 0.5);
            let place = center + V::new(angle.cos(), angle.sin()) * r;
            particles.push(place, 2.0 * PI * r * width / number as f64, false);
        }
    }
    particles
}

fn ring(center: V, layers: usize) -> Solid<f64, 2, NeoHookean<f64>> {
    let l = 0.01 / layers as f64;
    let number = (2.0 * PI * 0.035 / l).round() as usize;
    let particles = ring_particles(center, [0.03, 0.04], layers, number);
    let area: f64 = particles.volumes().iter().sum();
    assert_relative_eq!(area, PI * (0.04 * 0.04 - 0.03 * 0.03), max_relative = 1e-12);
    solid(particles, V::repeat(l), rubber(), SolidConfig::default())
}

fn contact<T: Real, const D: usize>(bodies: &[&dyn Elastic<T, D>]) -> Contact<T, D> {
    let mut contact = Contact::new(ContactConfig::default()).unwrap();
    for (number, body) in bodies.iter().enumerate() {
        assert_eq!(contact.add(&body.shape()).unwrap(), number);
    }
    contact
}

fn none<'a, const D: usize>(_: usize) -> &'a [Vector<f64, D>] {
    &[]
}

fn kept<const D: usize, M: ConstitutiveModel<f64, D>>(
    bodies: &[&Solid<f64, D, M>],
) -> (Vector<f64, D>, Tensor<f64, D>) {
    let serial = Parallel::serial();
    let momentum = bodies.iter().map(|body| body.momentum(&serial)).sum();
    let spin = bodies.iter().map(|body| body.angular_momentum(&serial, &Vector::zeros())).sum();
    (momentum, spin)
}

fn total<const D: usize, M: ConstitutiveModel<f64, D>>(
    bodies: &[&Solid<f64, D, M>],
    contact: &Contact<f64, D>,
) -> f64 {
    let of = |body: &&Solid<f64, D, M>| body.energy(&Parallel::serial(), &Vector::zeros()).total();
    bodies.iter().map(of).sum::<f64>() + contact.energy()
}

fn mean(vectors: &[V]) -> V {
    vectors.iter().sum::<V>() / vectors.len() as f64
}

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

/// A heavy block on a supported one: the weight is borne, the gap is that of the drawing less the overlap at this
/// pressure. With spacings that differ by a factor of two the rows give way in between, by up to 0.6 more.
#[test]
fn a_block_rests_on_another() {
    let serial = Parallel::serial();
    for (l_upper, bound) in [(0.1, 0.03), (0.2, 0.6), (0.05, 0.6)] {
        let config = SolidConfig { damping: 8.0, ..SolidConfig::default() };
        let material = CorotationalHooke::new(1e6, 0.0).unwrap();
        let under = body::block(V::new(0.4, 0.05), V::new(1.2, 0.8), [8, 8], &[Face::lower(1)]).unwrap();
        let l_under = under.spacing.y;
        let mut under = solid(under.particles, under.spacing, material, config);
        let (lower, upper) = (V::new(0.4, 0.8), V::new(1.2, 1.6));
        let n = (0.8_f64 / l_upper).round() as usize;
        let over = body::block(lower, upper, [n, n], &[]).unwrap();
        let mut over = solid(over.particles, over.spacing, material, config);
        let mut contact = contact(&[&under, &over]);
        let gravity = V::new(0.0, -10.0);
        let bodies: &mut [&mut dyn Elastic<f64, 2>] = &mut [&mut under, &mut over];
        for _ in 0..60 {
            let dt = contact.max_step(&serial, bodies).unwrap();
            contact.advance(&serial, bodies, none, &gravity, 60.0 * dt, 60).unwrap();
        }
        let weight = 1000.0 * 0.64 * 10.0;
        let borne: f64 = contact.forces(1).iter().map(|f| f.y).sum();
        // In the middle of the contact.
        let row = |solid: &Solid<f64, 2, CorotationalHooke<f64>>, wanted: f64| {
            let x0 = solid.particles().reference_positions();
            let rows = solid.positions().iter().zip(x0);
            let inner: Vec<_> = rows
                .filter(|(_, x0)| {
                    (x0.y - wanted).abs() < 0.3 * solid.spacing().y && (x0.x - 0.8).abs() < 0.21
                })
                .map(|(x, _)| x.y)
                .collect();
            inner.iter().sum::<f64>() / inner.len() as f64
        };
        let gap = row(&over, 0.8 + 0.5 * l_upper) - row(&under, 0.8 - 0.5 * l_under);
        let overlap = 0.5 * (l_under + l_upper) - gap;
        let expected = weight / 0.8 / contact.stiffness(0, 1).unwrap();
        eprintln!(
            "rest, spacings {l_under:.3} and {l_upper}: borne {:.5}, overlap {:.4} spacings, {:.3} of p/K, deepest {:.3}",
            borne / weight,
            overlap / l_under,
            overlap / expected,
            contact.overlap(0, 1) / expected
        );
        // Gravity is damped with the velocity it makes in a sub-step, contact is not: c dt/4.
        assert_relative_eq!(borne, weight, max_relative = 5e-3);
        assert!((overlap / expected - 1.0).abs() < bound, "{overlap} instead of {expected}");
    }
}

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

/// At the limit that is given, with both safety factors at 1, two blocks that are pressed together keep their energy.
#[test]
fn the_stability_limit_is_respected() {
    let serial = Parallel::serial();
    for nu in [0.0, 0.3, 0.45] {
        let material = CorotationalHooke::new(1e6, nu).unwrap();
        let pressed = |factor: f64| {
            // Held at their outer faces, with an overlap that the vibration does not open.
            let build = |y: f64, face: Face| {
                let part = body::block(V::new(0.0, y), V::new(0.8, y + 0.35), [8, 4], &[face]).unwrap();
                let config = SolidConfig { cfl: 1.0, ..SolidConfig::default() };
                let mut part = solid(part.particles, part.spacing, material, config);
                let mut noise = Noise::new(3);
                part.velocities_mut().iter_mut().for_each(|u| *u = noise.vector::<f64, 2>() * 1e-3);
                part
            };
            let (mut under, mut over) = (build(0.0, Face::lower(1)), build(0.348, Face::upper(1)));
            let config = ContactConfig { cfl: 1.0, ..ContactConfig::default() };
            let mut contact = Contact::new(config).unwrap();
            contact.add(&under.shape()).unwrap();
            contact.add(&over.shape()).unwrap();
            let bodies: &mut [&mut dyn Elastic<f64, 2>] = &mut [&mut under, &mut over];
            let dt = factor * contact.max_step(&serial, bodies).unwrap();
            contact.advance(&serial, bodies, none, &V::zeros(), 3000.0 * dt, 3000).is_ok()
                && under.velocities().iter().chain(over.velocities()).all(|u| u.norm() < 1.0)
        };
        let border = (0..60).map(|k| 1.0 + 0.01 * f64::from(k)).find(|&factor| !pressed(factor));
        eprintln!("nu = {nu}: unstable from {border:?} times the limit");
        assert!(pressed(0.98) && border.is_none_or(|border| border > 1.0));
    }
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
