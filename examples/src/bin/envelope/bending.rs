//! A beam in pure bending, which has an exact answer for every Poisson's ratio and thickness.
//!
//! The left end is a plane of symmetry, the right one carries a traction in proportion to the height: the curvature is the same
//! everywhere, `M/(E' I)` with `E' = E/(1 - nu^2)` in plane strain, and no corner has a singular stress that would have to be resolved.

use mps_examples::Failure;
use mps_kernel::Vector;
use mps_kernel::weights::WendlandC2;
use mps_neighbors::Parallel;
use mps_solid::body::{Face, block};
use mps_solid::materials::SaintVenantKirchhoff;
use mps_solid::{Relaxation, Solid, SolidConfig};

/// Length over thickness.
const LENGTH: f64 = 4.0;
/// Largest stress over Young's modulus: linear.
const STRAIN: f64 = 1e-4;

/// A beam.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beam {
    /// Particles across.
    pub(crate) across: usize,
    /// Poisson's ratio.
    pub(crate) poisson: f64,
    /// Length of a particle along the beam over that across.
    pub(crate) aspect: f64,
}

impl Beam {
    /// Deflection of the end over the exact one, less 1.
    ///
    /// # Errors
    /// If the solid refuses the beam or does not come to rest.
    pub(crate) fn error(self) -> Result<f64, Failure> {
        let parallel = Parallel::serial();
        let along = (LENGTH * self.across as f64 / self.aspect).round() as usize;
        let (lower, upper) = (Vector::from([0.0, -0.5]), Vector::from([LENGTH, 0.5]));
        let mut body = block(lower, upper, [along, self.across], &[Face::lower(0)])?;
        body.slide(Face::lower(0))?;
        let material = SaintVenantKirchhoff::new(1.0, self.poisson)?;
        let config = SolidConfig::default();
        let mut solid =
            Solid::new(body.particles.clone(), body.spacing, 1.0, material, WendlandC2, config, &parallel)?;
        let end = body.face(Face::upper(0))?;
        let traction = |height: f64| 2.0 * STRAIN * height;
        // As the points of the face carry it, which is the whole of it less 1/across^2.
        let moment: f64 = end
            .points()
            .iter()
            .map(|(at, area)| traction(at.reference().y) * at.reference().y * area.x)
            .sum();
        let load = |_: &_, forces: &mut [Vector<f64, 2>]| {
            for (at, area) in end.points() {
                at.add_force(&Vector::from([traction(at.reference().y) * area.x, 0.0]), forces);
            }
        };
        let relaxation = Relaxation { tolerance: 1e-4, max_steps: 300_000 };
        solid.relax(&parallel, &Vector::zeros(), load, &relaxation)?;
        let height = |x: f64| -> Result<f64, Failure> {
            Ok(solid.point(Vector::from([x, 0.0]))?.value(solid.positions()).y)
        };
        let found = height(0.0)? - height(LENGTH)?;
        let exact = moment * 12.0 * (1.0 - self.poisson.powi(2)) * LENGTH.powi(2) / 2.0;
        Ok(found / exact - 1.0)
    }
}
