//! Case 1 of Tavakoli et al. 2026: the free vibration of a clamped plate, at several resolutions.
//!
//! `cargo run --release -p mps-solid --example cantilever_convergence -- [particles across ...]`
//!
//! prints the tables of section 3 of `docs/solid.md`: period and amplitude against converged two-dimensional
//! elasticity, the observed order, the energy span and the speed.
//!
//! This is the workbench of the discretisation, and needs this crate only. The environment may set `POISSON` to
//! 0, 0.47 or 0.49 for another material with a known answer, and `RADIUS`, `CFL`, `BENDING` for the
//! parameters of the same names. The case itself, with its parameters fixed, its curves and pictures, is the program
//! `cantilever` of the examples; its `--convergence` has the corotational law of the paper, this one Saint Venant-Kirchhoff's,
//! which is that of the finite elements.
#![allow(clippy::print_stdout)]

use mps_kernel::{Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::materials::{Moduli, SaintVenantKirchhoff};
use mps_solid::{Solid, SolidConfig};
use std::error::Error;
use std::time::Instant;

/// Plate length and thickness \[m\]; the ratio 10 reproduces the analytic period of Gray et al. 2001.
const LENGTH: f64 = 0.2;
const THICKNESS: f64 = 0.02;
/// Density \[kg/m^3\], bulk and shear modulus \[Pa\] (Gray, Monaghan and Swift 2001).
const DENSITY: f64 = 1000.0;
const BULK: f64 = 3.25e6;
const SHEAR: f64 = 0.715e6;
/// Truth: quadratic finite elements in plane strain with a rigid clamp, meshes 80x8 and 160x16
/// extrapolated with the order 1.45 of the corner singularity. Poisson's ratio and the period in the
/// time `L sqrt(rho/mu)`; the amplitude `A/L` is that of a geometrically nonlinear run of the first.
const TRUTH: [(f64, f64); 4] = [(0.397515, 34.1363), (0.0, 44.0590), (0.47, 31.938), (0.49, 31.298)];
const AMPLITUDE: f64 = 0.1148;

struct Outcome {
    particles: usize,
    substeps: usize,
    period: f64,
    amplitude: f64,
    energy_span: f64,
    seconds: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut across: Vec<usize> = std::env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    if across.is_empty() {
        across = vec![3, 4, 5, 10, 20];
    }
    let config = SolidConfig {
        radius_ratio: variable("RADIUS", 1.6),
        cfl: variable("CFL", 0.8),
        bending_correction: variable("BENDING", 1.0),
        ..SolidConfig::default()
    };
    let (moduli, truth) = material(variable("POISSON", TRUTH[0].0))?;
    println!("Wendland C2, {config:?}, {moduli:?}");
    println!("truth: period {truth:.3}, amplitude {AMPLITUDE} for the material of case 1");
    println!(
        "| h/l0 | particles | T c_s/L | error | order | A/L | error | energy span/E0 | Mparticle-substeps/s |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let mut before: Option<(usize, f64)> = None;
    for n in across {
        let run = vibrate(n, config, moduli, truth)?;
        let error = run.period / truth - 1.0;
        let order = before.map_or(String::new(), |(m, e)| {
            format!("{:.2}", (e / error).abs().ln() / (n as f64 / m as f64).ln())
        });
        println!(
            "| {n} | {} | {:.3} | {:+.2} % | {order} | {:.4} | {:+.2} % | {:.1e} | {:.1} |",
            run.particles,
            run.period,
            100.0 * error,
            run.amplitude,
            100.0 * (run.amplitude / AMPLITUDE - 1.0),
            run.energy_span,
            (run.particles * run.substeps) as f64 / run.seconds * 1e-6,
        );
        before = Some((n, error));
    }
    Ok(())
}

fn variable(name: &str, default: f64) -> f64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

/// The moduli for a Poisson's ratio of the table, all with the shear modulus of case 1,
/// and the true `T c_s/L`.
fn material(poisson: f64) -> Result<(Moduli<f64>, f64), Box<dyn Error>> {
    let known = TRUTH.iter().find(|(nu, _)| (nu - poisson).abs() < 1e-3);
    let &(nu, period) = known.ok_or("no reference for this POISSON: take 0, 0.3975, 0.47 or 0.49")?;
    let moduli = Moduli::new(2.0 * SHEAR * (1.0 + nu), nu)?;
    Ok((moduli, period * (BULK / SHEAR).sqrt()))
}

/// Three periods of the plate with `n` particles across.
fn vibrate(
    n: usize,
    config: SolidConfig<f64>,
    moduli: Moduli<f64>,
    truth: f64,
) -> Result<Outcome, Box<dyn Error>> {
    let parallel = Parallel::all_cores()?;
    let clamp = [Face::lower(0)];
    let (lower, upper) = (Vector::<f64, 2>::zeros(), Vector::<f64, 2>::new(LENGTH, THICKNESS));
    let counts = body::counts(&lower, &upper, THICKNESS / n as f64, &clamp);
    let plate = body::block(lower, upper, counts, &clamp)?;
    let material = SaintVenantKirchhoff::from(moduli);
    let mut solid =
        Solid::new(plate.particles, plate.spacing, DENSITY, material, WendlandC2, config, &parallel)?;

    let sound = (BULK / DENSITY).sqrt();
    let start: Vec<_> = solid.positions().iter().map(|x| first_mode(x.x / LENGTH)).collect();
    for (u, shape) in solid.velocities_mut().iter_mut().zip(start) {
        u.y = 0.01 * sound * shape;
    }
    let (rest, gravity) = (vec![Vector::zeros(); solid.len()], Vector::zeros());
    let tip = Tip::of(&solid);

    // The step hardly changes: hold it, so that the sampling is even.
    let substeps = 4;
    let dt = solid.max_step(&parallel) * substeps as f64;
    let end = 3.2 * truth * LENGTH / sound;
    let (mut time, mut deflection, mut steps) = (0.0, 0.0, 0);
    let (mut crossings, mut extremes) = (Vec::new(), (0.0_f64, 0.0_f64));
    let energy0 = solid.energy(&parallel, &gravity).total();
    let (mut least, mut most) = (energy0, energy0);
    let clock = Instant::now();
    while time < end {
        solid.advance(&parallel, &rest, &gravity, dt, substeps)?;
        let now = tip.deflection(&solid);
        if deflection < 0.0 && now >= 0.0 {
            crossings.push(time + dt * deflection / (deflection - now));
        }
        extremes = (extremes.0.min(now), extremes.1.max(now));
        (time, deflection, steps) = (time + dt, now, steps + 1);
        if steps % 50 == 0 {
            let energy = solid.energy(&parallel, &gravity).total();
            (least, most) = (least.min(energy), most.max(energy));
        }
    }
    let last = crossings.last().copied().unwrap_or(f64::NAN);
    Ok(Outcome {
        particles: solid.len(),
        substeps: steps * substeps,
        period: last / crossings.len() as f64 * sound / LENGTH,
        amplitude: 0.5 * (extremes.1 - extremes.0) / LENGTH,
        energy_span: (most - least) / energy0,
        seconds: clock.elapsed().as_secs_f64(),
    })
}

/// Eq. 51 divided by its value at the tip.
fn first_mode(x: f64) -> f64 {
    let kl: f64 = 1.875;
    let f = |x: f64| {
        (kl.cos() + kl.cosh()) * ((kl * x).cosh() - (kl * x).cos())
            + (kl.sin() - kl.sinh()) * ((kl * x).sinh() - (kl * x).sin())
    };
    f(x) / f(1.0)
}

/// The particles of the last two columns: the deflection is extrapolated to the end of the plate.
struct Tip {
    last: Vec<usize>,
    second: Vec<usize>,
}

impl Tip {
    fn of(solid: &Solid<f64, 2, SaintVenantKirchhoff<f64>>) -> Self {
        let column = |k: f64| {
            let x = LENGTH - k * solid.spacing().x;
            let near = |i: &usize| {
                (solid.particles().reference_positions()[*i].x - x).abs() < 0.1 * solid.spacing().x
            };
            (0..solid.len()).filter(near).collect()
        };
        Self { last: column(0.5), second: column(1.5) }
    }

    fn deflection(&self, solid: &Solid<f64, 2, SaintVenantKirchhoff<f64>>) -> f64 {
        let mean = |column: &[usize]| {
            let sum: f64 = column
                .iter()
                .map(|&i| solid.positions()[i].y - solid.particles().reference_positions()[i].y)
                .sum();
            sum / column.len() as f64
        };
        1.5 * mean(&self.last) - 0.5 * mean(&self.second)
    }
}
