//! The stiffness matrix with its masses.

use super::MatrixError;
use super::assembly::{Sparse, assemble};
use super::eigen::largest_values;
use super::factor::{Factor, Pattern};
use super::freedoms::Freedoms;
use super::held::check_supports;
use crate::{ConstitutiveModel, Solid};
use mps_kernel::{Kernel, Vector};

/// Smallest over largest eigenvalue with which displacements are still right to about a hundredth. A clamped body of 320 by 32 particles is at
/// `1e-8`, almost incompressible at `1e-11`.
const SOFTEST: f64 = 1e-14;

/// The stiffness matrix `K` of a body about its current positions, the second derivative of its energy,
/// and its lumped masses, both restricted to the degrees of freedom that move.
///
/// Vectors go in and come out as one [`Vector`] for every particle of the body; components that cannot
/// move are ignored on the way in and zero on the way out.
#[derive(Clone, Debug)]
pub struct Stiffness<const D: usize> {
    pub(super) freedoms: Freedoms<D>,
    /// `1/sqrt(m)` of every unknown.
    pub(super) scale: Vec<f64>,
    /// `M^-1/2 K M^-1/2`: its eigenvalues are `omega^2`, its eigenvectors `M^1/2 phi` are orthonormal.
    pub(super) scaled: Sparse,
    pub(super) pattern: Pattern,
    /// What the supports leave free, if anything.
    supports: Result<(), MatrixError>,
}

impl<const D: usize> Stiffness<D> {
    /// The matrix of a body about its current positions. Velocities do not matter, nor does how the body came here: a material with a memory is asked
    /// as if it had [settled](ConstitutiveModel::settle), so that a viscous stress has no part in it.
    ///
    /// # Errors
    /// If nothing can move, a particle is turned inside out or not finite, or the stress of the material
    /// is not the derivative of an energy.
    pub fn new<M, K>(solid: &Solid<f64, D, M, K>) -> Result<Self, MatrixError>
    where
        M: ConstitutiveModel<f64, D>,
        K: Kernel<f64>,
    {
        let freedoms = Freedoms::new(solid.particles());
        if freedoms.len() == 0 {
            return Err(MatrixError::NothingMoves);
        }
        let scale = freedoms.gather(|i, _| 1.0 / solid.masses()[i].sqrt());
        let scaled = Sparse::pattern(solid.pairs(), &freedoms);
        let pattern = Pattern::new(&scaled)?;
        let supports = check_supports(solid);
        let mut stiffness = Self { freedoms, scale, scaled, pattern, supports };
        stiffness.update(solid)?;
        Ok(stiffness)
    }

    /// The same about new positions of the same body: the pattern is that of its reference pairs.
    pub(super) fn update<M, K>(&mut self, solid: &Solid<f64, D, M, K>) -> Result<(), MatrixError>
    where
        M: ConstitutiveModel<f64, D>,
        K: Kernel<f64>,
    {
        assemble(solid, &self.freedoms, &mut self.scaled)?;
        for column in 0..self.len() {
            for at in self.scaled.starts[column]..self.scaled.starts[column + 1] {
                self.scaled.values[at] *= self.scale[column] * self.scale[self.scaled.rows[at]];
            }
        }
        Ok(())
    }

    /// Number of degrees of freedom that move.
    pub fn len(&self) -> usize {
        self.freedoms.len()
    }

    /// Whether nothing moves (never: such a matrix cannot be made).
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of stored entries, those of both triangles.
    pub fn entries(&self) -> usize {
        self.scaled.values.len()
    }

    /// `K u` \[N\]: minus the change of the internal forces under the small displacement `u` \[m\].
    ///
    /// # Errors
    /// If there is not one entry for every particle.
    pub fn multiply(&self, displacement: &[Vector<f64, D>]) -> Result<Vec<Vector<f64, D>>, MatrixError> {
        self.freedoms.check("displacement", displacement)?;
        let mut unknowns = self.freedoms.gather(|i, axis| displacement[i][axis]);
        unknowns.iter_mut().zip(&self.scale).for_each(|(u, s)| *u /= s);
        let force = self.product(&unknowns);
        Ok(self.freedoms.scatter(force.iter().zip(&self.scale).map(|(f, s)| f / s)))
    }

    /// The small displacement `u` \[m\] under the force on every particle \[N\]: `K u = f`.
    ///
    /// # Errors
    /// If there is not one force for every particle, its supports do not hold the body
    /// ([`MatrixError::NotHeld`]), its state is not stable ([`MatrixError::Unstable`]), or it is so slender that rounding
    /// would decide ([`MatrixError::IllConditioned`]).
    pub fn solve(&self, force: &[Vector<f64, D>]) -> Result<Vec<Vector<f64, D>>, MatrixError> {
        self.freedoms.check("force", force)?;
        self.solve_unknowns(self.freedoms.gather(|i, axis| force[i][axis]))
    }

    /// The same from the forces on the unknowns.
    pub(super) fn solve_unknowns(&self, mut x: Vec<f64>) -> Result<Vec<Vector<f64, D>>, MatrixError> {
        let factor = self.held()?;
        x.iter_mut().zip(&self.scale).for_each(|(f, s)| *f *= s);
        factor.solve(&mut x);
        Ok(self.freedoms.scatter(x.iter().zip(&self.scale).map(|(u, s)| u * s)))
    }

    /// The largest frequency \[rad/s\]: velocity Verlet is stable for steps below 2 over it.
    ///
    /// Right to about `1e-6`, see [`Solid::stability_limit`] for the estimate made without a matrix.
    ///
    /// # Errors
    /// If the iteration does not converge.
    pub fn largest_frequency(&self) -> Result<f64, MatrixError> {
        let ritz = largest_values(self.len(), 1, |_, _| 1e-4, |x| Ok(self.products(x)))?;
        Ok(ritz.values[0].sqrt())
    }

    /// Norm of the forces \[N\] that the rounding of the positions of the unknowns causes.
    pub(super) fn rounding(&self, positions: &[Vector<f64, D>]) -> f64 {
        let place = self.freedoms.gather(|i, axis| positions[i][axis]);
        let force = |c: usize| {
            let diagonal = self.scaled.column(c).find(|&(row, _)| row == c).map_or(0.0, |(_, value)| value);
            (diagonal * place[c] * f64::EPSILON / (self.scale[c] * self.scale[c])).powi(2)
        };
        (0..self.len()).map(force).sum::<f64>().sqrt()
    }

    /// Largest absolute column sum of the scaled matrix: a bound of the largest `omega^2` \[1/s^2\].
    pub(super) fn bound(&self) -> f64 {
        let sum = |c| self.scaled.column(c).map(|(_, value)| value.abs()).sum();
        (0..self.len()).map(sum).fold(0.0, f64::max)
    }

    /// The factors of the scaled matrix, if no displacement is free.
    fn held(&self) -> Result<Factor, MatrixError> {
        self.supports.clone()?;
        let factor = Factor::new(self, 0.0)?.ok_or(MatrixError::Unstable)?;
        // Two inverse iterations from noise show the softest displacement.
        let size = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
        let mut trial = super::eigen::noise(self.len(), 1);
        factor.solve(&mut trial);
        let once = size(&trial);
        factor.solve(&mut trial);
        let ratio = once / (size(&trial) * self.bound());
        if ratio > SOFTEST { Ok(factor) } else { Err(MatrixError::IllConditioned { ratio }) }
    }

    /// The scaled matrix times a vector of unknowns.
    pub(super) fn product(&self, x: &[f64]) -> Vec<f64> {
        // By its symmetry a column is a row: every entry of the result is one sum.
        (0..self.len()).map(|c| self.scaled.column(c).map(|(row, value)| value * x[row]).sum()).collect()
    }
}
