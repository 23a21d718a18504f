//! A tank of water at rest, in two and three dimensions.

use super::case::{Case, Curve, Measure, Outcome, Pace, Plot};
use super::measures::{level, rms};
use super::numerics::{Choice, Numerics, Problem};
use super::scene::{GRAVITY, RHO, SOUND, advance, heavy_water, tank};
use crate::Failure;
use crate::scene::Viscous;
use mps_fluid::Fluid;
use mps_io::CurvePlot;
use mps_io::scene_file::{Viscosity, Weight};
use mps_kernel::{Kernel, Real};
use mps_neighbors::Parallel;

/// In `D` dimensions.
pub(crate) struct Hydrostatic<const D: usize> {
    pub(crate) choice: Choice,
}

/// Depth and width of the tank \[m\].
pub(crate) const DEPTH: f64 = 1.0;
/// Strength of the artificial viscosity, as in the elastic gate.
const ALPHA: f64 = 0.02;
const LAW: &str = "analytic: p = rho g (H - y)";

/// The tank with its viscosity.
pub(crate) type Tank<T, const D: usize, K> = Fluid<T, D, K, Viscous<T>>;

/// A tank `n` particles deep and wide.
pub(crate) fn build<T: Real, const D: usize, K: Kernel<T>>(
    n: usize,
    weight: K,
    numerics: &Numerics,
) -> Result<Tank<T, D, K>, Failure> {
    let mut config = heavy_water::<T, D>(DEPTH / n as f64, DEPTH, numerics.sound_ratio.unwrap_or(SOUND));
    numerics.apply(&mut config);
    let (own, described) = (Viscosity::Artificial(ALPHA), config.clone());
    tank([n; D], config, weight, |r| numerics.viscous(own, &described, r))
}

/// Largest values over a span of time: what counts as the state of the tank.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Watch {
    pressure: f64,
    samples: f64,
    kinetic: f64,
}

impl Watch {
    pub(crate) fn look<T: Real, const D: usize, K: Kernel<T>>(
        &mut self,
        fluid: &Tank<T, D, K>,
        parallel: &Parallel,
    ) {
        self.pressure += pressure_error(fluid).powi(2);
        self.samples += 1.0;
        let energy = fluid.energy(parallel);
        self.kinetic = self.kinetic.max((energy.kinetic / energy.potential).to_double());
    }

    /// The measures of a tank whose potential energy was `start` in the beginning.
    pub(crate) fn measures<T: Real, const D: usize, K: Kernel<T>>(
        &self,
        fluid: &Tank<T, D, K>,
        start: f64,
        parallel: &Parallel,
    ) -> Vec<Measure> {
        let top = level(fluid.particles(), DEPTH, fluid.config().spacing.to_double()) / DEPTH;
        let potential = fluid.energy(parallel).potential.to_double() / start;
        let pressure = (self.pressure / self.samples).sqrt();
        vec![
            Measure::new("pressure, L2 error", "rho g H", pressure, 0.0, LAW).within(0.01, 40),
            Measure::new("level", "H", top, 1.0, "analytic: at rest").within(0.005, 40),
            Measure::new("centre of mass", "H/2", potential, 1.0, "analytic: at rest").within(0.005, 40),
            Measure::new("kinetic/potential energy", "-", self.kinetic, 0.0, "analytic: at rest")
                .within(1e-5, 40),
        ]
    }
}

fn pressure_error<T: Real, const D: usize, K: Kernel<T>>(fluid: &Tank<T, D, K>) -> f64 {
    let particles = fluid.particles();
    let bottom = RHO * GRAVITY * DEPTH;
    rms(particles, |i| particles.pressure[i].to_double() / bottom, |r| 1.0 - r[D - 1] / DEPTH)
}

impl<const D: usize> Problem for Hydrostatic<D> {
    fn solve<T: Real, K: Kernel<T>>(
        &self,
        weight: K,
        n: usize,
        pace: Pace,
        parallel: &Parallel,
    ) -> Result<Outcome, Failure> {
        let end = if D == 2 { pace.choose(2.0, 10.0) } else { pace.choose(0.5, 2.0) };
        let mut fluid = build::<T, D, K>(n, weight, &self.choice.numerics)?;
        let start = fluid.energy(parallel).potential.to_double();
        let mut watch = Watch::default();
        let (mut time, mut kinetic) = (Vec::new(), Vec::new());
        advance(&mut fluid, parallel, &self.choice.watch, end, |fluid| {
            if fluid.steps().is_multiple_of(20) {
                time.push(fluid.time().to_double());
                kinetic.push(fluid.energy(parallel).kinetic.to_double() / start);
            }
            if fluid.time().to_double() > 0.95 * end {
                watch.look(fluid, parallel);
            }
        })?;
        let particles = fluid.particles();
        let scale = RHO * GRAVITY * DEPTH;
        let name = format!("{n} per depth");
        let curves = vec![
            Curve { plot: "energy", name: name.clone(), x: time, y: kinetic },
            Curve {
                plot: "pressure",
                name,
                // A line with gaps, one dot a particle, would cost more than it tells: one column.
                x: middle_column(particles, |i| particles.position[i][D - 1].to_double() / DEPTH),
                y: middle_column(particles, |i| particles.pressure[i].to_double() / scale),
            },
        ];
        Ok(Outcome::new(watch.measures(&fluid, start, parallel), curves).of(&fluid))
    }
}

impl<const D: usize> Case for Hydrostatic<D> {
    fn name(&self) -> &'static str {
        if D == 2 { "hydrostatic" } else { "hydrostatic-3d" }
    }

    fn about(&self) -> &'static str {
        "An open tank as wide as deep, filled with an upright lattice with hydrostatic pressure, left alone for 10 s (in 3D 2 s). \
         c = 10 sqrt(g H), artificial viscosity 0.02. Pressure: root mean square over particles and the last 5 % of the time; kinetic \
         energy: largest of the same time."
    }

    fn resolution(&self) -> &'static str {
        "particles per depth"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        match D {
            2 => pace.choose(vec![10, 20], vec![10, 20, 40]),
            _ => pace.choose(vec![8], vec![8, 10, 12]),
        }
    }

    fn run(&self, n: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        self.choice.solve(Weight::Smooth, self, n, pace, parallel)
    }

    fn plots(&self) -> Vec<Plot> {
        vec![
            Plot {
                name: "pressure",
                axes: CurvePlot::new("Tank at rest", "y/H [-]", "p/(ρ g H) [-]").dashed(
                    "exact",
                    &[0.0, 1.0],
                    &[1.0, 0.0],
                ),
            },
            Plot {
                name: "energy",
                axes: CurvePlot::new("Tank at rest", "time [s]", "kinetic/potential energy [-]")
                    .log_y()
                    .dashed("target", &[0.0, 10.0], &[1e-5, 1e-5]),
            },
        ]
    }
}

/// Values of the particles of the middle tenth of the tank, from the bottom up.
fn middle_column<T: Real, const D: usize>(
    particles: &mps_fluid::FluidParticles<T, D>,
    value: impl Fn(usize) -> f64,
) -> Vec<f64> {
    let near = |i: &usize| {
        (0..D - 1).all(|axis| (particles.position[*i][axis].to_double() - 0.5 * DEPTH).abs() < 0.05)
    };
    let mut column: Vec<usize> = (0..particles.position.len()).filter(near).collect();
    let height = |i: usize| particles.position[i][D - 1].to_double();
    column.sort_by(|a, b| height(*a).total_cmp(&height(*b)));
    column.into_iter().map(value).collect()
}
