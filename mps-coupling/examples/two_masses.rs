//! Why sub-steps are done as they are: eigenvalues of one step of a fluid mass and a structure.
//!
//! A fluid mass on a spring of its own is pressed against a structure on a spring; the interface between them is a
//! third spring, the compressed fluid. One step is a linear map of (fluid velocity, fluid position,
//! structure position, structure velocity); an eigenvalue above one is a mode that gains energy.
//!
//! `cargo run --release -p mps-coupling --example two_masses` prints the largest one for each way to treat the
//! fluid during the sub-steps of the structure, over all frequencies the sub-step resolves. The table
//! stands in `docs/coupling.md`.

#![allow(clippy::print_stdout, reason = "an example talks to its user")]

use nalgebra::{Matrix4, Vector4};

/// What the water at the interface does while the structure takes its sub-steps.
#[derive(Clone, Copy, Debug)]
enum Water {
    /// Moves on with the velocity of the start of the step; its force kicks the structure first.
    Held,
    /// As before, but the force is held over the sub-step, extrapolated to its middle.
    HeldForce,
    /// Does not move until the end of the step.
    Still,
    /// Sub-stepped; everything else that accelerates it is one kick at the start.
    SubStepped,
    /// Sub-stepped; everything else is spread over the sub-steps.
    Spread,
}

/// Units: step 1, stiffness of the interface 1, so that all that counts is in these numbers.
#[derive(Clone, Copy)]
struct Case {
    water: Water,
    /// `K dt^2/m_F`.
    stiffness: f64,
    /// Fluid mass over structure mass.
    ratio: f64,
    /// Square of the structure's own frequency times the step.
    frequency2: f64,
    substeps: u32,
}

/// One step.
fn step(case: &Case, state: Vector4<f64>) -> Vector4<f64> {
    let [[mut u, fluid, mut x, mut v]] = state.data.0;
    let (per_fluid, per_structure) = (case.stiffness, case.stiffness * case.ratio);
    let h = 1.0 / f64::from(case.substeps);
    let others = -fluid * per_fluid;
    let start = u;
    let (mut place, mut impulse, mut middle) = (fluid, 0.0, 0.0);
    if matches!(case.water, Water::SubStepped) {
        u += others;
    }
    for _ in 0..case.substeps {
        let pressure = x - place + middle;
        let push = -pressure * per_structure;
        let before = x;
        if matches!(case.water, Water::HeldForce) {
            v += 0.5 * h * (push - case.frequency2 * x);
            x += h * v;
            v += 0.5 * h * (push - case.frequency2 * x);
            middle = 0.5 * (x - before - h * start);
        } else {
            v += h * push - 0.5 * h * case.frequency2 * x;
            x += h * v;
            v -= 0.5 * h * case.frequency2 * x;
        }
        impulse += h * pressure * per_fluid;
        match case.water {
            Water::Held | Water::HeldForce => place += h * start,
            Water::Still => {}
            Water::SubStepped | Water::Spread => {
                u += h * pressure * per_fluid;
                if matches!(case.water, Water::Spread) {
                    u += h * others;
                }
                place += h * u;
            }
        }
    }
    match case.water {
        Water::SubStepped | Water::Spread => Vector4::new(u, place, x, v),
        _ => {
            u += others + impulse;
            Vector4::new(u, fluid + u, x, v)
        }
    }
}

/// Largest absolute eigenvalue.
fn growth(case: &Case) -> f64 {
    let columns: Vec<_> = (0..4).map(|k| step(case, Vector4::ith(k, 1.0))).collect();
    let eigenvalues = Matrix4::from_columns(&columns).complex_eigenvalues();
    eigenvalues.iter().fold(0.0, |most, z| z.norm().max(most))
}

/// The worst over the frequencies the sub-step resolves, and where it is.
fn worst(water: Water, stiffness: f64, ratio: f64, substeps: u32) -> (f64, f64) {
    (1..=400).fold((0.0, 0.0), |worst, k| {
        let frequency = 1.6 * f64::from(substeps * k) / 400.0;
        let case = Case { water, stiffness, ratio, frequency2: frequency * frequency, substeps };
        let found = growth(&case);
        if found > worst.0 { (found, frequency) } else { worst }
    })
}

fn main() {
    println!("largest growth per step, and the frequency times the step where it is");
    for (stiffness, ratio) in [(0.05, 1.0), (0.2, 0.1), (0.2, 1.0), (0.2, 5.0)] {
        println!("\nK dt^2/m_F = {stiffness}, fluid mass over structure mass = {ratio}");
        for water in [Water::HeldForce, Water::Held, Water::Still, Water::SubStepped, Water::Spread] {
            let row: Vec<_> = [1, 2, 4, 10]
                .map(|m| {
                    let (most, frequency) = worst(water, stiffness, ratio, m);
                    format!("m = {m}: {most:.4} at {frequency:.1}")
                })
                .into();
            println!("{:12} {}", format!("{water:?}"), row.join("   "));
        }
    }
}
