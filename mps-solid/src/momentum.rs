//! The internal forces: the exact gradient of the discrete energy, in two sweeps.
//!
//! With `w_ij = W_ij/|r0_ij|^2`, `h_ij = r_ij - F_i r0_ij` and the energy
//! `E = sum_i V_i [w(F_i) + kappa sum_j w_ij |h_ij|^2]`, moving the pair vector `r_ij` changes the energy
//! of particle `i` by
//!
//! ```text
//! t_ij = V_i [ w_ij P_i C_i r0_ij + 2 kappa w_ij h_ij - 2 kappa w_ij (sum_k w_ik h_ik (x) r0_ik) C_i r0_ij ]
//! ```
//!
//! The last sum is zero: it is the normal equation of the least-squares fit whose solution `F_i` is
//! ([`kinematics`](crate::kinematics)). That is why the same weight `w_ij` is used for both. What
//! remains is `f_ij = t_ij - t_ji`, or
//!
//! ```text
//! f_ij = w_ij [ (A_i + A_j) r0_ij + 2 kappa (V_i + V_j) r_ij ],    A_i = V_i (P_i C_i - 2 kappa F_i)
//! ```
//!
//! The first sweep makes `A_i`, the second adds the pairs up. `f_ij = -f_ji` holds bit by bit, because
//! `r0`, `r` and the sums in brackets are computed the same way from both ends. The energy does not
//! notice a rotation of the body, so the torques cancel as well.

use mps_kernel::{Real, Tensor, Vector};
use mps_neighbors::FrozenPair;

/// What the second sweep reads of a neighbour.
#[derive(Clone, Copy, Debug)]
pub struct InnerStress<T: Real, const D: usize> {
    /// `A_i = V_i (P_i C_i - 2 kappa F_i)` \[Pa m^D, per m^2\].
    pub a: Tensor<T, D>,
    /// `2 kappa V_i`.
    pub spring: T,
}

impl<T: Real, const D: usize> InnerStress<T, D> {
    /// From the stress `P_i`, the deformation `F_i`, the correction `C_i`, the volume and `kappa`.
    #[inline(always)]
    pub fn new(
        stress: &Tensor<T, D>,
        deformation: &Tensor<T, D>,
        correction: &Tensor<T, D>,
        volume: T,
        kappa: T,
    ) -> Self {
        let spring = kappa * T::of(2.0) * volume;
        Self { a: stress * (correction * volume) - deformation * spring, spring }
    }
}

/// `f_ij`, the force of neighbour `j` on particle `i` \[N\].
#[inline(always)]
pub fn pair_force<T: Real, const D: usize>(
    pair: &FrozenPair<T, D>,
    r_ij: &Vector<T, D>,
    i: &InnerStress<T, D>,
    j: &InnerStress<T, D>,
) -> Vector<T, D> {
    ((i.a + j.a) * pair.r0_ij + r_ij * (i.spring + j.spring)) * pair.over_r2
}

/// Sum of the pair forces on particle `i` \[N\].
#[inline(always)]
pub fn internal_force<T: Real, const D: usize>(
    row: &[FrozenPair<T, D>],
    i: usize,
    position: &[Vector<T, D>],
    inner: &[InnerStress<T, D>],
) -> Vector<T, D> {
    let mut force = Vector::zeros();
    for pair in row {
        let j = pair.j as usize;
        force += pair_force(pair, &(position[j] - position[i]), &inner[i], &inner[j]);
    }
    force
}
