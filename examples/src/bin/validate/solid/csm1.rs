//! CSM1 of Turek and Hron: the flag at rest.

use mps_examples::Failure;
use mps_examples::exact::{Case, Measure, Outcome, Pace};
use mps_examples::solid::flag::{CSM1, Clamp, RUBBER, SOURCE, end, flag, gravity};
use mps_neighbors::Parallel;
use mps_solid::Relaxation;

pub(crate) struct Csm1;

impl Case for Csm1 {
    fn name(&self) -> &'static str {
        "csm1"
    }

    fn about(&self) -> &'static str {
        "The flag of Turek and Hron (2006), 0.35 m x 0.02 m, E = 1.4 MPa, nu = 0.4, clamped on the arc of the cylinder, at rest under g = 2 m/s2. \
         Displacement of its end; forces are balanced to 1e-6 of the load."
    }

    fn resolution(&self) -> &'static str {
        "particles across"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![4], vec![4, 8, 16])
    }

    fn run(&self, n: usize, _: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let mut flag = flag::<f64>(n, Clamp::Arc, &RUBBER, parallel)?;
        let point = flag.point(end())?;
        let relaxation = Relaxation { tolerance: 1e-6, max_steps: 10_000_000 };
        flag.relax(parallel, &gravity(), |_, _| (), &relaxation)?;
        let moved = point.value(flag.positions()) - point.reference();
        let allowed = if n < 8 { 0.03 } else { 0.01 };
        let measure =
            |name, axis: usize| Measure::new(name, "m", moved[axis], CSM1[axis], SOURCE).within(allowed, 4);
        Ok(Outcome::new(vec![measure("ux", 0), measure("uy", 1)], Vec::new()))
    }
}
