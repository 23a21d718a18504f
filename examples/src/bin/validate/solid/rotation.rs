//! Rigid rotation costs nothing.

use super::scene::{V, YOUNG, deform, square};
use mps_examples::Failure;
use mps_examples::exact::{Case, Measure, Outcome, Pace};
use mps_kernel::Tensor;
use mps_neighbors::Parallel;
use mps_solid::materials::{CorotationalHooke, NeoHookean, SaintVenantKirchhoff};
use mps_solid::{ConstitutiveModel, Solid};

pub(crate) struct Rotation;

/// Angles all around.
const ANGLES: u32 = 72;
const LAW: &str = "analytic: nothing is strained";

/// Largest stress over Young's modulus, and largest force on a particle over `E l0`, at any of the angles.
fn worst<M: ConstitutiveModel<f64, 2>>(
    mut solid: Solid<f64, 2, M>,
    parallel: &Parallel,
) -> Result<[f64; 2], Failure> {
    let [mut stress, mut force] = [0.0_f64; 2];
    let l0 = solid.spacing().x;
    for k in 0..ANGLES {
        let angle = core::f64::consts::TAU * f64::from(k) / f64::from(ANGLES);
        let (sin, cos) = angle.sin_cos();
        let turn = Tensor::<f64, 2>::new(cos, -sin, sin, cos);
        deform(&mut solid, |x| turn * x, parallel)?;
        for (i, f) in solid.particles().deformations().iter().enumerate() {
            let mut history = solid.history()[i];
            stress = stress.max(solid.material().first_piola(f, &mut history, 0.0).norm() / YOUNG);
        }
        let forces = solid.particles().internal_forces();
        force = forces.iter().map(V::norm).fold(force, |most, f| most.max(f / (YOUNG * l0)));
    }
    Ok([stress, force])
}

impl Case for Rotation {
    fn name(&self) -> &'static str {
        "rotation"
    }

    fn about(&self) -> &'static str {
        "A square whose particles are shaken by 0.2 spacings, nu = 0.4, turned by 72 angles all around, with each of the three laws; the \
         largest counts. Stress over E, force over E l0."
    }

    fn resolution(&self) -> &'static str {
        "particles per side"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![10], vec![10, 20, 40])
    }

    fn run(&self, n: usize, _: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let found = [
            worst(square(n, 0.2, CorotationalHooke::new(YOUNG, 0.4)?, parallel)?, parallel)?,
            worst(square(n, 0.2, SaintVenantKirchhoff::new(YOUNG, 0.4)?, parallel)?, parallel)?,
            worst(square(n, 0.2, NeoHookean::new(YOUNG, 0.4)?, parallel)?, parallel)?,
        ];
        let largest = |k: usize| found.iter().map(|each| each[k]).fold(0.0, f64::max);
        let measures = vec![
            Measure::new("stress, largest", "E", largest(0), 0.0, LAW).within(1e-12, 0),
            Measure::new("force, largest", "E l0", largest(1), 0.0, LAW).within(1e-12, 0),
        ];
        Ok(Outcome::new(measures, Vec::new()))
    }
}
