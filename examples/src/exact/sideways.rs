//! A closed tank accelerated sideways: the pressure tilts.

use super::case::{Case, Measure, Outcome, Pace};
use super::scene::{GRAVITY, RHO, Water, lattice, walls, water};
use crate::Failure;
use crate::series::slope;
use mps_fluid::{ArtificialViscosity, Fluid, FluidParticles, Tension};
use mps_kernel::Vector;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::{Open, Parallel};

pub(crate) struct Sideways;

/// Side of the box \[m\].
const SIDE: f64 = 1.0;
/// Its acceleration \[m/s^2\].
const ACCELERATION: f64 = 3.0;
const TILTED: &str = "analytic: grad p = rho (g - a)";

fn build(n: usize) -> Result<Water<2, ArtificialViscosity<f64>>, Failure> {
    let l0 = SIDE / n as f64;
    // The error of compression, of the order of p/(rho c^2) in the slopes, is a quarter of that with the usual 10.
    let mut config = water(l0, 20.0 * (GRAVITY * SIDE).sqrt());
    config.gravity[1] = -GRAVITY;
    config.tension = Tension::Keep;
    let mut particles = FluidParticles::at_rest(lattice([0.0; 2], [n, n], l0));
    // Pressed together, so that no pressure is negative.
    let pressed = RHO * (GRAVITY + ACCELERATION) * SIDE;
    super::scene::press(&mut particles, &config, |_| pressed);
    let mut boundary = walls([n, n], None, l0);
    boundary.acceleration.fill(Vector::from([ACCELERATION, 0.0]));
    // The same viscosity at every resolution.
    let (c, alpha) = (config.sound_speed, 0.025 * n as f64);
    let viscosity = |r: &_| ArtificialViscosity::new::<2>(alpha, c, r);
    Ok(Fluid::new(config, WendlandGradient, viscosity, Open, particles, boundary)?)
}

impl Case for Sideways {
    fn name(&self) -> &'static str {
        "sideways"
    }

    fn about(&self) -> &'static str {
        "A closed box full of water, pressed together a little so that no pressure is negative, is accelerated sideways with 3 m/s2 under \
         gravity from rest. c = 20 sqrt(g L), artificial viscosity 0.5 at 20 per side and the same viscosity at the others against the sound of the sudden start. Slopes of the pressure by least squares \
         over the particles, and the distance from the plane of the exact slopes, both over the second half of 3 s."
    }

    fn resolution(&self) -> &'static str {
        "particles per side"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![10], vec![10, 20, 40])
    }

    fn run(&self, n: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let mut fluid = build(n)?;
        let end = pace.choose(2.0, 3.0);
        let acceleration = Vector::from([ACCELERATION, 0.0]);
        let (mut tilt, mut rms, mut count) = ([0.0; 2], 0.0, 0.0);
        let mut moved = 0.0;
        while fluid.time() < end {
            let dt = fluid.begin_step(parallel)?;
            if fluid.time() > 0.5 * end {
                let found = slopes(&fluid, moved);
                tilt = [tilt[0] + found[0], tilt[1] + found[1]];
                rms += found[2];
                count += 1.0;
            }
            let velocity = acceleration * (fluid.time() + dt);
            fluid.boundary_mut().velocity.fill(velocity);
            fluid.finish_step(parallel, dt);
            fluid.boundary_mut().position.iter_mut().for_each(|r| *r += velocity * dt);
            moved += velocity.x * dt;
        }
        let measures = vec![
            Measure::new("slope along x", "Pa/m", tilt[0] / count, -RHO * ACCELERATION, TILTED)
                .within(0.01, 40),
            Measure::new("slope along y", "Pa/m", tilt[1] / count, -RHO * GRAVITY, TILTED).within(0.01, 40),
            Measure::new(
                "pressure, L2 error",
                "rho g L",
                (rms / count).sqrt() / (RHO * GRAVITY * SIDE),
                0.0,
                TILTED,
            )
            .within(0.01, 40),
        ];
        Ok(Outcome::new(measures, Vec::new()))
    }
}

/// Slopes of the pressure along both axes \[Pa/m\] and the mean square of what the exact plane leaves \[Pa^2\].
fn slopes(fluid: &Water<2, ArtificialViscosity<f64>>, moved: f64) -> [f64; 3] {
    let particles = fluid.particles();
    let along = |axis: usize| particles.position.iter().map(|r| r[axis]).collect::<Vec<_>>();
    let p = &particles.pressure;
    let mean = p.iter().sum::<f64>() / p.len() as f64;
    let plane = |r: &Vector<f64, 2>| {
        mean - RHO * (ACCELERATION * (r.x - moved - 0.5 * SIDE) + GRAVITY * (r.y - 0.5 * SIDE))
    };
    let rest = particles.position.iter().zip(p).map(|(r, p)| (p - plane(r)).powi(2)).sum::<f64>();
    [slope(&along(0), p), slope(&along(1), p), rest / p.len() as f64]
}
