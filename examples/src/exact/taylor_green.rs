//! The decaying vortices of Taylor and Green.

use super::case::{Case, Curve, Measure, Outcome, Pace, Plot};
use super::measures::{in_double, rms};
use super::numerics::{Choice, Numerics, Problem};
use super::scene::{InnerWater, RHO, SOUND, advance, inner_water, lattice, press};
use crate::Failure;
use crate::series::decay_rate;
use core::f64::consts::PI;
use mps_fluid::{Boundary, Fluid, FluidParticles, Shifting};
use mps_io::CurvePlot;
use mps_io::scene_file::{Viscosity, Weight};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Parallel, PeriodicBox};

/// The vortices in a fluid of one compressibility.
pub(crate) struct TaylorGreen {
    name: &'static str,
    about: &'static str,
    /// Numerical sound speed over U.
    sound: f64,
    choice: Choice,
}

/// As compressible as all cases.
pub(crate) fn vortices(choice: Choice) -> TaylorGreen {
    TaylorGreen {
        name: "taylor-green",
        about: "Four vortices in a doubly periodic square at Re = U L/nu = 100, from an upright lattice. c = 10 U, tension kept, shifting with strength 10. \
            The decay rate is that of the root of the kinetic energy, by least squares over the whole time.",
        sound: SOUND,
        choice,
    }
}

/// So little compressible that the particles err more than the Mach number.
pub(crate) fn stiff(choice: Choice) -> TaylorGreen {
    TaylorGreen {
        name: "taylor-green-30",
        about: "As taylor-green, with c = 30 U: an incompressible field can be met to about the square of the Mach number, 1 % of U with c = 10 U.",
        sound: 30.0,
        choice,
    }
}

const RE: f64 = 100.0;
/// `k = 2 pi/L` \[1/m\].
const K: f64 = 2.0 * PI;
const LAW: &str = "analytic: velocity decays with exp(-8 pi^2 U t/(Re L))";

/// Velocity at the start, over U.
fn velocity(r: &Vector<f64, 2>) -> Vector<f64, 2> {
    Vector::from([-(K * r.x).cos() * (K * r.y).sin(), (K * r.x).sin() * (K * r.y).cos()])
}

/// Pressure at the start, over `rho U^2`.
fn pressure(r: &Vector<f64, 2>) -> f64 {
    -0.25 * ((2.0 * K * r.x).cos() + (2.0 * K * r.y).cos())
}

/// Rate at which the velocity decays, over `U/L`.
fn rate() -> f64 {
    2.0 * K * K / RE
}

fn build<T: Real, K: Kernel<T>>(
    n: usize,
    sound: f64,
    weight: K,
    numerics: &Numerics,
) -> Result<InnerWater<T, K>, Failure> {
    let l0 = 1.0 / n as f64;
    let mut config = inner_water(l0, numerics.sound_ratio.unwrap_or(sound));
    // Stirred all the time: with the default of 2 some runs tear under tension.
    config.shifting = Some(Shifting { strength: T::of(10.0), ..Shifting::default() });
    numerics.apply(&mut config);
    let mut particles = FluidParticles::at_rest(lattice([0.0; 2], [n, n], l0));
    for (u, r) in particles.velocity.iter_mut().zip(&particles.position) {
        *u = velocity(&in_double(r)).map(T::of);
    }
    press(&mut particles, &config, |r| T::of(RHO * pressure(&in_double(r))));
    let domain = PeriodicBox::new(Vector::zeros(), [Some(T::one()); 2])?;
    let (own, described) = (Viscosity::Laminar(1.0 / RE), config.clone());
    let viscosity = |r: &_| numerics.viscous(own, &described, r);
    Ok(Fluid::new(config, weight, viscosity, domain, particles, Boundary::default())?)
}

impl Problem for TaylorGreen {
    fn solve<T: Real, K: Kernel<T>>(
        &self,
        weight: K,
        n: usize,
        pace: Pace,
        parallel: &Parallel,
    ) -> Result<Outcome, Failure> {
        let end = pace.choose(0.5, 1.0);
        let mut fluid = build::<T, K>(n, self.sound, weight, &self.choice.numerics)?;
        let start = fluid.energy(parallel).kinetic.to_double();
        let (mut time, mut speed) = (Vec::new(), Vec::new());
        let (mut worst, mut packing) = (0.0_f64, 0.0_f64);
        advance(&mut fluid, parallel, &self.choice.watch, end, |fluid| {
            time.push(fluid.time().to_double());
            speed.push((fluid.energy(parallel).kinetic.to_double() / start).sqrt());
            if fluid.steps().is_multiple_of(50) {
                let now = (-rate() * fluid.time().to_double()).exp();
                let particles = fluid.particles();
                let error = |axis: usize| {
                    rms(particles, |i| particles.velocity[i][axis].to_double(), |r| velocity(r)[axis] * now)
                };
                worst = worst.max(error(0).hypot(error(1)) / now);
            }
        })?;
        fluid.measure_packing(parallel)?;
        for p in fluid.packing() {
            packing += (p.to_double() - 1.0).powi(2);
        }
        let packing = (packing / fluid.packing().len() as f64).sqrt();
        let momentum = in_double(&fluid.momentum(parallel)).norm() / RHO;
        let decay = decay_rate(&time, &speed);
        let measures = vec![
            Measure::new("decay rate", "U/L", decay, rate(), LAW).within(0.02, 100),
            Measure::new("velocity, largest L2 error", "U(t)", worst, 0.0, LAW),
            Measure::new("packing, rms from 1", "-", packing, 0.0, "incompressible"),
            Measure::new("momentum", "rho U L^2", momentum, 0.0, "analytic: conserved").within(1e-12, 0),
        ];
        let curves = vec![Curve { plot: "decay", name: format!("{n} per side"), x: time, y: speed }];
        Ok(Outcome::new(measures, curves).of(&fluid))
    }
}

impl Case for TaylorGreen {
    fn name(&self) -> &'static str {
        self.name
    }

    fn about(&self) -> &'static str {
        self.about
    }

    fn resolution(&self) -> &'static str {
        "particles per side"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![20, 30], vec![25, 50, 100])
    }

    fn run(&self, n: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        self.choice.solve(Weight::Wendland, self, n, pace, parallel)
    }

    fn plots(&self) -> Vec<Plot> {
        let time: Vec<f64> = (0..=100).map(|k| f64::from(k) * 0.01).collect();
        let exact: Vec<f64> = time.iter().map(|t| (-rate() * t).exp()).collect();
        let axes = CurvePlot::new("Taylor-Green vortices, Re = 100", "t U/L [-]", "√(E/E₀) [-]").log_y();
        vec![Plot { name: "decay", axes: axes.dashed("exact", &time, &exact) }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_field_is_free_of_divergence_and_balanced_by_its_pressure() {
        let h = 1e-5;
        let step = |axis: usize| Vector::from_fn(|k, _| if k == axis { h } else { 0.0 });
        let r = Vector::from([0.13, 0.57]);
        let by = |axis: usize| (velocity(&(r + step(axis))) - velocity(&(r - step(axis)))) / (2.0 * h);
        assert!((by(0).x + by(1).y).abs() < 1e-8, "divergence");
        let carried = by(0) * velocity(&r).x + by(1) * velocity(&r).y;
        for axis in 0..2 {
            let slope = (pressure(&(r + step(axis))) - pressure(&(r - step(axis)))) / (2.0 * h);
            assert!((carried[axis] + slope).abs() < 1e-8, "u . grad u = -grad p");
        }
        assert!((rate() - 8.0 * PI * PI / 100.0).abs() < 1e-12);
    }
}
