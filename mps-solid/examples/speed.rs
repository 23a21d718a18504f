//! Particle-substeps per second of a strip of 4 by 63 particles on one thread, for each material.
//!
//! `cargo run --release -p mps-solid --example speed`
#![allow(clippy::print_stdout)]

use mps_kernel::{Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::materials::{CorotationalHooke, NearlyIncompressible, NeoHookean, SaintVenantKirchhoff};
use mps_solid::{ConstitutiveModel, Solid, SolidConfig};
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let (e, nu) = (7.8e6, 0.47);
    strip(CorotationalHooke::new(e, nu)?)?;
    strip(SaintVenantKirchhoff::new(e, nu)?)?;
    strip(NeoHookean::new(e, nu)?)?;
    strip(NearlyIncompressible::new(e, nu)?)?;
    beam(CorotationalHooke::new(e, nu)?)?;
    beam(SaintVenantKirchhoff::new(e, nu)?)?;
    beam(NearlyIncompressible::new(e, nu)?)?;
    Ok(())
}

fn strip<M: ConstitutiveModel<f64, 2>>(material: M) -> Result<(), Box<dyn Error>> {
    let clamp = [Face::lower(0)];
    let gate = body::block(Vector::zeros(), Vector::<f64, 2>::new(0.079, 0.005), [63, 4], &clamp)?;
    measure(gate, material, Vector::<f64, 2>::new(0.0, -9.81))
}

fn beam<M: ConstitutiveModel<f64, 3>>(material: M) -> Result<(), Box<dyn Error>> {
    let clamp = [Face::lower(0)];
    let upper = Vector::<f64, 3>::new(0.079, 0.005, 0.005);
    let gate = body::block(Vector::zeros(), upper, [63, 4, 4], &clamp)?;
    measure(gate, material, Vector::<f64, 3>::new(0.0, -9.81, 0.0))
}

fn measure<const D: usize, M: ConstitutiveModel<f64, D>>(
    body: body::Body<f64, D>,
    material: M,
    gravity: Vector<f64, D>,
) -> Result<(), Box<dyn Error>> {
    let parallel = Parallel::serial();
    let name = material.name();
    let config = SolidConfig::default();
    let mut solid =
        Solid::new(body.particles, body.spacing, 1100.0, material, WendlandC2, config, &parallel)?;
    let no_load = vec![Vector::zeros(); solid.len()];
    let dt = solid.max_step(&parallel);
    let rounds = std::env::args().nth(1).and_then(|a| a.parse().ok()).unwrap_or(20);
    let substeps = 1000;
    let mut best = f64::INFINITY;
    for _ in 0..rounds {
        let clock = Instant::now();
        solid.advance(&parallel, &no_load, &gravity, dt * substeps as f64, substeps)?;
        best = best.min(clock.elapsed().as_secs_f64());
    }
    let rate = (solid.len() * substeps) as f64 / best * 1e-6;
    println!("{D}D, {} particles, {name}: {rate:.1} million particle-substeps per second", solid.len());
    Ok(())
}
