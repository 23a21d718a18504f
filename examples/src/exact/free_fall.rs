//! A tank in free fall: no pressure.

use super::case::{Case, Measure, Outcome, Pace};
use super::scene::{GRAVITY, RHO, SOUND, heavy_water, tank};
use crate::Failure;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::Parallel;

pub(crate) struct FreeFall;

const DEPTH: f64 = 1.0;

impl Case for FreeFall {
    fn name(&self) -> &'static str {
        "free-fall"
    }

    fn about(&self) -> &'static str {
        "An open tank with water without pressure, let go together with its walls, for 0.5 s. c = 10 sqrt(g H), inviscid."
    }

    fn resolution(&self) -> &'static str {
        "particles per depth"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![10], vec![10, 20, 40])
    }

    fn run(&self, n: usize, _pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let config = heavy_water::<f64, 2>(DEPTH / n as f64, DEPTH, SOUND);
        let gravity = config.gravity;
        let mut fluid = tank([n, n], config, WendlandGradient, |_| ())?;
        fluid.particles_mut().density.fill(1.0);
        fluid.boundary_mut().acceleration.fill(gravity);
        let mut largest = 0.0_f64;
        while fluid.time() < 0.5 {
            let dt = fluid.begin_step(parallel)?;
            let velocity = gravity * (fluid.time() + dt);
            fluid.boundary_mut().velocity.fill(velocity);
            fluid.finish_step(parallel, dt);
            fluid.boundary_mut().position.iter_mut().for_each(|r| *r += velocity * dt);
            largest = fluid.particles().pressure.iter().fold(largest, |most, p| most.max(p.abs()));
        }
        let speed = GRAVITY * fluid.time();
        let off = |u: &mps_kernel::Vector<f64, 2>| (u.y + speed).abs().max(u.x.abs()) / speed;
        let off = fluid.particles().velocity.iter().map(off).fold(0.0, f64::max);
        let law = "analytic: everything falls with g";
        let measures = vec![
            Measure::new("largest pressure", "rho g H", largest / (RHO * GRAVITY * DEPTH), 0.0, law)
                .within(1e-6, 0),
            Measure::new("velocity, largest error", "g t", off, 0.0, law).within(1e-6, 0),
        ];
        Ok(Outcome::new(measures, Vec::new()))
    }
}
