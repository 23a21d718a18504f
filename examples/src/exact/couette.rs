//! Plane Couette flow from rest: the upper wall moves suddenly.

use super::case::{Case, Measure, Outcome, Pace, Plot};
use super::measures::rms;
use super::numerics::Numerics;
use super::scene::{NU, WIDTH, advance, channel};
use crate::{Failure, Watch};
use core::f64::consts::PI;
use mps_io::CurvePlot;
use mps_kernel::weights::WendlandC2;
use mps_neighbors::Parallel;

pub(crate) struct Couette;

/// Speed of the upper wall \[m/s\].
const SPEED: f64 = 1.0;
/// When the profile is looked at, in `L^2/nu`.
const LOOKS: [f64; 3] = [0.045, 0.225, 1.0];
const SERIES: &str = "analytic: y/L + sum 2 (-1)^n/(n pi) sin(n pi y/L) exp(-n^2 pi^2 nu t/L^2)";

/// `u/U` at height `y/L` and time `nu t/L^2`.
fn exact(y: f64, time: f64) -> f64 {
    let term = |n: i32| {
        let k = f64::from(n) * PI;
        2.0 / k * (1 - 2 * (n % 2)) as f64 * (k * y).sin() * (-k * k * time).exp()
    };
    y + (1..200).map(term).sum::<f64>()
}

impl Case for Couette {
    fn name(&self) -> &'static str {
        "couette"
    }

    fn about(&self) -> &'static str {
        "Viscous fluid at rest between two walls without slip, periodic along them; the upper one moves suddenly. \
         Re = U L/nu = 10, c = 10 U. Errors of the velocity are root mean squares over the particles, over U."
    }

    fn resolution(&self) -> &'static str {
        "particles across"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![10, 20], vec![10, 20, 40])
    }

    fn run(&self, across: usize, _pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let mut fluid = channel::<f64, _>(across, SPEED, 0.0, WendlandC2, &Numerics::default())?;
        let mut outcome = Outcome::default();
        let metrics = ["profile at 0.045", "profile at 0.225", "profile at 1"];
        for (look, metric) in LOOKS.into_iter().zip(metrics) {
            advance(&mut fluid, parallel, &Watch::nobody(), look * WIDTH * WIDTH / NU, |_| ())?;
            let now = fluid.time() * NU / (WIDTH * WIDTH);
            let particles = fluid.particles();
            let u = &particles.velocity;
            let error = rms(particles, |i| u[i].x / SPEED, |r| exact(r.y / WIDTH, now));
            outcome.measures.push(Measure::new(metric, "-", error, 0.0, SERIES).within(0.01, 40));
            outcome.curves.push(super::poiseuille::profile(particles, across, SPEED));
        }
        Ok(outcome)
    }

    fn plots(&self) -> Vec<Plot> {
        let y: Vec<f64> = (0..=100).map(|k| f64::from(k) * 0.01).collect();
        let axes = CurvePlot::new("Couette flow from rest", "y/L [-]", "u/U [-]");
        let axes = LOOKS.iter().fold(axes, |axes, look| {
            let u: Vec<f64> = y.iter().map(|y| exact(*y, *look)).collect();
            axes.dashed(&format!("exact, ν t/L² = {look}"), &y, &u)
        });
        vec![Plot { name: "profiles", axes }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_solves_the_problem() {
        for time in [0.02, 0.1, 0.5] {
            assert!(exact(0.0, time).abs() < 1e-12 && (exact(1.0, time) - 1.0).abs() < 1e-12);
            let h = 1e-3;
            let by_time = (exact(0.6, time + 1e-5) - exact(0.6, time - 1e-5)) / 2e-5;
            let bend = (exact(0.6 + h, time) - 2.0 * exact(0.6, time) + exact(0.6 - h, time)) / (h * h);
            assert!((by_time - bend).abs() < 1e-4, "{by_time} and {bend}");
        }
        // Tabulated to eight digits from the same series in 30 digits.
        assert!((exact(0.5, 0.045) - 0.095580131).abs() < 1e-8);
        assert!((exact(0.3, 2.0) - 0.3).abs() < 1e-8, "linear in the end");
    }
}
