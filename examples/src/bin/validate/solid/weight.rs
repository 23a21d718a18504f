//! A beam under its own weight.

use super::scene::{V, solid};
use mps_examples::Failure;
use mps_examples::exact::{Case, Measure, Outcome, Pace};
use mps_neighbors::Parallel;
use mps_solid::Relaxation;
use mps_solid::body::{Face, block, counts};
use mps_solid::materials::SaintVenantKirchhoff;

pub(crate) struct Weight;

/// Length and thickness \[m\].
const SIZE: [f64; 2] = [0.35, 0.02];
/// How far the end sinks \[m\].
const SAG: f64 = 0.016_821_3;
const ELEMENTS: &str = "quadratic finite elements, plane strain, 140 x 8";

impl Case for Weight {
    fn name(&self) -> &'static str {
        "weight"
    }

    fn about(&self) -> &'static str {
        "A beam 0.35 m x 0.02 m, Saint Venant-Kirchhoff with E = 1.4 MPa, nu = 0.4, clamped on the plane of its left end and loaded by 10 N/m, at \
         rest. How far the middle of its end sinks; forces are balanced to 1e-6 of the load."
    }

    fn resolution(&self) -> &'static str {
        "particles across"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![4], vec![4, 8, 16])
    }

    fn run(&self, n: usize, _: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let clamp = [Face::lower(0)];
        let upper = V::from(SIZE);
        let counts = counts(&V::zeros(), &upper, SIZE[1] / n as f64, &clamp);
        let beam = block(V::zeros(), upper, counts, &clamp)?;
        let mut beam = solid(&beam, 500.0, SaintVenantKirchhoff::new(1.4e6, 0.4)?, parallel)?;
        let end = beam.point(V::new(SIZE[0], 0.5 * SIZE[1]))?;
        let relaxation = Relaxation { tolerance: 1e-6, ..Relaxation::default() };
        beam.relax(parallel, &V::new(0.0, -1.0), |_, _| (), &relaxation)?;
        let sag = end.reference().y - end.value(beam.positions()).y;
        let sag = Measure::new("sag of the end", "m", sag, SAG, ELEMENTS);
        Ok(Outcome::new(vec![sag.within(if n < 8 { 0.02 } else { 0.01 }, 4)], Vec::new()))
    }
}
