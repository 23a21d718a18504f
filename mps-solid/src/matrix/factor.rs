//! The Cholesky factors of a shifted matrix.

use super::assembly::Sparse;
use super::{MatrixError, Stiffness};
use core::fmt::Display;
use faer::linalg::solvers::Solve;
use faer::sparse::linalg::LltError;
use faer::sparse::linalg::solvers::{Llt, SymbolicLlt};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Mat, MatMut, MatRef, Side};

/// The order of elimination and the pattern of the factors: found once for a body.
#[derive(Clone, Debug)]
pub(super) struct Pattern(SymbolicLlt<usize>);

impl Pattern {
    pub(super) fn new(matrix: &Sparse) -> Result<Self, MatrixError> {
        let failed = |e| algebra(matrix.starts.len() - 1, e);
        SymbolicLlt::try_new(symbolic(matrix), Side::Lower).map(Self).map_err(failed)
    }
}

pub(super) fn algebra(freedoms: usize, reason: impl Display) -> MatrixError {
    MatrixError::Algebra { freedoms, reason: reason.to_string() }
}

fn symbolic(matrix: &Sparse) -> SymbolicSparseColMatRef<'_, usize> {
    let len = matrix.starts.len() - 1;
    SymbolicSparseColMatRef::new_checked(len, len, &matrix.starts, None, &matrix.rows)
}

/// `M^-1/2 K M^-1/2 + shift I`, factorised.
pub(super) struct Factor(Llt<usize, f64>);

impl Factor {
    /// `None` if the shifted matrix is not positive definite.
    pub(super) fn new<const D: usize>(
        stiffness: &Stiffness<D>,
        shift: f64,
    ) -> Result<Option<Self>, MatrixError> {
        let matrix = &stiffness.scaled;
        let mut values = matrix.values.clone();
        for column in 0..stiffness.len() {
            let range = matrix.starts[column]..matrix.starts[column + 1];
            let diagonal = range.start + matrix.rows[range].partition_point(|&row| row < column);
            values[diagonal] += shift;
        }
        let shifted = SparseColMatRef::new(symbolic(matrix), &values);
        match Llt::try_new_with_symbolic(stiffness.pattern.0.clone(), shifted, Side::Lower) {
            Ok(factor) => Ok(Some(Self(factor))),
            Err(LltError::Numeric(_)) => Ok(None),
            Err(LltError::Generic(e)) => Err(algebra(stiffness.len(), e)),
        }
    }

    /// Replaces `x` by the solution for it as the right side.
    pub(super) fn solve(&self, x: &mut [f64]) {
        let len = x.len();
        self.0.solve_in_place(MatMut::from_column_major_slice_mut(x, len, 1));
    }

    /// The solutions for several right sides.
    pub(super) fn solutions(&self, x: MatRef<'_, f64>) -> Mat<f64> {
        self.0.solve(x)
    }
}
