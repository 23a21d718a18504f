//! A free body keeps its momenta, however it shakes.

use super::scene::{Noise, V, YOUNG, square};
use mps_examples::Failure;
use mps_examples::exact::{Case, Measure, Outcome, Pace};
use mps_kernel::Vector;
use mps_neighbors::Parallel;
use mps_solid::materials::NeoHookean;

pub(crate) struct Momentum;

/// Size of the velocities at the start, over the speed of sound.
const SPEED: f64 = 0.02;
const LAW: &str = "analytic: conserved";

impl Case for Momentum {
    fn name(&self) -> &'static str {
        "momentum"
    }

    fn about(&self) -> &'static str {
        "A free square of disturbed particles, neo-Hookean with nu = 0.4, with random velocities of up to 0.02 c_p on top of a translation as \
         fast, for 20000 sub-steps. Changes over the sums of the sizes of the terms."
    }

    fn resolution(&self) -> &'static str {
        "particles per side"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![10], vec![10, 20])
    }

    fn run(&self, n: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let mut solid = square(n, 0.1, NeoHookean::new(YOUNG, 0.4)?, parallel)?;
        let speed = SPEED * solid.wave_speed();
        let mut noise = Noise::default();
        for u in solid.velocities_mut() {
            *u = (noise.vector::<2>() + V::new(1.0, 0.5)) * speed;
        }
        let (rest, zero) = (vec![V::zeros(); solid.len()], V::zeros());
        let size: f64 = solid.velocities().iter().zip(solid.masses()).map(|(u, m)| u.norm() * m).sum();
        let state = |solid: &mps_solid::Solid<f64, 2, NeoHookean<f64>>| {
            let energy = solid.energy(parallel, &zero).total();
            (solid.momentum(parallel), solid.angular_momentum(parallel, &zero)[(0, 1)], energy)
        };
        let start = state(&solid);
        let dt = solid.max_step(parallel);
        let [mut linear, mut angular, mut energy] = [0.0_f64; 3];
        for _ in 0..pace.choose(20, 100) {
            solid.advance(parallel, &rest, &Vector::zeros(), 200.0 * dt, 200)?;
            let now = state(&solid);
            let reach = solid.positions().iter().map(V::norm).fold(0.0, f64::max);
            linear = linear.max((now.0 - start.0).norm() / size);
            angular = angular.max((now.1 - start.1).abs() / (size * reach));
            energy = energy.max((now.2 / start.2 - 1.0).abs());
        }
        let measures = vec![
            Measure::new("momentum, largest change", "sum of m u", linear, 0.0, LAW).within(1e-12, 0),
            Measure::new("angular momentum, largest change", "sum of m r u", angular, 0.0, LAW)
                .within(1e-12, 0),
            Measure::new("energy, largest change", "E0", energy, 0.0, LAW),
        ];
        Ok(Outcome::new(measures, Vec::new()))
    }
}
