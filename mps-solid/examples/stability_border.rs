//! The stability limit of small bodies in units of `l0/c_p`.
//!
//! `cargo run --release -p mps-solid --example stability_border [-- radius]`
//!
//! prints the table of `docs/solid.md`: what the constant of `dt = C l0/c_p` would have to be.
#![allow(clippy::print_stdout)]

use mps_kernel::{Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::materials::CorotationalHooke;
use mps_solid::{Solid, SolidConfig};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let radius = std::env::args().nth(1).and_then(|a| a.parse().ok()).unwrap_or(1.6);
    println!("radius {radius} l0");
    println!(
        "| nu | 16x2 | 16x3 | 16x4 | 16x4 clamped | 16x16 | 12x2x2 | 12x3x3 | 12x4x4 | 12x12x2 | 8x8x8 |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    for nu in [-0.3, 0.0, 0.2, 0.3, 0.4, 0.47, 0.49] {
        let plane = |counts, clamp: &[Face]| border::<2>(counts, clamp, nu, radius);
        let space = |counts| border::<3>(counts, &[], nu, radius);
        println!(
            "| {nu} | {:.2} | {:.2} | {:.2} | {:.2} | {:.2} | {:.2} | {:.2} | {:.2} | {:.2} | {:.2} |",
            plane([16, 2], &[])?,
            plane([16, 3], &[])?,
            plane([16, 4], &[])?,
            plane([16, 4], &[Face::lower(0)])?,
            plane([16, 16], &[])?,
            space([12, 2, 2])?,
            space([12, 3, 3])?,
            space([12, 4, 4])?,
            space([12, 12, 2])?,
            space([8, 8, 8])?,
        );
    }
    Ok(())
}

/// `2 c_p / (omega_max l0)` of a block with unit spacing.
fn border<const D: usize>(
    counts: [usize; D],
    clamp: &[Face],
    nu: f64,
    radius: f64,
) -> Result<f64, Box<dyn Error>> {
    let upper = Vector::<f64, D>::from_fn(|axis, _| {
        let on_faces = clamp.iter().filter(|face| face.axis == axis).count();
        counts[axis] as f64 - 0.5 * on_faces as f64
    });
    let block = body::block(Vector::zeros(), upper, counts, clamp)?;
    let config = SolidConfig { radius_ratio: radius, ..SolidConfig::default() };
    let material = CorotationalHooke::new(1.0, nu)?;
    let parallel = Parallel::serial();
    let solid = Solid::new(block.particles, block.spacing, 1.0, material, WendlandC2, config, &parallel)?;
    Ok(solid.stability_limit() * solid.wave_speed())
}
