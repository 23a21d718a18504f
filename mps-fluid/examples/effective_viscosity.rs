//! How viscous a fluid really is: Taylor-Green vortices, viscosity found over viscosity given.
//!
//! `cargo run --release -p mps-fluid --example effective_viscosity -- [particles per side]`
#![allow(clippy::print_stdout, reason = "a program talks to its user")]

use core::f64::consts::PI;
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidError, FluidParticles};
use mps_fluid::{CompactViscosity, LaminarViscosity, Viscosity};
use mps_fluid::{Diffusion, PressureForm, Shifting, Tension};
use mps_kernel::weights::{WendlandC2, WendlandGradient};
use mps_kernel::{Kernel, ReferenceDensity, Vector};
use mps_neighbors::{Parallel, PeriodicBox};

/// Density \[kg/m^3\].
const RHO: f64 = 1000.0;
/// Wave number of the vortices in a unit square.
const K: f64 = 2.0 * PI;

/// One row of the table, in units of length `L`, speed `U` and `rho U^2`.
#[derive(Clone, Copy)]
struct Numerics {
    radius: f64,
    corrected: bool,
    shifting: f64,
    level: f64,
    diffusion: f64,
    sound: f64,
    relaxation: f64,
}

/// Mean viscosity over the one given in each of four half units of time.
fn found<W: Kernel<f64>, V: Viscosity<f64, 2>>(
    weight: W,
    viscosity: impl FnOnce(f64, &ReferenceDensity<f64>) -> V,
    numerics: Numerics,
    n: usize,
    re: f64,
) -> Result<Vec<f64>, FluidError> {
    let l0 = 1.0 / n as f64;
    let mut config = FluidConfig::<f64, 2>::water(l0, numerics.sound);
    config.radius_ratio = numerics.radius;
    config.collisions = None;
    config.tension = Tension::Keep;
    config.background_pressure = numerics.level * RHO;
    config.diffusion = Diffusion::Filter { delta: numerics.diffusion };
    if numerics.corrected {
        config.pressure_form = PressureForm::Corrected;
    }
    let shifting = Shifting { strength: numerics.shifting, iterations: 1 };
    config.shifting = (numerics.shifting > 0.0).then_some(shifting);
    let place = |k: usize| (k as f64 + 0.5) * l0;
    let mut particles =
        FluidParticles::at_rest((0..n * n).map(|k| Vector::from([place(k % n), place(k / n)])).collect());
    for (u, r) in particles.velocity.iter_mut().zip(&particles.position) {
        *u = Vector::from([-(K * r.x).cos() * (K * r.y).sin(), (K * r.x).sin() * (K * r.y).cos()]);
    }
    let domain = PeriodicBox::new(Vector::zeros(), [Some(1.0); 2])?;
    config.density_relaxation = numerics.relaxation;
    let viscosity = |reference: &_| viscosity(1.0 / re, reference);
    let mut fluid = Fluid::new(config, weight, viscosity, domain, particles, Boundary::default())?;
    let parallel = Parallel::serial();
    let exact = 2.0 * K * K / re;
    let start = fluid.energy(&parallel).kinetic;
    let (mut rates, mut last) = (Vec::new(), [0.0, 0.0]);
    while rates.len() < 4 {
        fluid.step(&parallel)?;
        if fluid.time() >= 0.5 * (rates.len() + 1) as f64 {
            let now = [fluid.time(), -0.5 * (fluid.energy(&parallel).kinetic / start).ln()];
            rates.push((now[1] - last[1]) / (now[0] - last[0]) / exact);
            last = now;
        }
    }
    Ok(rates)
}

fn main() {
    let n = std::env::args().nth(1).and_then(|n| n.parse().ok()).unwrap_or(50);
    println!(
        "| weight, radius, viscosity, form, shifting, level, diffusion, c, relaxation | Re | viscosity found over given |\n|---|---|---|"
    );
    let channel = Numerics {
        radius: 3.0,
        corrected: true,
        shifting: 2.0,
        level: 2.0,
        diffusion: 0.5,
        sound: 10.0,
        relaxation: 0.01,
    };
    for re in [100.0, 1000.0] {
        let row = |numerics: Numerics| {
            let found = found(WendlandGradient, CompactViscosity::new::<2>, numerics, n, re);
            print("WendlandGradient", "compact", numerics, re, found);
        };
        row(channel);
        for numerics in [
            Numerics { radius: 4.0, ..channel },
            Numerics { relaxation: 0.0, ..channel },
            Numerics { relaxation: 0.03, ..channel },
            Numerics { shifting: 10.0, ..channel },
            Numerics { level: 0.0, ..channel },
            Numerics { level: 5.0, ..channel },
            Numerics { diffusion: 0.1, ..channel },
            Numerics { sound: 20.0, ..channel },
        ] {
            row(numerics);
        }
        for numerics in [channel, Numerics { corrected: false, shifting: 0.0, relaxation: 0.0, ..channel }] {
            let found = found(WendlandGradient, LaminarViscosity::new::<2>, numerics, n, re);
            print("WendlandGradient", "laminar", numerics, re, found);
        }
        for numerics in [channel, Numerics { shifting: 10.0, level: 0.0, relaxation: 0.0, ..channel }] {
            let found = found(WendlandC2, LaminarViscosity::new::<2>, numerics, n, re);
            print("WendlandC2", "laminar", numerics, re, found);
        }
    }
}

fn print(weight: &str, viscosity: &str, numerics: Numerics, re: f64, found: Result<Vec<f64>, FluidError>) {
    let Numerics { radius, corrected, shifting, level, diffusion, sound, relaxation } = numerics;
    let form = if corrected { "corrected" } else { "plain" };
    let values = match found {
        Ok(rates) => rates.iter().map(|rate| format!("{rate:.2}")).collect::<Vec<_>>().join(", "),
        Err(error) => error.to_string(),
    };
    println!(
        "| {weight}, {radius}, {viscosity}, {form}, {shifting}, {level}, {diffusion}, {sound}, {relaxation} | {re} | {values} |"
    );
}
