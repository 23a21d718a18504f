//! Plane Poiseuille flow from rest: a body force along the channel.

use super::case::{Case, Curve, Measure, Outcome, Pace, Plot};
use super::measures::{rms, states};
use super::numerics::{Choice, Problem};
use super::scene::{NU, WIDTH, advance, channel};
use crate::Failure;
use crate::poiseuille::from_rest;
use mps_fluid::FluidParticles;
use mps_io::CurvePlot;
use mps_io::scene_file::Weight;
use mps_kernel::{Kernel, Real};
use mps_neighbors::Parallel;

pub(crate) struct Poiseuille {
    pub(crate) choice: Choice,
}

/// Largest speed of the steady flow \[m/s\].
const SPEED: f64 = 1.0;
const LOOKS: [f64; 3] = [0.045, 0.225, 1.0];
const SERIES: &str =
    "analytic: 4 y (L-y)/L^2 - sum over odd n of 32/(pi n)^3 sin(n pi y/L) exp(-n^2 pi^2 nu t/L^2)";

/// Mean velocity of the particles of each row, over `speed`, against the height.
pub(crate) fn profile<T: Real>(particles: &FluidParticles<T, 2>, across: usize, speed: f64) -> Curve {
    let mut rows = vec![(0.0, 0.0); across];
    for (r, u) in states(particles) {
        let row = (r.y / WIDTH * across as f64).max(0.0) as usize;
        let row = &mut rows[row.min(across - 1)];
        *row = (row.0 + u.x / speed, row.1 + 1.0);
    }
    let filled = rows.iter().enumerate().filter(|(_, row)| row.1 > 0.0);
    let (y, u) = filled.map(|(k, row)| ((k as f64 + 0.5) / across as f64, row.0 / row.1)).unzip();
    Curve { plot: "profiles", name: format!("{across} across"), x: y, y: u }
}

impl Problem for Poiseuille {
    fn solve<T: Real, K: Kernel<T>>(
        &self,
        weight: K,
        across: usize,
        _pace: Pace,
        parallel: &Parallel,
    ) -> Result<Outcome, Failure> {
        let push = 8.0 * NU * SPEED / (WIDTH * WIDTH);
        let mut fluid = channel::<T, K>(across, 0.0, push, weight, &self.choice.numerics)?;
        let (mut measures, mut curves) = (Vec::new(), Vec::new());
        let metrics = ["profile at 0.045", "profile at 0.225", "profile at 1"];
        for (look, metric) in LOOKS.into_iter().zip(metrics) {
            advance(&mut fluid, parallel, &self.choice.watch, look * WIDTH * WIDTH / NU, |_| ())?;
            let now = fluid.time().to_double() * NU / (WIDTH * WIDTH);
            let particles = fluid.particles();
            let u = &particles.velocity;
            let error = rms(particles, |i| u[i].x.to_double() / SPEED, |r| from_rest(r.y / WIDTH, now));
            measures.push(Measure::new(metric, "-", error, 0.0, SERIES).within(0.01, 40));
            curves.push(profile(particles, across, SPEED));
        }
        let velocity = &fluid.particles().velocity;
        let flux = velocity.iter().map(|u| u.x.to_double()).sum::<f64>() / (velocity.len() as f64 * SPEED);
        let now = fluid.time().to_double() * NU / (WIDTH * WIDTH);
        let exact_flux = (0..1000).map(|k| from_rest((f64::from(k) + 0.5) * 1e-3, now)).sum::<f64>() * 1e-3;
        measures.push(Measure::new("mean velocity at 1", "u_max", flux, exact_flux, SERIES));
        Ok(Outcome::new(measures, curves).of(&fluid))
    }
}

impl Case for Poiseuille {
    fn name(&self) -> &'static str {
        "poiseuille"
    }

    fn about(&self) -> &'static str {
        "Viscous fluid at rest between two walls without slip, periodic along them, accelerated along the walls from t = 0. \
         Re = u_max L/nu = 10, c = 10 u_max. Errors of the velocity are root mean squares over the particles, over u_max."
    }

    fn resolution(&self) -> &'static str {
        "particles across"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![10, 20], vec![10, 20, 40])
    }

    fn run(&self, across: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        self.choice.solve(Weight::Wendland, self, across, pace, parallel)
    }

    fn plots(&self) -> Vec<Plot> {
        let y: Vec<f64> = (0..=100).map(|k| f64::from(k) * 0.01).collect();
        let axes = CurvePlot::new("Poiseuille flow from rest", "y/L [-]", "u/u_max [-]");
        let axes = LOOKS.iter().fold(axes, |axes, look| {
            let u: Vec<f64> = y.iter().map(|y| from_rest(*y, *look)).collect();
            axes.dashed(&format!("exact, ν t/L² = {look}"), &y, &u)
        });
        vec![Plot { name: "profiles", axes }]
    }
}
