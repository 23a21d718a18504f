//! The deformation gradient of a particle from its reference pairs.
//!
//! ```text
//! F_i = [ sum_j w_ij r_ij (x) r0_ij ] C_i,   C_i = [ sum_j w_ij r0_ij (x) r0_ij ]^-1,   w_ij = W_ij / |r0_ij|^2
//! ```
//!
//! These are eqs. 21 and 22 of Tavakoli et al. 2026 applied to the position instead of the number density
//! (the factors `D/n0` cancel), on the reference configuration (as in eq. 27). `F_i` is exact for every
//! linear displacement on every neighbourhood, complete or not. It is also the tensor that minimises
//! `sum_j w_ij |r_ij - F r0_ij|^2`; [`momentum`](crate::momentum) rests on that.

use crate::{SolidError, SolidParticles};
use mps_kernel::small::outer;
use mps_kernel::tensor::guarded_inverse;
use mps_kernel::{Real, Tensor, Vector};
use mps_neighbors::{FrozenPair, FrozenPairs};

/// Smallest `|det M| / (|M|_F/sqrt(D))^D` of a neighbourhood that counts as spanning the space.
///
/// The corner of a cubic lattice has 0.9 or more at the default radius; a line or a plane has 0.
const SPANNING: f64 = 0.01;

/// `C_i` of every particle \[1\].
///
/// # Errors
/// [`SolidError::Collinear`] with the first particle whose neighbours lie on a line or plane.
pub fn corrections<T: Real, const D: usize>(
    particles: &SolidParticles<T, D>,
    pairs: &FrozenPairs<T, D>,
) -> Result<Vec<Tensor<T, D>>, SolidError> {
    let correction = |i: usize| {
        let row = pairs.row(i);
        let moment =
            row.iter().fold(Tensor::zeros(), |m, pair| m + outer(&pair.r0_ij, &pair.r0_ij) * pair.over_r2);
        guarded_inverse(&moment, T::of(SPANNING)).ok_or_else(|| SolidError::Collinear {
            id: particles.id[i],
            position: particles.reference[i].iter().map(|x| x.to_double()).collect(),
            neighbors: row.len(),
        })
    };
    (0..particles.id.len()).map(correction).collect()
}

/// `F_i` from the current positions.
#[inline(always)]
pub fn deformation_gradient<T: Real, const D: usize>(
    row: &[FrozenPair<T, D>],
    correction: &Tensor<T, D>,
    i: usize,
    position: &[Vector<T, D>],
) -> Tensor<T, D> {
    let mut sum = Tensor::zeros();
    for pair in row {
        let r_ij = position[pair.j as usize] - position[i];
        sum += outer(&r_ij, &(pair.r0_ij * pair.over_r2));
    }
    sum * correction
}
