//! The printed scheme of Tavakoli et al. 2026 (module `spin`): its step and its error on case 1.
//!
//! `cargo run --release -p mps-solid --example spin -- [particles across ...]`
//!
//! prints the border of the sub-step over `l0/c_p`, and the error of the period of case 1, both as printed (pairs divided by the own
//! number density) and in the form that keeps energy and momentum, with the weight of the paper and with
//! Wendland's. With `5 10`, the default, it takes a minute, with 20 ten.
#![allow(clippy::print_stdout)]

use mps_kernel::weights::{Rational, WendlandC2};
use mps_kernel::{Kernel, Vector};
use mps_neighbors::Parallel;
use mps_solid::SolidError;
use mps_solid::body::{self, Face};
use mps_solid::materials::Moduli;
use mps_solid::spin::{Normalization, SpinConfig, SpinSolid};
use std::error::Error;

type V = Vector<f64, 2>;
type Outcome<T> = Result<T, Box<dyn Error>>;

/// Length and thickness of the plate of case 1 \[m\], density \[kg/m^3\], bulk and shear modulus \[Pa\].
const SIZE: [f64; 2] = [0.2, 0.02];
const DENSITY: f64 = 1000.0;
const MODULI: [f64; 2] = [3.25e6, 0.715e6];
/// Period over `L/c_s`: quadratic finite elements, extrapolated (section 3 of `docs/solid.md`).
const PERIOD: f64 = 72.78;
const FORMS: [(&str, Normalization); 2] =
    [("as printed", Normalization::Own), ("conservative", Normalization::Shared)];

fn main() -> Outcome<()> {
    let mut across: Vec<usize> = std::env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    if across.is_empty() {
        across = vec![5, 10];
    }
    println!("border of the sub-step in l0/c_p, free plate of 16x8\n");
    println!("| form | weight | nu = 0 | 0.3 | 0.4 | 0.47 |\n|---|---|---|---|---|---|");
    for (name, form) in FORMS {
        borders(name, "paper's", form, Rational)?;
        borders(name, "Wendland C2", form, WendlandC2)?;
    }
    println!(
        "\nerror of the period of case 1, radius 3, cfl 0.8, which is below the border of this material\n"
    );
    let heads: Vec<_> = across.iter().map(|n| format!(" {n} |")).collect();
    println!("| form | weight |{}\n|---|---|{}", heads.concat(), "---|".repeat(across.len()));
    for (name, form) in FORMS {
        errors(name, "paper's", form, Rational, &across)?;
        errors(name, "Wendland C2", form, WendlandC2, &across)?;
    }
    Ok(())
}

fn borders(name: &str, weight: &str, form: Normalization, kernel: impl Kernel<f64>) -> Outcome<()> {
    let mut line = format!("| {name} | {weight} |");
    for nu in [0.0, 0.3, 0.4, 0.47] {
        let moduli = Moduli::<f64>::new(1.0, nu)?;
        let wave = (moduli.lambda + 2.0 * moduli.mu).sqrt();
        let (mut low, mut high) = (0.0, 2.0);
        for _ in 0..10 {
            let middle = 0.5 * (low + high);
            if stays(form, kernel, moduli, middle / wave)? { low = middle } else { high = middle }
        }
        line += &format!(" {low:.3} |");
    }
    println!("{line}");
    Ok(())
}

/// Whether a free plate with unit spacing that is set off at random stays bounded for 4000 sub-steps of `dt`. As printed
/// the energy is not kept: what counts is a growth to ten thousand times the kinetic energy of the start.
fn stays(form: Normalization, kernel: impl Kernel<f64>, moduli: Moduli<f64>, dt: f64) -> Outcome<bool> {
    let serial = Parallel::serial();
    let block = body::block(V::zeros(), V::new(16.0, 8.0), [16, 8], &[])?;
    let config = SpinConfig { normalization: form, ..SpinConfig::default() };
    let mut solid = SpinSolid::new(block.particles, block.spacing, 1.0, moduli, kernel, config, &serial)?;
    let mut state = 1_u64;
    let mut noise = || {
        // Knuth's linear congruential generator, upper bits.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        1e-5 * ((state >> 40) as f64 / (1_u64 << 24) as f64 - 0.5)
    };
    solid.velocities_mut().iter_mut().for_each(|u| *u = V::new(noise(), noise()));
    let start = solid.energy(&serial).kinetic;
    let none = vec![V::zeros(); 16 * 8];
    for _ in 0..80 {
        match solid.advance(&serial, &none, &V::zeros(), 50.0 * dt, 50) {
            Ok(()) => (),
            Err(SolidError::NotFinite { .. }) => return Ok(false),
            Err(other) => return Err(other.into()),
        }
        // NaN is not below the limit.
        if !solid.energy(&serial).kinetic.partial_cmp(&(1e4 * start)).is_some_and(|order| order.is_lt()) {
            return Ok(false);
        }
    }
    Ok(true)
}

fn errors(
    name: &str,
    weight: &str,
    form: Normalization,
    kernel: impl Kernel<f64>,
    across: &[usize],
) -> Outcome<()> {
    let mut line = format!("| {name} | {weight} |");
    for &n in across {
        line += &format!(" {:+.2} % |", 100.0 * (period(n, form, kernel)? / PERIOD - 1.0));
    }
    println!("{line}");
    Ok(())
}

/// Period over `L/c_s` of the plate with `n` particles across, from its first passage upwards: it starts undeformed.
fn period(n: usize, form: Normalization, kernel: impl Kernel<f64>) -> Outcome<f64> {
    let (serial, clamp, upper) = (Parallel::serial(), [Face::lower(0)], V::from(SIZE));
    let counts = body::counts(&V::zeros(), &upper, SIZE[1] / n as f64, &clamp);
    let plate = body::block(V::zeros(), upper, counts, &clamp)?;
    let moduli = Moduli::from_bulk_and_shear(MODULI[0], MODULI[1])?;
    let config = SpinConfig { normalization: form, cfl: 0.8, ..SpinConfig::default() };
    let mut solid = SpinSolid::new(plate.particles, plate.spacing, DENSITY, moduli, kernel, config, &serial)?;
    let sound = (MODULI[0] / DENSITY).sqrt();
    let along: Vec<f64> = solid.particles().reference_positions().iter().map(|x| x.x / SIZE[0]).collect();
    for (u, x) in solid.velocities_mut().iter_mut().zip(&along) {
        u.y = 0.01 * sound * first_mode(*x);
    }
    let end: Vec<usize> = (0..along.len()).filter(|&i| along[i] > 1.0 - 0.75 / (10 * n) as f64).collect();
    let none = vec![V::zeros(); along.len()];
    let dt = 4.0 * solid.max_step(&serial);
    let (mut time, mut before) = (0.0, 0.0);
    while time * sound / SIZE[0] < 2.0 * PERIOD {
        solid.advance(&serial, &none, &V::zeros(), dt, 4)?;
        let particles = solid.particles();
        let now: f64 =
            end.iter().map(|&i| particles.positions()[i].y - particles.reference_positions()[i].y).sum();
        if before < 0.0 && now >= 0.0 {
            return Ok((time + dt * before / (before - now)) * sound / SIZE[0]);
        }
        (time, before) = (time + dt, now);
    }
    Err("the plate does not swing".into())
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
