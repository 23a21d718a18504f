//! How viscous a fluid really is: Taylor-Green vortices, viscosity found over viscosity given.
//!
//! `cargo run --release -p mps-fluid --example effective_viscosity -- [particles per side]`
#![allow(clippy::print_stdout, reason = "a program talks to its user")]

use core::f64::consts::PI;
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidError, FluidParticles};
use mps_fluid::{Diffusion, LaminarViscosity, PressureForm, Shifting, Tension};
use mps_kernel::weights::{WendlandC2, WendlandGradient};
use mps_kernel::{Kernel, Vector};
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
}

/// Mean viscosity over the one given in each of four half units of time.
fn found<W: Kernel<f64>>(weight: W, numerics: Numerics, n: usize, re: f64) -> Result<Vec<f64>, FluidError> {
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
    let viscosity = |reference: &_| LaminarViscosity::new::<2>(1.0 / re, reference);
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
    let plain =
        Numerics { radius: 4.0, corrected: false, shifting: 0.0, level: 2.0, diffusion: 0.5, sound: 10.0 };
    let corrected = Numerics { corrected: true, shifting: 2.0, ..plain };
    println!(
        "| weight, radius, form, shifting, level, diffusion, c | Re | viscosity found over given |\n|---|---|---|"
    );
    for re in [100.0, 1000.0] {
        for numerics in [
            plain,
            Numerics { radius: 3.0, ..plain },
            Numerics { level: 1.0, ..plain },
            Numerics { level: 5.0, ..plain },
            Numerics { diffusion: 0.1, ..plain },
            Numerics { sound: 20.0, ..plain },
            Numerics { shifting: 2.0, ..plain },
            corrected,
        ] {
            print("WendlandGradient", numerics, re, found(WendlandGradient, numerics, n, re));
        }
        let peaked = Numerics { radius: 3.0, shifting: 10.0, level: 0.0, ..corrected };
        for numerics in [plain, peaked] {
            print("WendlandC2", numerics, re, found(WendlandC2, numerics, n, re));
        }
    }
}

fn print(weight: &str, numerics: Numerics, re: f64, found: Result<Vec<f64>, FluidError>) {
    let Numerics { radius, corrected, shifting, level, diffusion, sound } = numerics;
    let form = if corrected { "corrected" } else { "plain" };
    let values = match found {
        Ok(rates) => rates.iter().map(|rate| format!("{rate:.2}")).collect::<Vec<_>>().join(", "),
        Err(error) => error.to_string(),
    };
    println!("| {weight}, {radius}, {form}, {shifting}, {level}, {diffusion}, {sound} | {re} | {values} |");
}
