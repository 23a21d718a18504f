//! A square on rollers, stretched by a traction: a uniform state.

use super::scene::{V, solid};
use mps_examples::Failure;
use mps_examples::exact::{Case, Measure, Outcome, Pace};
use mps_kernel::Tensor;
use mps_neighbors::Parallel;
use mps_solid::body::{Face, block};
use mps_solid::materials::NeoHookean;
use mps_solid::{ConstitutiveModel, Relaxation};

pub(crate) struct Stretch;

/// Traction over Young's modulus.
const PULL: f64 = 0.4;

impl Case for Stretch {
    fn name(&self) -> &'static str {
        "stretch"
    }

    fn about(&self) -> &'static str {
        "A square, neo-Hookean with nu = 0.3, slides on rollers at its left and its lower face and is pulled at the right one by 0.4 E of its undeformed \
         area. First Piola-Kirchhoff stress in the middle less the exact one, over the traction. What is missing comes from the free corner."
    }

    fn resolution(&self) -> &'static str {
        "particles per side"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![9, 17], vec![9, 17, 33])
    }

    fn run(&self, n: usize, _: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let faces = [Face::lower(0), Face::lower(1)];
        let mut square = block(V::zeros(), V::repeat(1.0), [n, n], &faces)?;
        faces.iter().try_for_each(|&face| square.slide(face))?;
        let law = NeoHookean::new(1.0, 0.3)?;
        let mut body = solid(&square, 1.0, law, parallel)?;
        let right = square.face(Face::upper(0))?;
        let pull = V::new(PULL, 0.0);
        let relaxation = Relaxation { tolerance: 1e-8, ..Relaxation::default() };
        body.relax(parallel, &V::zeros(), |_, force| right.add_traction(&pull, force), &relaxation)?;

        let middle = body.point(V::repeat(0.5))?;
        let f: Tensor<f64, 2> = middle.value(body.particles().deformations());
        let stress = law.first_piola(&f, &mut (), 0.0);
        let off = (stress - Tensor::<f64, 2>::new(PULL, 0.0, 0.0, 0.0)).norm() / PULL;
        let law = "analytic: the traction, and none across";
        let measures =
            vec![Measure::new("stress in the middle, error", "traction", off, 0.0, law).within(1e-3, 9)];
        Ok(Outcome::new(measures, Vec::new()))
    }
}
