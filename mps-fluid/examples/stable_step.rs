//! The largest Courant number that the density diffusion bears, by weight and radius, as a table in 2D and (in brackets) 3D.
//!
//! `cargo run --release -p mps-fluid --example stable_step -- [delta]`
#![allow(clippy::print_stdout, reason = "a program talks to its user")]

use mps_fluid::{Boundary, Diffusion, Fluid, FluidConfig, FluidError, FluidParticles};
use mps_kernel::weights::{Rational, WendlandC2, WendlandGradient};
use mps_kernel::{Kernel, Vector};
use mps_neighbors::Open;

fn main() -> Result<(), FluidError> {
    let delta = std::env::args().nth(1).and_then(|delta| delta.parse().ok()).unwrap_or(0.5);
    let radii = [2.5, 3.0, 3.5, 4.0];
    println!("| weight | radius 2.5 | 3 | 3.5 | 4 |\n|---|---|---|---|---|");
    row("rational", Rational, delta, radii)?;
    row("smooth", WendlandGradient, delta, radii)?;
    row("wendland", WendlandC2, delta, radii)
}

fn row<K: Kernel<f64> + Copy>(name: &str, weight: K, delta: f64, radii: [f64; 4]) -> Result<(), FluidError> {
    let [flat, deep] = [of::<K, 2>, of::<K, 3>];
    let mut cells = String::new();
    for radius in radii {
        let [flat, deep] = [flat(weight, delta, radius)?, deep(weight, delta, radius)?];
        cells += &format!(" {flat:.2} ({deep:.2}) |");
    }
    println!("| {name} |{cells}");
    Ok(())
}

fn of<K: Kernel<f64>, const D: usize>(weight: K, delta: f64, radius: f64) -> Result<f64, FluidError> {
    let mut config = FluidConfig::<f64, D>::water(1.0, 1.0);
    config.radius_ratio = radius;
    config.diffusion = Diffusion::Filter { delta };
    let one = FluidParticles::at_rest(vec![Vector::zeros()]);
    let fluid = Fluid::new(config, weight, |_| (), Open, one, Boundary::default())?;
    Ok(fluid.stable_courant_number())
}
