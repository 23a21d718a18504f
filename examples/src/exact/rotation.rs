//! A drop that turns like a rigid body.

use super::case::{Case, Curve, Measure, Outcome, Pace, Plot};
use super::drop::{RADIUS, disc};
use super::measures::angular_momentum;
use super::scene::{RHO, Water, advance_in_central_field, press, water};
use crate::{Failure, Watch};
use core::f64::consts::PI;
use mps_fluid::{ArtificialViscosity, Boundary, Fluid};
use mps_io::CurvePlot;
use mps_kernel::Vector;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::{Open, Parallel};

pub(crate) struct Rotation;

/// Angular velocity \[1/s\].
const TURN: f64 = 1.0;
/// The field's frequency \[1/s\]; above [`TURN`], so that the drop is under pressure.
const OMEGA: f64 = 1.5;
const RIGID: &str = "analytic: rigid rotation, p = rho (omega^2 - w^2)(R^2 - r^2)/2";

fn build(per_radius: usize) -> Result<Water<2, ArtificialViscosity<f64>>, Failure> {
    let config = water(RADIUS / per_radius as f64, 15.0 * OMEGA * RADIUS);
    let mut particles = disc(per_radius);
    for (u, r) in particles.velocity.iter_mut().zip(&particles.position) {
        *u = Vector::from([-TURN * r.y, TURN * r.x]);
    }
    let centre = 0.5 * RHO * (OMEGA * OMEGA - TURN * TURN);
    press(&mut particles, &config, |r| centre * (RADIUS * RADIUS - r.norm_squared()));
    let c = config.sound_speed;
    let viscosity = |r: &_| ArtificialViscosity::new::<2>(0.02, c, r);
    Ok(Fluid::new(config, WendlandGradient, viscosity, Open, particles, Boundary::default())?)
}

impl Case for Rotation {
    fn name(&self) -> &'static str {
        "rotation"
    }

    fn about(&self) -> &'static str {
        "A disc of radius 1 m in the field -omega^2 r, omega = 1.5/s, turns with w = 1/s for one turn. Artificial viscosity 0.02, which a rigid \
         rotation must not feel, c = 15 omega R. Pressure: root mean square over the particles at the end."
    }

    fn resolution(&self) -> &'static str {
        "particles per radius"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![10], vec![10, 20, 30])
    }

    fn run(&self, n: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let end = pace.choose(0.5, 1.0) * 2.0 * PI / TURN;
        let mut fluid = build(n)?;
        let start = angular_momentum(fluid.particles());
        let energy = fluid.energy(parallel).kinetic;
        let mut turn = 0.0_f64;
        let (mut time, mut kinetic) = (Vec::new(), Vec::new());
        advance_in_central_field(&mut fluid, parallel, &Watch::nobody(), OMEGA, end, |fluid| {
            turn = turn.max((angular_momentum(fluid.particles()) / start - 1.0).abs());
            time.push(fluid.time());
            kinetic.push(fluid.energy(parallel).kinetic / energy);
        })?;
        let particles = fluid.particles();
        let (r, u) = (&particles.position, &particles.velocity);
        let rigid = |(r, u): (&Vector<f64, 2>, &Vector<f64, 2>)| {
            (u - Vector::from([-TURN * r.y, TURN * r.x])).norm_squared()
        };
        let off = (r.iter().zip(u).map(rigid).sum::<f64>() / r.len() as f64).sqrt() / (TURN * RADIUS);
        let centre = 0.5 * RHO * (OMEGA * OMEGA - TURN * TURN) * RADIUS * RADIUS;
        let pressure = super::measures::rms(
            particles,
            |i| particles.pressure[i] / centre,
            |r| (1.0 - r.norm_squared() / (RADIUS * RADIUS)).max(0.0),
        );
        let kept = kinetic.last().copied().unwrap_or(f64::NAN);
        let measures = vec![
            Measure::new("angular momentum, largest change", "-", turn, 0.0, "conserved").within(1e-12, 0),
            Measure::new("kinetic energy at the end", "E0", kept, 1.0, RIGID),
            Measure::new("velocity, L2 error", "w R", off, 0.0, RIGID),
            Measure::new("pressure, L2 error", "p at the centre", pressure, 0.0, RIGID),
        ];
        let curves = vec![Curve { plot: "energy", name: format!("{n} per radius"), x: time, y: kinetic }];
        Ok(Outcome::new(measures, curves))
    }

    fn plots(&self) -> Vec<Plot> {
        let axes = CurvePlot::new("Rigid rotation", "time [s]", "kinetic energy [E₀]");
        vec![Plot { name: "energy", axes: axes.dashed("exact", &[0.0, 2.0 * PI], &[1.0, 1.0]) }]
    }
}
