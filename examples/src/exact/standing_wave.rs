//! A standing gravity wave: period and viscous decay.

use super::case::{Case, Curve, Measure, Outcome, Pace, Plot};
use super::measures::{in_double, states};
use super::numerics::{Choice, Numerics, Problem};
use super::scene::{GRAVITY, SOUND, advance, heavy_water, tank};
use super::viscous_wave::ViscousWave;
use crate::scene::Viscous;
use crate::series::{decay_rate, peaks_between, zeros};
use crate::{Failure, Refused};
use core::f64::consts::PI;
use mps_fluid::Fluid;
use mps_io::CurvePlot;
use mps_io::scene_file::{Viscosity, Weight};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::Parallel;

/// The wave at one viscosity.
pub(crate) struct StandingWave {
    name: &'static str,
    about: &'static str,
    /// `H sqrt(g H)/nu`.
    re: f64,
    choice: Choice,
}

/// The wave whose period and decay are targets.
pub(crate) fn wave(choice: Choice) -> StandingWave {
    StandingWave {
        name: "standing-wave",
        about: "The first mode of a tank 2 m long and 1 m deep, started with the velocities of the linear wave of height 0.03 m under a flat \
            surface. Walls with free slip, viscosity along the pairs (`ArtificialViscosity`) that amounts to Re = H sqrt(g H)/nu = 250, c = 10 sqrt(g H), 3.6 periods. \
            Period and decay are those of the share of the mode in the velocities; the decay rate of its square is that of the energy.",
        re: 250.0,
        choice,
    }
}

/// More viscous: what the scheme loses without viscosity counts less.
pub(crate) fn viscous(choice: Choice) -> StandingWave {
    StandingWave { name: "standing-wave-50", about: "As standing-wave, with Re = 50.", re: 50.0, choice }
}

/// Depth \[m\].
const DEPTH: f64 = 1.0;
/// Length of the wave and of the tank \[m\].
const LENGTH: f64 = 2.0;
/// Height of the crest over the mean level \[m\].
const AMPLITUDE: f64 = 0.03;
/// Wave number \[1/m\].
const K: f64 = 2.0 * PI / LENGTH;
const LINEAR: &str =
    "linearised Navier-Stokes: (s + 2 nu k^2)^2 + g k tanh(k H) = 4 nu^2 k^3 m tanh(k H) coth(m H)";

type Wave<T, K> = Fluid<T, 2, K, Viscous<T>>;

fn omega() -> f64 {
    (GRAVITY * K * (K * DEPTH).tanh()).sqrt()
}

/// Velocity of the linear wave when the surface is flat, for an amplitude of one \[1/s\].
fn mode(r: &Vector<f64, 2>) -> Vector<f64, 2> {
    let (x, y) = (K * r.x, K * r.y);
    let size = omega() / (K * DEPTH).sinh();
    Vector::from([x.sin() * y.cosh(), -x.cos() * y.sinh()]) * size
}

/// Viscosity along the line of each pair: only such a one leaves a free surface without shear stress. The Laplacian
/// of the velocity, harmless elsewhere, would leave it without `nu du/dn`, and potential flow with half its decay.
fn build<T: Real, K: Kernel<T>>(
    per_wave: usize,
    nu: f64,
    weight: K,
    numerics: &Numerics,
) -> Result<Wave<T, K>, Failure> {
    let l0 = LENGTH / per_wave as f64;
    let mut config = heavy_water::<T, 2>(l0, DEPTH, numerics.sound_ratio.unwrap_or(SOUND));
    numerics.apply(&mut config);
    // alpha c l0/(2 (D + 2)) = nu
    let alpha = 8.0 * nu / (config.sound_speed.to_double() * l0);
    let rows = (DEPTH / l0).round() as usize;
    let (own, described) = (Viscosity::Artificial(alpha), config.clone());
    let mut fluid = tank([per_wave, rows], config, weight, |r| numerics.viscous(own, &described, r))?;
    let particles = fluid.particles_mut();
    for (u, r) in particles.velocity.iter_mut().zip(&particles.position) {
        *u = (mode(&in_double(r)) * AMPLITUDE).map(T::of);
    }
    Ok(fluid)
}

/// Share of the wave's mode in the velocities, over that of the start.
fn share<T: Real, K: Kernel<T>>(fluid: &Wave<T, K>) -> f64 {
    let (mut along, mut size) = (0.0, 0.0);
    for (r, u) in states(fluid.particles()) {
        let mode = mode(&r);
        along += mode.dot(&u);
        size += mode.norm_squared();
    }
    along / (size * AMPLITUDE)
}

impl StandingWave {
    fn exact(&self) -> ViscousWave {
        let viscosity = DEPTH * (GRAVITY * DEPTH).sqrt() / self.re;
        ViscousWave { k: K, depth: DEPTH, gravity: GRAVITY, viscosity }
    }
}

impl Problem for StandingWave {
    fn solve<T: Real, K: Kernel<T>>(
        &self,
        weight: K,
        n: usize,
        pace: Pace,
        parallel: &Parallel,
    ) -> Result<Outcome, Failure> {
        let exact = self.exact();
        let mut fluid = build::<T, K>(n, exact.viscosity, weight, &self.choice.numerics)?;
        let period = 2.0 * PI / omega();
        let (mut time, mut amplitude) = (Vec::new(), Vec::new());
        advance(&mut fluid, parallel, &self.choice.watch, pace.choose(2.6, 3.6) * period, |fluid| {
            time.push(fluid.time().to_double());
            amplitude.push(share(fluid));
        })?;
        let zeros = zeros(&time, &amplitude);
        let (first, last) = (zeros.first().copied(), zeros.last().copied());
        let found = 2.0 * (last.unwrap_or(f64::NAN) - first.unwrap_or(f64::NAN)) / (zeros.len() as f64 - 1.0);
        let (at, height): (Vec<_>, Vec<_>) = peaks_between(&time, &amplitude, &zeros).into_iter().unzip();
        let decay = 2.0 * decay_rate(&at, &height);
        let root = exact.root();
        let measures = vec![
            Measure::new("period", "s", found, 2.0 * PI / root.im, LINEAR).within(0.01, 100),
            Measure::new("decay rate of the energy", "1/s", decay, -2.0 * root.re, LINEAR).within(0.1, 100),
        ];
        let time = time.iter().map(|t| t / period).collect();
        let curves = vec![Curve { plot: "mode", name: format!("{n} per wavelength"), x: time, y: amplitude }];
        Ok(Outcome::new(measures, curves).of(&fluid))
    }
}

impl Case for StandingWave {
    fn name(&self) -> &'static str {
        self.name
    }

    fn about(&self) -> &'static str {
        self.about
    }

    fn resolution(&self) -> &'static str {
        "particles per wavelength"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![24, 32], vec![32, 64, 100])
    }

    fn check(&self, n: usize) -> Result<(), Refused> {
        let remedy = "the tank is half as deep as long: give an even number of particles, e.g. 32";
        Refused::unless(n.is_multiple_of(2), "--resolution", n, remedy)
    }

    fn run(&self, n: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        self.choice.solve(Weight::Smooth, self, n, pace, parallel)
    }

    fn plots(&self) -> Vec<Plot> {
        let time: Vec<f64> = (0..=360).map(|k| f64::from(k) * 0.01).collect();
        let s = self.exact().root() * (2.0 * PI / omega());
        let exact: Vec<f64> = time.iter().map(|t| (s.re * t).exp() * (s.im * t).cos()).collect();
        let title = format!("Standing wave, Re = {}", self.re);
        let axes = CurvePlot::new(&title, "t/T [-]", "share of the mode [-]");
        vec![Plot { name: "mode", axes: axes.dashed("exact", &time, &exact) }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mode_is_a_potential_flow_along_the_walls_that_lifts_the_surface() {
        let h = 1e-5;
        let r = Vector::from([0.3, 0.7]);
        let (dx, dy) = (Vector::from([h, 0.0]), Vector::from([0.0, h]));
        let by_x = (mode(&(r + dx)) - mode(&(r - dx))) / (2.0 * h);
        let by_y = (mode(&(r + dy)) - mode(&(r - dy))) / (2.0 * h);
        assert!((by_x.x + by_y.y).abs() < 1e-6 && (by_x.y - by_y.x).abs() < 1e-6);
        assert!(mode(&Vector::from([0.0, 0.5])).x.abs() < 1e-12);
        assert!(mode(&Vector::from([LENGTH, 0.5])).x.abs() < 1e-12);
        assert!(mode(&Vector::from([0.4, 0.0])).y.abs() < 1e-12);
        // The surface moves with amplitude times omega.
        assert!((mode(&Vector::from([0.0, DEPTH])).y + omega()).abs() < 1e-12);
        assert!((2.0 * PI / omega() - 1.13392).abs() < 1e-4, "{}", 2.0 * PI / omega());
    }
}
