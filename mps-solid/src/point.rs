//! Points of the drawing: between the particles, on a surface, at a corner.
//!
//! Particles lie half a spacing inside the surface; forces act, and displacements are compared, on it.
//! A [`MaterialPoint`] takes the values of the particles around it with weights `psi_j` that are exact for
//! linear fields,
//!
//! ```text
//! psi_j = W_j [1/sum_k W_k - c . S^-1 (d_j - c)],   d_j = X_j - X,
//! c = sum_k W_k d_k / sum_k W_k,   S = sum_k W_k (d_k - c) (x) (d_k - c)
//! ```
//!
//! (moving least squares of first order, Lancaster and Salkauskas 1981), and hands a force to the same
//! particles with the same weights. Then force and moment arrive whole, and the work of the force is that of
//! the motion of the point.

use crate::{ConstitutiveModel, Solid, SolidError};
use core::ops::Mul;
use mps_kernel::small::outer;
use mps_kernel::tensor::guarded_inverse;
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Kernel, Real, Tensor, Vector};

/// Particles up to this many spacings away take part: two rows below a surface.
const REACH: f64 = 2.0;
/// Smallest determinant of the surroundings, relative to an isotropic one, see
/// [`kinematics`](crate::kinematics).
const SPANNING: f64 = 0.01;

/// A point of the undeformed body and its weights.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialPoint<T: Real, const D: usize> {
    reference: Vector<T, D>,
    weights: Vec<(u32, T)>,
}

impl<T: Real, const D: usize> MaterialPoint<T, D> {
    /// From a place \[m\] and weights, which must add up to 1 and have the place as their centre.
    pub(crate) fn new(reference: Vector<T, D>, weights: Vec<(u32, T)>) -> Self {
        Self { reference, weights }
    }

    /// Where the point is in the undeformed body \[m\].
    pub fn reference(&self) -> &Vector<T, D> {
        &self.reference
    }

    /// The particles that take part and their weights, which add up to 1.
    pub fn weights(&self) -> &[(u32, T)] {
        &self.weights
    }

    /// The value at the point of a field given at every particle: position, velocity, deformation.
    pub fn value<F: Copy + Mul<T, Output = F> + core::iter::Sum>(&self, field: &[F]) -> F {
        self.weights.iter().map(|&(j, psi)| field[j as usize] * psi).sum()
    }

    /// Adds a force on the point \[N\] to the forces on the particles.
    pub fn add_force(&self, force: &Vector<T, D>, forces: &mut [Vector<T, D>]) {
        for &(j, psi) in &self.weights {
            forces[j as usize] += force * psi;
        }
    }
}

impl<T, const D: usize, M, K> Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    /// The point at `reference` \[m\] in the undeformed body, inside or on its surface; a little outside it works where enough particles are near.
    ///
    /// # Errors
    /// If too few particles are near.
    pub fn point(&self, reference: Vector<T, D>) -> Result<MaterialPoint<T, D>, SolidError> {
        let reach = T::of(REACH);
        let mut near = Vec::new();
        for (j, x) in self.particles.reference.iter().enumerate() {
            // In spacings, so that a stretched lattice has the weights of the square one.
            let d = (x - reference).component_div(&self.spacing);
            let distance = d.norm();
            if distance < reach {
                let near_zero = T::of(1e-6);
                let (w, _) = WendlandC2.weight_and_over_r2(distance.max(near_zero), reach);
                near.push((j as u32, w, d));
            }
        }
        let total: T = near.iter().fold(T::zero(), |sum, (_, w, _)| sum + *w);
        let middle = near.iter().fold(Vector::zeros(), |sum, (_, w, d)| sum + d * (*w / total));
        let spread = near.iter().fold(Tensor::zeros(), |sum, (_, w, d)| {
            let away = d - middle;
            sum + outer(&away, &away) * *w
        });
        let slope = guarded_inverse(&spread, T::of(SPANNING)).ok_or_else(|| SolidError::Outside {
            point: reference.iter().map(|x| x.to_double()).collect(),
        })? * -middle;
        let weight =
            |(j, w, d): &(u32, T, Vector<T, D>)| (*j, *w * (T::one() / total + slope.dot(&(d - middle))));
        Ok(MaterialPoint { reference, weights: near.iter().map(weight).collect() })
    }
}
