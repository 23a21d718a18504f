//! Frequencies of plane plates without time stepping, and what the particles across do to them.
//!
//! `cargo run --release -p mps-solid --features matrix --example modes -- [numbers ...]`
//!
//! prints the lowest frequencies of the plate of case 1 of Tavakoli et al. 2026, clamped at one end and free.
//! Numbers from 2 on are particles across, smaller ones Poisson's ratios (all with the shear modulus of case 1).
//! With `locking`, `beam` or `disturbed` as the first word it prints a table of `docs/solid.md` instead: the period
//! of the clamped plate for few particles across and Poisson's ratios up to almost 1/2, that of the free one with
//! parts of the bending correction, or the frequency of the free one with particles displaced at random.
#![allow(clippy::print_stdout)]

use core::f64::consts::TAU;
use mps_kernel::{Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::materials::{CorotationalHooke, Moduli};
use mps_solid::matrix::Stiffness;
use mps_solid::{Solid, SolidConfig, SolidParticles};
use std::error::Error;
use std::time::Instant;

type Outcome<T> = Result<T, Box<dyn Error>>;

/// Plate length and thickness \[m\], density \[kg/m^3\], shear modulus \[Pa\] (Gray, Monaghan and Swift 2001).
const LENGTH: f64 = 0.2;
const THICKNESS: f64 = 0.02;
const DENSITY: f64 = 1000.0;
const SHEAR: f64 = 0.715e6;
/// Particles across of the runs whose results are extrapolated to a reference: odd, which do not lock.
const FINE: [usize; 3] = [13, 25, 49];

fn main() -> Outcome<()> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let numbers = words.iter().filter_map(|word| word.parse::<f64>().ok());
    let (across, ratios): (Vec<f64>, Vec<f64>) = numbers.partition(|number| *number >= 2.0);
    let or = |given: Vec<f64>, usual: &[f64]| if given.is_empty() { usual.to_vec() } else { given };
    match words.first().map(String::as_str) {
        Some("locking") => {
            let ratios = or(ratios, &[0.0, 0.3, 0.4, 0.47, 0.49, 0.499, 0.4999]);
            locking(&or(across, &[2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0]), &ratios)
        }
        Some("beam") => {
            beam(&or(across, &[2.0, 3.0, 4.0, 5.0, 8.0, 10.0, 16.0]), &or(ratios, &[0.0, 0.3975]))
        }
        Some("disturbed") => disturbed(&or(across, &[5.0, 10.0, 20.0]), &or(ratios, &[0.0, 0.3975])),
        _ => frequencies(&or(across, &[5.0, 10.0, 20.0]), &or(ratios, &[0.0, 0.3975, 0.49])),
    }
}

fn frequencies(across: &[f64], ratios: &[f64]) -> Outcome<()> {
    println!(
        "| nu | h/l0 | unknowns | held | lowest frequencies [Hz] | 2/omega_max, and as estimated [us] | s |"
    );
    println!("|---|---|---|---|---|---|---|");
    for &nu in ratios {
        for &n in across {
            for (held, clamp) in [("clamped", &[Face::lower(0)][..]), ("free", &[])] {
                let clock = Instant::now();
                let solid = plate(n as usize, nu, clamp, 1.0)?;
                let stiffness = Stiffness::new(&solid)?;
                let rigid = if clamp.is_empty() { 3 } else { 0 };
                let modes = stiffness.lowest(rigid + 4)?;
                let list: Vec<_> =
                    modes[rigid..].iter().map(|mode| format!("{:.4}", mode.omega() / TAU)).collect();
                let limit = 2.0 / stiffness.largest_frequency()?;
                println!(
                    "| {nu} | {n} | {} | {held} | {} | {:.3}, {:.3} | {:.2} |",
                    stiffness.len(),
                    list.join(", "),
                    limit * 1e6,
                    solid.stability_limit() * 1e6,
                    clock.elapsed().as_secs_f64(),
                );
            }
        }
    }
    Ok(())
}

/// Errors of the first period of the clamped plate.
fn locking(across: &[f64], ratios: &[f64]) -> Outcome<()> {
    let of = |n: usize, nu: f64| period(n, nu, &[Face::lower(0)], 1.0);
    let heads: Vec<_> = across.iter().map(|n| format!(" {n} |")).collect();
    println!("| nu | T sqrt(mu/rho)/L, extrapolated (and at h/l0 = {}) |{}", FINE[2], heads.concat());
    println!("|---|---|{}", "---|".repeat(across.len()));
    for &nu in ratios {
        // Where the clamp meets the surface the solution is singular: the order is seen, not known.
        let [a, b, c] = FINE.map(|n| of(n, nu));
        let (a, b, c) = (a?, b?, c?);
        let gain = (c - b) / (b - a);
        let reference = c + (c - b) * gain / (1.0 - gain);
        let mut line = format!("| {nu} | {:.4} ({:.4}) |", unit(reference), unit(c));
        for &n in across {
            line += &format!(" {:.2} % |", 100.0 * (of(n as usize, nu)? / reference - 1.0));
        }
        println!("{line}");
    }
    Ok(())
}

/// Errors of the first period of bending of the free plate with parts of the bending correction.
fn beam(across: &[f64], ratios: &[f64]) -> Outcome<()> {
    println!("| nu | h/l0 | 0.05 kappa | 0.3 kappa | kappa |");
    println!("|---|---|---|---|---|");
    for &nu in ratios {
        // Nothing is singular: the order is 2.
        let (b, c) = (period(FINE[1], nu, &[], 1.0)?, period(FINE[2], nu, &[], 1.0)?);
        let reference = c + (c - b) / 3.0;
        for &n in across {
            let mut line = format!("| {nu} | {n} |");
            for part in [0.05, 0.3, 1.0] {
                line +=
                    &format!(" {:.2} % |", 100.0 * (period(n as usize, nu, &[], part)? / reference - 1.0));
            }
            println!("{line}");
        }
    }
    Ok(())
}

/// The first frequency of the free plate with particles displaced at random before the body is built, over that of
/// the lattice: mean, smallest and largest of ten.
fn disturbed(across: &[f64], ratios: &[f64]) -> Outcome<()> {
    const SIZES: [f64; 5] = [0.01, 0.05, 0.1, 0.15, 0.2];
    let heads: Vec<_> = SIZES.iter().map(|size| format!(" {size} l0 |")).collect();
    println!("| nu | h/l0 |{}", heads.concat());
    println!("|---|---|{}", "---|".repeat(SIZES.len()));
    let mut state = 1_u64;
    let mut noise = || {
        // Knuth's linear congruential generator, upper bits.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / (1_u64 << 23) as f64 - 1.0
    };
    for &nu in ratios {
        for &n in across {
            let regular = plate(n as usize, nu, &[], 1.0)?;
            let first = |solid: &Plate| -> Outcome<f64> { Ok(Stiffness::new(solid)?.lowest(4)?[3].omega()) };
            let lattice = first(&regular)?;
            let mut line = format!("| {nu} | {n} |");
            for size in SIZES {
                let mut found = Vec::new();
                for _ in 0..10 {
                    let mut particles = SolidParticles::new();
                    for (x, volume) in regular.positions().iter().zip(regular.volumes()) {
                        let shift =
                            Vector::<f64, 2>::from_fn(|axis, _| noise() * size * regular.spacing()[axis]);
                        particles.push(x + shift, *volume, false);
                    }
                    found.push(first(&solid(particles, *regular.spacing(), nu, 1.0)?)? / lattice);
                }
                let mean = found.iter().sum::<f64>() / found.len() as f64;
                let least = found.iter().copied().fold(f64::INFINITY, f64::min);
                let most = found.iter().copied().fold(0.0, f64::max);
                line += &format!(" {mean:.3} ({least:.3} to {most:.3}) |");
            }
            println!("{line}");
        }
    }
    Ok(())
}

/// A time in units of `L sqrt(rho/mu)`.
fn unit(time: f64) -> f64 {
    time / (LENGTH * (DENSITY / SHEAR).sqrt())
}

/// The longest period of the plate \[s\] beside the rigid motions.
fn period(n: usize, nu: f64, clamp: &[Face], bending: f64) -> Outcome<f64> {
    let rigid = if clamp.is_empty() { 3 } else { 0 };
    let modes = Stiffness::new(&plate(n, nu, clamp, bending)?)?.lowest(rigid + 1)?;
    Ok(modes[rigid].period())
}

type Plate = Solid<f64, 2, CorotationalHooke<f64>>;

fn plate(n: usize, nu: f64, clamp: &[Face], bending: f64) -> Outcome<Plate> {
    let (lower, upper) = (Vector::<f64, 2>::zeros(), Vector::<f64, 2>::new(LENGTH, THICKNESS));
    let counts = body::counts(&lower, &upper, THICKNESS / n as f64, clamp);
    let block = body::block(lower, upper, counts, clamp)?;
    solid(block.particles, block.spacing, nu, bending)
}

fn solid(
    particles: SolidParticles<f64, 2>,
    spacing: Vector<f64, 2>,
    nu: f64,
    bending: f64,
) -> Outcome<Plate> {
    let material = CorotationalHooke::from(Moduli::new(2.0 * SHEAR * (1.0 + nu), nu)?);
    let config = SolidConfig { bending_correction: bending, ..SolidConfig::default() };
    let parallel = Parallel::serial();
    Ok(Solid::new(particles, spacing, DENSITY, material, WendlandC2, config, &parallel)?)
}
