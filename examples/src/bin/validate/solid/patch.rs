//! The patch test: a uniform deformation of a disturbed lattice is seen as it is.

use super::scene::{V, YOUNG, deform, square};
use mps_examples::Failure;
use mps_examples::exact::{Case, Measure, Outcome, Pace};
use mps_kernel::Tensor;
use mps_neighbors::Parallel;
use mps_solid::materials::NeoHookean;

pub(crate) struct Patch;

impl Case for Patch {
    fn name(&self) -> &'static str {
        "patch"
    }

    fn about(&self) -> &'static str {
        "A square whose particles are shaken by 0.2 spacings, with volumes that differ by up to 20 %, under a uniform deformation with stretches \
         up to 1.3 and a turn by 0.6 rad. The largest difference of a particle's deformation gradient, at surfaces and corners too, and of the stress \
         over E."
    }

    fn resolution(&self) -> &'static str {
        "particles per side"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![10], vec![10, 20, 40])
    }

    fn run(&self, n: usize, _: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let law = NeoHookean::new(YOUNG, 0.4)?;
        let mut solid = square(n, 0.2, law, parallel)?;
        let (sin, cos) = 0.6_f64.sin_cos();
        let affine = Tensor::<f64, 2>::new(cos, -sin, sin, cos) * Tensor::<f64, 2>::new(1.3, 0.2, 0.1, 0.9);
        deform(&mut solid, |x| affine * x + V::new(0.3, -0.7), parallel)?;
        let exact = mps_solid::ConstitutiveModel::first_piola(&law, &affine, &mut (), 0.0);
        let (mut strain, mut stress) = (0.0_f64, 0.0_f64);
        for f in solid.particles().deformations() {
            strain = strain.max((f - affine).norm());
            let found = mps_solid::ConstitutiveModel::first_piola(&law, f, &mut (), 0.0);
            stress = stress.max((found - exact).norm() / YOUNG);
        }
        let exact = "analytic: the given one";
        let measures = vec![
            Measure::new("deformation, largest error", "-", strain, 0.0, exact).within(1e-12, 0),
            Measure::new("stress, largest error", "E", stress, 0.0, exact).within(1e-12, 0),
        ];
        Ok(Outcome::new(measures, Vec::new()))
    }
}
