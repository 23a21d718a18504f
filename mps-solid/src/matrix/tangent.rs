//! The tangent of the material at one particle, by differences of its stress.
//!
//! A material says its energy and its stress `P(F)`, not its tangent `A = dP/dF`. The central difference
//! of fourth order,
//!
//! ```text
//! P' = [8 (P(h) - P(-h)) - (P(2h) - P(-2h))] / 12 h
//! ```
//!
//! leaves out `h^4 P^(5)/30` and rounds by about `1.5 eps |A|/h`. Both are near `1e-12` and `3e-13` of the
//! tangent at `h = 1e-3`; the plain difference cannot do better than `4e-11`, which an almost
//! incompressible body, whose bending is thousands of times softer than its compression, would feel.

use super::MatrixError;
use crate::{ConstitutiveModel, Solid, SolidError};
use mps_kernel::tensor::determinant;
use mps_kernel::{Kernel, Tensor};
use nalgebra::DMatrix;

/// Step of the differences in the components of `F` \[-\].
const STEP: f64 = 1e-3;
/// Largest `|A - A^T| / |A|` that is taken for round-off.
const SYMMETRIC: f64 = 1e-8;

/// The symmetric `D^2 x D^2` matrix `A` \[Pa\] of particle `i` at its current position:
/// `dP_ab = A_(a D + b)(c D + d) dF_cd`. A material with a memory is asked with no time elapsed and a
/// history that has settled here: the rate of a body that moves is none of its stiffness.
///
/// # Errors
/// If the particle is turned inside out or not finite, or the stress has no energy.
pub(super) fn tangent<const D: usize, M, K>(
    solid: &Solid<f64, D, M, K>,
    i: usize,
) -> Result<DMatrix<f64>, MatrixError>
where
    M: ConstitutiveModel<f64, D>,
    K: Kernel<f64>,
{
    let f = solid.deformation_of(i);
    let id = solid.particles.id[i];
    if determinant(&f).is_nan() || determinant(&f) <= 0.0 {
        return Err(broken(solid, i, &f).into());
    }
    let mut history = solid.history[i];
    solid.material.settle(&f, &mut history);
    let stress = |c: usize, d: usize, steps: f64| {
        let mut f = f;
        f[(c, d)] += steps * STEP;
        solid.material.first_piola(&f, &mut { history }, 0.0)
    };
    let mut a = DMatrix::zeros(D * D, D * D);
    for column in 0..D * D {
        let (c, d) = (column / D, column % D);
        let near = stress(c, d, 1.0) - stress(c, d, -1.0);
        let far = stress(c, d, 2.0) - stress(c, d, -2.0);
        let slope: Tensor<f64, D> = (near * 8.0 - far) / (12.0 * STEP);
        for row in 0..D * D {
            a[(row, column)] = slope[(row / D, row % D)];
        }
    }
    let asymmetry = (&a - a.transpose()).norm() / a.norm();
    if asymmetry <= SYMMETRIC {
        return Ok((&a + a.transpose()) * 0.5);
    }
    if !asymmetry.is_finite() {
        // So near to being flat that a step turns it over.
        return Err(broken(solid, i, &f).into());
    }
    Err(MatrixError::NotSymmetric { material: solid.material.name(), id, asymmetry })
}

fn broken<const D: usize, M, K>(solid: &Solid<f64, D, M, K>, i: usize, f: &Tensor<f64, D>) -> SolidError
where
    M: ConstitutiveModel<f64, D>,
    K: Kernel<f64>,
{
    let id = solid.particles.id[i];
    let position = solid.particles.position[i].iter().copied().collect();
    let determinant = determinant(f);
    if determinant.is_finite() {
        SolidError::Inverted { id, position, determinant }
    } else {
        SolidError::NotFinite { id, position }
    }
}
