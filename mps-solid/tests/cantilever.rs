//! Case 1 of Tavakoli et al. 2026 at five particles across: period and amplitude.
//!
//! Truth: converged plane-strain elasticity, `T c_s/L = 72.78`, `A/L = 0.1148` (quadratic finite elements,
//! mesh 240x24, extrapolated). Euler-Bernoulli gives 72.44; paper 1 measured 73.30.
//! The full table is made by `examples/cantilever_convergence.rs`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

use mps_kernel::{Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::materials::{CorotationalHooke, Moduli};
use mps_solid::{Solid, SolidConfig};

#[test]
fn period_and_amplitude_of_the_vibrating_plate() {
    let parallel = Parallel::serial();
    let (length, thickness, across) = (0.2, 0.02, 5);
    let (bulk, shear, density) = (3.25e6, 0.715e6, 1000.0);
    let sound = f64::sqrt(bulk / density);
    let clamp = [Face::lower(0)];
    let (lower, upper) = (Vector::<f64, 2>::zeros(), Vector::<f64, 2>::new(length, thickness));
    let counts = body::counts(&lower, &upper, thickness / across as f64, &clamp);
    let plate = body::block(lower, upper, counts, &clamp).unwrap();
    let material = CorotationalHooke::from(Moduli::from_bulk_and_shear(bulk, shear).unwrap());
    let config = SolidConfig::default();
    let mut solid =
        Solid::new(plate.particles, plate.spacing, density, material, WendlandC2, config, &parallel).unwrap();

    let start: Vec<_> = solid.positions().iter().map(|x| first_mode(x.x / length)).collect();
    for (u, shape) in solid.velocities_mut().iter_mut().zip(start) {
        u.y = 0.01 * sound * shape;
    }
    let column = |k: usize| (solid.len() - (k + 1) * across)..(solid.len() - k * across);
    let (last, second) = (column(0), column(1));
    let rest = vec![Vector::zeros(); solid.len()];
    let dt = 4.0 * solid.max_step(&parallel);
    let (mut time, mut before, mut crossings, mut extremes) = (0.0, 0.0, Vec::new(), (0.0_f64, 0.0_f64));
    while crossings.len() < 2 {
        solid.advance(&parallel, &rest, &Vector::zeros(), dt, 4).unwrap();
        let mean = |column: &core::ops::Range<usize>| {
            let sum: f64 = solid.positions()[column.clone()].iter().map(|x| x.y - 0.5 * thickness).sum();
            sum / across as f64
        };
        let now = 1.5 * mean(&last) - 0.5 * mean(&second);
        if time > 0.0 && before * now < 0.0 {
            crossings.push(time + dt * before / (before - now));
        }
        extremes = (extremes.0.min(now), extremes.1.max(now));
        (time, before) = (time + dt, now);
        assert!(time < 1.0, "does not swing");
    }
    let period = crossings[1] * sound / length;
    let amplitude = 0.5 * (extremes.1 - extremes.0) / length;
    assert!((period / 72.78 - 1.0).abs() < 0.01, "period {period}");
    assert!((amplitude / 0.1148 - 1.0).abs() < 0.01, "amplitude {amplitude}");
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
