//! The example of a material of one's own: what it refuses, and that viscosity damps as much as it should.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{execute, fresh, words};
use core::f64::consts::PI;
use mps_io::{CsvTable, Summary};

const PROGRAM: &str = env!("CARGO_BIN_EXE_custom-material");

#[test]
fn what_cannot_be_run_is_refused_with_the_flag_and_a_remedy() {
    for (flag, value, remedy) in [
        ("--end-time", "0", "seconds"),
        ("--end-time", "nan", "seconds"),
        ("--end-time", "1000", "at most 100"),
        ("--viscosity", "1e9", "1000 damps"),
        ("--viscosity", "nan", "1000 damps"),
    ] {
        let dir = fresh("custom-material-cli", "refused");
        let output = execute(PROGRAM, &dir, &[flag, value]);
        let message = words(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{flag} {value}: {message}");
        assert!(message.starts_with(&format!("error: {flag} is ")) && message.contains(remedy), "{message}");
        assert!(!dir.exists(), "{flag} {value} has left something");
    }
}

/// Places where the curve turns, as heights \[m\].
fn turning_points(y: &[f64]) -> Vec<f64> {
    y.windows(3).filter(|w| (w[1] - w[0]) * (w[2] - w[1]) < 0.0).map(|w| w[1]).collect()
}

#[test]
fn the_damped_strip_comes_to_rest_as_fast_as_its_viscosity_says() {
    let dir = fresh("custom-material-cli", "default");
    let output = execute(PROGRAM, &dir, &["--quiet"]);
    assert!(output.status.success(), "{}", words(&output.stderr));
    assert!(output.stdout.is_empty() && dir.join("tip.png").exists());
    let summary = Summary::read(dir.join("summary.json")).unwrap();
    let metric = |name: &str| summary.metrics[name].value;
    assert!(metric("undamped_swing_at_the_end") > 0.95 * -metric("undamped_deepest"));
    assert!(metric("damped_swing_at_the_end") < 2e-3 * -metric("damped_deepest"));
    let lost = -metric("damped_energy_at_the_end");
    assert!(metric("undamped_energy_at_the_end").abs() < 1e-4 * lost);

    // The energy of the damped strip never rises.
    let table = CsvTable::read(dir.join("damped.csv")).unwrap();
    let energy = table.column("energy [J/m]").unwrap();
    assert!(energy.windows(2).all(|pair| pair[1] <= pair[0] + 1e-6 * lost));

    // A slender strip in plane strain bends with strains (e, -nu' e), nu' = lambda/(lambda + 2 mu), and loses
    // 2 eta (1 + nu'^2) (de/dt)^2 where it stores E'/2 e^2. With three particles across 1/9 of the
    // stiffness is in the bending correction, which is elastic.
    let turning = turning_points(table.column("tip y [m]").unwrap());
    let swing: Vec<f64> = turning.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    let damping = (swing[2] / swing[8]).ln() / (6.0 * PI);
    let (lambda, mu, eta, density) = (9.4e5_f64, 1.0e5, 1000.0, 1100.0_f64);
    let modulus = 4.0 * mu * (lambda + mu) / (lambda + 2.0 * mu);
    let poisson = lambda / (lambda + 2.0 * mu);
    let omega = 1.8751_f64.powi(2) / 0.12_f64.powi(2) * 0.02 * (modulus / (12.0 * density)).sqrt();
    let theory = 8.0 / 9.0 * omega * eta * (1.0 + poisson * poisson) / modulus;
    assert!((damping / theory - 1.0).abs() < 0.1, "damping ratio {damping}, beam theory {theory}");
}
