//! Frequencies and shapes of free vibrations.

use super::eigen::largest_values;
use super::factor::{Factor, algebra};
use super::{MatrixError, Stiffness};
use core::f64::consts::TAU;
use faer::{Mat, MatRef, Side};
use mps_kernel::Vector;

/// The shift in units of the bound of the spectrum: well above the rounding of zero modes (`1e-13`), near or
/// below the slowest bending of a slender body.
const SHIFT: f64 = 1e-9;
/// A larger one is tried, by this factor, if the matrix is still not positive definite.
const LARGER: f64 = 100.0;
/// Residual of a mode that counts as none.
const CONVERGED: f64 = 1e-9;
/// The same in rounding units: of the largest stiffness, for the entries of the matrix, and of the largest
/// compliance, that of a rigid motion, for the solutions.
const ROUNDING: f64 = 16.0;

/// A free vibration about the state of the matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode<const D: usize> {
    /// `omega^2` \[1/s^2\]. Zero up to rounding for a rigid motion, negative in an unstable state.
    pub square: f64,
    /// Displacement of every particle \[kg^-1/2\], of unit modal mass: `sum_i m_i |phi_i|^2 = 1`.
    pub shape: Vec<Vector<f64, D>>,
}

impl<const D: usize> Mode<D> {
    /// Angular frequency \[rad/s\], zero if the square is negative.
    pub fn omega(&self) -> f64 {
        self.square.max(0.0).sqrt()
    }

    /// Period \[s\], infinite if the frequency is zero.
    pub fn period(&self) -> f64 {
        TAU / self.omega()
    }
}

impl<const D: usize> Stiffness<D> {
    /// The `count` lowest modes of `K phi = omega^2 M phi`, ascending.
    ///
    /// The largest eigenvalues of `(K + s M)^-1 M` are searched, with a small shift `s > 0` that makes the matrix
    /// of a free body positive definite. The residual of a mode in that problem is below `1e-9` of it, or what
    /// it is rounded by; the error of a frequency is of second order in that. What remains is the rounding
    /// of the matrix, about `1e-16` of the largest `omega^2` in `omega^2`. The same body gives the same bits.
    ///
    /// # Errors
    /// If there are not that many modes, or the search does not converge.
    pub fn lowest(&self, count: usize) -> Result<Vec<Mode<D>>, MatrixError> {
        if count == 0 || count > self.len() {
            return Err(MatrixError::Count { asked: count, freedoms: self.len() });
        }
        let bound = self.bound();
        let factor = self.shifted(bound)?;
        let tolerance = |value: f64, largest: f64| {
            CONVERGED + ROUNDING * f64::EPSILON * (bound * value + largest / value)
        };
        let ritz = largest_values(self.len(), count, tolerance, |x| Ok(factor.solutions(x)))?;
        let mut modes: Vec<_> =
            ritz.vectors.col_iter().map(|y| self.mode(y.iter().copied().collect())).collect();
        modes.sort_by(|a, b| a.square.total_cmp(&b.square));
        Ok(modes)
    }

    /// `omega^2` of all modes \[1/s^2\], ascending, by a dense matrix: for small bodies, the time grows with
    /// the third power of their size (2000 degrees of freedom: about a second).
    ///
    /// # Errors
    /// If the library does not converge.
    pub fn spectrum(&self) -> Result<Vec<f64>, MatrixError> {
        let mut dense = Mat::zeros(self.len(), self.len());
        for column in 0..self.len() {
            for (row, value) in self.scaled.column(column) {
                dense[(row, column)] = value;
            }
        }
        dense.self_adjoint_eigenvalues(Side::Lower).map_err(|e| algebra(self.len(), format!("{e:?}")))
    }

    /// Factors with the smallest shift that makes the matrix positive definite. With that of the bound
    /// every matrix is.
    fn shifted(&self, bound: f64) -> Result<Factor, MatrixError> {
        let mut shift = SHIFT * bound;
        while shift <= 2.0 * LARGER * bound {
            if let Some(factor) = Factor::new(self, shift)? {
                return Ok(factor);
            }
            shift *= LARGER;
        }
        Err(MatrixError::Unstable)
    }

    /// The mode of an eigenvector of the scaled matrix, with the square of Rayleigh's quotient.
    fn mode(&self, y: Vec<f64>) -> Mode<D> {
        let square = self.product(&y).iter().zip(&y).map(|(a, b)| a * b).sum();
        let shape = self.freedoms.scatter(y.iter().zip(&self.scale).map(|(y, s)| y * s));
        Mode { square, shape }
    }

    /// The scaled matrix times several vectors of unknowns.
    pub(super) fn products(&self, x: MatRef<'_, f64>) -> Mat<f64> {
        let mut y = Mat::zeros(x.nrows(), x.ncols());
        for k in 0..x.ncols() {
            for c in 0..self.len() {
                y[(c, k)] = self.scaled.column(c).map(|(row, value)| value * x[(row, k)]).sum();
            }
        }
        y
    }
}
