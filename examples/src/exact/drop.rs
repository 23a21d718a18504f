//! A drop in a central field that swings between a disc and ellipses.

use super::case::{Case, Curve, Measure, Outcome, Pace, Plot};
use super::measures::{angular_momentum, angular_size, in_double, states};
use super::numerics::{Choice, Numerics, Problem};
use super::scene::{RHO, advance_in_central_field, lattice, press, water};
use crate::Failure;
use crate::scene::Viscous;
use crate::series::zeros;
use mps_fluid::{Boundary, Fluid, FluidParticles};
use mps_io::CurvePlot;
use mps_io::scene_file::Weight;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Open, Parallel};

pub(crate) struct Drop {
    pub(crate) choice: Choice,
}

/// Without viscosity.
type Inviscid<T, K> = Fluid<T, 2, K, Viscous<T>>;

/// Radius at rest \[m\] and the field's frequency \[1/s\]: acceleration `-omega^2 r`.
pub(crate) const RADIUS: f64 = 1.0;
const OMEGA: f64 = 1.0;
/// Rate of strain at the start \[1/s\]: velocity `(s x, -s y)`.
const STRAIN: f64 = 0.5;
const ODE: &str =
    "exact ODE (Monaghan and Rafiee 2013): s' = (s^2 + omega^2)(b^2 - a^2)/(a^2 + b^2), a' = s a, b' = -s b";

/// Strain rate and semi-axes: `[s, a, b]`.
type State = [f64; 3];

fn slope([s, a, b]: State) -> State {
    [(s * s + OMEGA * OMEGA) * (b * b - a * a) / (a * a + b * b), s * a, -s * b]
}

/// One step of Runge and Kutta.
fn step(state: State, dt: f64) -> State {
    let ahead = |k: State, h: f64| core::array::from_fn(|i| state[i] + h * k[i]);
    let k1 = slope(state);
    let k2 = slope(ahead(k1, 0.5 * dt));
    let k3 = slope(ahead(k2, 0.5 * dt));
    let k4 = slope(ahead(k3, dt));
    core::array::from_fn(|i| state[i] + dt / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
}

/// Times and states to `end` \[s\].
fn exact(end: f64) -> (Vec<f64>, Vec<State>) {
    let dt = 1e-3;
    let steps = (end / dt).ceil() as usize;
    let mut states = vec![[STRAIN, RADIUS, RADIUS]];
    for k in 0..steps {
        states.push(step(states[k], dt));
    }
    ((0..=steps).map(|k| k as f64 * dt).collect(), states)
}

/// Mean distance between every second zero of the strain rate: the period.
fn period(time: &[f64], strain: &[f64]) -> f64 {
    let zeros = zeros(time, strain);
    match (zeros.first(), zeros.last()) {
        (Some(first), Some(last)) if zeros.len() > 2 => 2.0 * (last - first) / (zeros.len() - 1) as f64,
        _ => f64::NAN,
    }
}

/// A disc cut from the lattice, with its centre between four particles.
pub(crate) fn disc<T: Real>(per_radius: usize) -> FluidParticles<T, 2> {
    let l0 = RADIUS / per_radius as f64;
    let mut points = lattice([-RADIUS; 2], [2 * per_radius; 2], l0);
    points.retain(|r: &Vector<T, 2>| in_double(r).norm() < RADIUS);
    FluidParticles::at_rest(points)
}

/// The strain rate that fits the velocities best.
fn strain<T: Real>(particles: &FluidParticles<T, 2>) -> f64 {
    let (mut along, mut size) = (0.0, 0.0);
    for (r, u) in states(particles) {
        along += r.x * u.x - r.y * u.y;
        size += r.norm_squared();
    }
    along / size
}

fn build<T: Real, K: Kernel<T>>(
    per_radius: usize,
    weight: K,
    numerics: &Numerics,
) -> Result<Inviscid<T, K>, Failure> {
    let sound = numerics.sound_ratio.unwrap_or(15.0);
    let mut config = water(RADIUS / per_radius as f64, sound * OMEGA * RADIUS);
    numerics.apply(&mut config);
    let mut particles = disc::<T>(per_radius);
    for (u, r) in particles.velocity.iter_mut().zip(&particles.position) {
        *u = Vector::from([T::of(STRAIN) * r.x, -T::of(STRAIN) * r.y]);
    }
    // At the start, a = b: s' = 0, and p = rho (s^2 + omega^2)(R^2 - r^2)/2.
    let centre = 0.5 * RHO * (STRAIN * STRAIN + OMEGA * OMEGA);
    press(&mut particles, &config, |r| T::of(centre * (RADIUS * RADIUS - in_double(r).norm_squared())));
    Ok(Fluid::new(config, weight, |_| Viscous::None, Open, particles, Boundary::default())?)
}

/// Kinetic energy and that in the field \[J\].
fn energy<T: Real, K: Kernel<T>>(fluid: &Inviscid<T, K>, parallel: &Parallel) -> f64 {
    let field: f64 = states(fluid.particles()).map(|(r, _)| r.norm_squared()).sum();
    let mass = fluid.config().particle_mass().to_double();
    fluid.energy(parallel).total().to_double() + 0.5 * mass * OMEGA * OMEGA * field
}

impl Problem for Drop {
    fn solve<T: Real, K: Kernel<T>>(
        &self,
        weight: K,
        n: usize,
        pace: Pace,
        parallel: &Parallel,
    ) -> Result<Outcome, Failure> {
        let end = pace.choose(8.0, 9.5);
        let mut fluid = build::<T, K>(n, weight, &self.choice.numerics)?;
        let start = energy(&fluid, parallel);
        let mass = fluid.config().particle_mass().to_double();
        let size = mass * states(fluid.particles()).map(|(_, u)| u.norm()).sum::<f64>();
        let angular = angular_size(fluid.particles());
        let (mut time, mut rate) = (Vec::new(), Vec::new());
        let (mut drift, mut turn) = (0.0_f64, 0.0_f64);
        advance_in_central_field(&mut fluid, parallel, &self.choice.watch, OMEGA, end, |fluid| {
            time.push(fluid.time().to_double());
            rate.push(strain(fluid.particles()));
            drift = drift.max(in_double(&fluid.momentum(parallel)).norm() / size);
            turn = turn.max(angular_momentum(fluid.particles()).abs() / angular);
        })?;
        let (exact_time, states) = exact(end);
        let exact_rate: Vec<f64> = states.iter().map(|state| state[0]).collect();
        let largest = |time: &[f64], rate: &[f64]| {
            let late = time.iter().zip(rate).filter(|(t, _)| **t > end - 4.6);
            late.map(|(_, s)| s.abs()).fold(0.0, f64::max)
        };
        let true_period = period(&exact_time, &exact_rate);
        let lost = energy(&fluid, parallel) / start;
        let mut measures = vec![
            Measure::new("period", "s", period(&time, &rate), true_period, ODE).within(0.01, 50),
            Measure::new(
                "strain rate, largest in the last period",
                "1/s",
                largest(&time, &rate),
                STRAIN,
                ODE,
            ),
            Measure::new("energy at the end", "E0", lost, 1.0, "conserved"),
        ];
        let momenta = [("momentum", drift), ("angular momentum", turn)].map(|(metric, value)| {
            let measure = Measure::new(metric, "-", value, 0.0, "conserved");
            measure.within(1e-12, 0)
        });
        measures.extend(momenta);
        let curves = vec![Curve { plot: "strain", name: format!("{n} per radius"), x: time, y: rate }];
        Ok(Outcome::new(measures, curves).of(&fluid))
    }
}

impl Case for Drop {
    fn name(&self) -> &'static str {
        "drop"
    }

    fn about(&self) -> &'static str {
        "A disc of radius 1 m in the field -omega^2 r, omega = 1/s, with the velocity (s x, -s y), s = 0.5/s, swings between ellipses. \
         Inviscid, c = 15 omega R. The strain rate is the one that fits the velocities best. Momenta are relative to the sum of the sizes of \
         their terms, the energy (kinetic, field and compression) to that of the start."
    }

    fn resolution(&self) -> &'static str {
        "particles per radius"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![10, 15], vec![12, 25, 50])
    }

    fn run(&self, n: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        self.choice.solve(Weight::Smooth, self, n, pace, parallel)
    }

    fn plots(&self) -> Vec<Plot> {
        let (time, states) = exact(9.5);
        let rate: Vec<f64> = states.iter().map(|state| state[0]).collect();
        let axes = CurvePlot::new("Oscillating drop", "time [s]", "strain rate [1/s]");
        vec![Plot { name: "strain", axes: axes.dashed("exact", &time, &rate) }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ellipse_keeps_area_and_energy_and_has_the_published_period() {
        let (time, states) = exact(20.0);
        let energy = |[s, a, b]: &State| (s * s + OMEGA * OMEGA) * (a * a + b * b);
        for state in &states {
            assert!((state[1] * state[2] - 1.0).abs() < 1e-9);
            assert!((energy(state) / energy(&states[0]) - 1.0).abs() < 1e-9);
        }
        let strain: Vec<f64> = states.iter().map(|state| state[0]).collect();
        let found = period(&time, &strain);
        // 4.567375 s in the documentation of TrixiParticles.jl, from the same equations.
        assert!((found - 4.567375).abs() < 1e-5, "{found}");
    }
}
