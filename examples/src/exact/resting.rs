//! The same tank for a hundred thousand steps.

use super::case::{Case, Curve, Outcome, Pace, Plot};
use super::hydrostatic::{Watch, build};
use super::numerics::Numerics;
use crate::Failure;
use mps_io::CurvePlot;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::Parallel;

pub(crate) struct Resting;

impl Case for Resting {
    fn name(&self) -> &'static str {
        "resting"
    }

    fn about(&self) -> &'static str {
        "The tank of `hydrostatic` for 100000 steps (quick: 5000): nothing may drift, nothing may awake. \
         Measured over the last 5 % of the steps."
    }

    fn resolution(&self) -> &'static str {
        "particles per depth"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![10], vec![10, 20, 40])
    }

    fn run(&self, n: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let steps = pace.choose(5_000, 100_000);
        let mut fluid = build::<f64, 2, _>(n, WendlandGradient, &Numerics::default())?;
        let start = fluid.energy(parallel).potential;
        let mut watch = Watch::default();
        let (mut step, mut height) = (Vec::new(), Vec::new());
        while fluid.steps() < steps {
            fluid.step(parallel)?;
            if fluid.steps() * 20 > steps * 19 {
                watch.look(&fluid, parallel);
            }
            if (fluid.steps() * 200).is_multiple_of(steps) {
                step.push(fluid.steps() as f64);
                height.push(fluid.energy(parallel).potential / start);
            }
        }
        let measures = watch.measures(&fluid, start, parallel);
        let curves = vec![Curve { plot: "height", name: format!("{n} per depth"), x: step, y: height }];
        Ok(Outcome::new(measures, curves))
    }

    fn plots(&self) -> Vec<Plot> {
        let axes = CurvePlot::new("Tank at rest", "steps [-]", "height of the centre of mass [H/2]").dashed(
            "exact",
            &[0.0, 1e5],
            &[1.0, 1.0],
        );
        vec![Plot { name: "height", axes }]
    }
}
