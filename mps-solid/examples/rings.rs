//! Two rubber rings that collide: the history of their velocities and energies.
//!
//! `cargo run --release -p mps-solid --example rings -- [layers] [offset in m]`
#![allow(clippy::print_stdout)]

use mps_kernel::{Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::contact::{Contact, ContactConfig, Elastic};
use mps_solid::materials::{Moduli, NeoHookean};
use mps_solid::{Solid, SolidConfig, SolidParticles};
use std::error::Error;
use std::f64::consts::PI;

type V = Vector<f64, 2>;
type Ring = Solid<f64, 2, NeoHookean<f64>>;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let layers = arguments.next().map_or(Ok(5), |a| a.parse())?;
    let offset = arguments.next().map_or(Ok(0.0), |a| a.parse())?;
    let parallel = Parallel::all_cores()?;
    let sound = (3.25e6_f64 / 1000.0).sqrt();
    let speed = 0.059 * sound;
    let mut left = ring(V::new(-0.041, -0.5 * offset), layers, &parallel)?;
    let mut right = ring(V::new(0.041, 0.5 * offset), layers, &parallel)?;
    left.velocities_mut().fill(V::new(speed, 0.0));
    right.velocities_mut().fill(V::new(-speed, 0.0));
    let mut contact = Contact::new(ContactConfig::default())?;
    contact.add(&left.shape())?;
    contact.add(&right.shape())?;
    println!("time [ms], velocity of the left ring over the first, kinetic, elastic, contact, total - 1");
    let mass: f64 = left.masses().iter().sum();
    let begin = mass * speed * speed;
    let time = 0.03;
    for _ in 0..=30 {
        let (kinetic, elastic) = [&left, &right].iter().fold((0.0, 0.0), |(kinetic, elastic), ring| {
            let energy = ring.energy(&parallel, &V::zeros());
            (kinetic + energy.kinetic / begin, elastic + (energy.strain + energy.bending) / begin)
        });
        let touch = contact.energy() / begin;
        println!(
            "{:5.1} {:7.4} {kinetic:.4} {elastic:.4} {touch:.4} {:9.1e}",
            1e3 * left.time(),
            left.momentum(&parallel).x / (mass * speed),
            kinetic + elastic + touch - 1.0
        );
        let bodies: &mut [&mut dyn Elastic<f64, 2>] = &mut [&mut left, &mut right];
        // Rings that are about to meet need shorter sub-steps: asked for again every tenth of a round.
        for _ in 0..10 {
            let span = time / 300.0;
            let substeps = (span / contact.max_step(&parallel, bodies)?).ceil().max(1.0) as usize;
            contact.advance(&parallel, bodies, |_| &[], &V::zeros(), span, substeps)?;
        }
    }
    Ok(())
}

/// Layers of equally many particles; the volumes add up to the area.
fn ring(center: V, layers: usize, parallel: &Parallel) -> Result<Ring, Box<dyn Error>> {
    let (inner, outer) = (0.03, 0.04);
    let l = (outer - inner) / layers as f64;
    let number = (PI * (inner + outer) / l).round() as usize;
    let mut particles = SolidParticles::new();
    for k in 0..number {
        let angle = 2.0 * PI * k as f64 / number as f64;
        for layer in 0..layers {
            let r = inner + l * (layer as f64 + 0.5);
            let place = center + V::new(angle.cos(), angle.sin()) * r;
            particles.push(place, 2.0 * PI * r * l / number as f64, false);
        }
    }
    let rubber = NeoHookean { moduli: Moduli::from_bulk_and_shear(3.25e6, 0.715e6)? };
    let config = SolidConfig::default();
    Ok(Solid::new(particles, V::repeat(l), 1000.0, rubber, WendlandC2, config, parallel)?)
}
