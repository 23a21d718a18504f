//! Where the coupling stays stable: a rigid piston on a spring, on a column of water, over the density of the piston and
//! the stiffness of its spring.
//!
//! The piston is four particles thick and gets a push; nothing is viscous. Printed is the largest total energy in the last quarter of
//! 0.2 s (400 steps, ten passages of sound through the column) over that in the first quarter: what grows has more than 1, what
//! density diffusion takes leaves less. (Not over that at the start: the energy read at the ends of symplectic steps swings with
//! stiff springs.) The piston chooses its sub-steps by its own spring, at 0.8 of the stability limit as the solid of `mps-solid`
//! does, and the scene takes at least as many as the title says. In the last table the piston tells its mass
//! (`Structure::inertia`), and the scene finds out itself.
//!
//! `cargo run --release -p mps-coupling --example stability_map` prints the tables of `docs/coupling.md`.

#![allow(clippy::print_stdout, reason = "an example talks to its user")]
#![allow(clippy::unwrap_used, reason = "helpers shared with the tests may fail the test")]

#[path = "../tests/common/mod.rs"]
mod common;

use common::column::{L0, STIFFNESS, WIDTH, column_under, total};
use mps_neighbors::Parallel;

/// Density of the piston over that of the water.
const DENSITIES: [f64; 7] = [0.01, 0.05, 0.2, 1.0, 5.0, 20.0, 50.0];
/// Stiffness of the spring over that of the column.
const SPRINGS: [f64; 4] = [0.0, 1.0, 100.0, 10_000.0];
const END: f64 = 0.2;

/// Largest energy in the last quarter over that in the first.
fn growth(density: f64, spring: f64, least: usize, open: bool) -> f64 {
    let mass = density * 1000.0 * 4.0 * L0 * WIDTH;
    let stiffness = spring * STIFFNESS;
    let limit = 0.8 * 2.0 * (mass / stiffness).sqrt();
    let mut scene = column_under(mass, stiffness, 1e-3, (0.5, limit), open);
    scene.min_substeps = least;
    let parallel = Parallel::serial();
    let start = total(&scene);
    let (mut early, mut late) = (0.0_f64, 0.0_f64);
    while scene.fluid().time() < END {
        let stepped = scene.step(&parallel, f64::INFINITY);
        let (time, energy) = (scene.fluid().time(), total(&scene));
        if stepped.is_err() || energy.is_nan() || energy > 1e6 * start {
            return f64::INFINITY;
        }
        if time < 0.25 * END {
            early = early.max(energy);
        } else if time > 0.75 * END {
            late = late.max(energy);
        }
    }
    late / early
}

fn main() {
    for (least, open) in [(1, false), (2, false), (4, false), (16, false), (1, true)] {
        let told = if open { ", and what the fluid at the surface asks for" } else { "" };
        println!("\nat least {least} sub-steps{told}\n");
        println!("| piston/water | no spring | 1 x column | 100 x | 10000 x |\n|---|---|---|---|---|");
        for density in DENSITIES {
            let cells = SPRINGS.map(|spring| {
                let energy = growth(density, spring, least, open);
                if energy.is_finite() { format!("{energy:.3}") } else { "**burst**".to_owned() }
            });
            println!("| {density} | {} |", cells.join(" | "));
        }
    }
}
