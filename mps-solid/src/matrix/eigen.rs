//! The largest eigenvalues of a symmetric operator, by a block Krylov method.
//!
//! The space spanned by a block of vectors and its images grows until the residuals of the wanted
//! eigenvectors, found in it by Rayleigh and Ritz, are small; when it becomes large it is cut down to the
//! best of them (Wu and Simon 2000, Thick-restart Lanczos method for large symmetric eigenvalue problems). All vectors are kept orthogonal to
//! each other explicitly. The first block is as wide as the number of wanted vectors and a few more, so
//! that equal eigenvalues (six rigid motions, the two bendings of a square bar) are all found.

use super::MatrixError;
use super::factor::algebra;
use faer::{Col, Mat, MatRef, Side};

/// Vectors of the first block beyond the wanted ones.
const GUARD: usize = 4;
/// The space is cut down when it holds this many blocks, or vectors.
const BLOCKS: usize = 5;
const VECTORS: usize = 48;
/// Most rounds; a search that converges takes ten or twenty.
const ROUNDS: usize = 300;
/// A direction of which only this part is new is none.
const NOTHING_NEW: f64 = 1e-8;

/// Eigenvalues, descending, and orthonormal eigenvectors.
pub(super) struct Ritz {
    pub(super) values: Vec<f64>,
    pub(super) vectors: Mat<f64>,
}

/// The `wanted` largest eigenvalues of the symmetric operator `apply` on `len` unknowns.
///
/// Converged is a vector `y` with the value `t` if `|apply(y) - t y| <= tolerance(t, t_max) |t|`. The error
/// of `t` is of second order in that. What is returned is `apply(y)`, one step of the power
/// method better, made orthonormal again.
///
/// # Errors
/// [`MatrixError::Modes`] with the first that did not converge.
pub(super) fn largest_values(
    len: usize,
    wanted: usize,
    tolerance: impl Fn(f64, f64) -> f64,
    apply: impl Fn(MatRef<'_, f64>) -> Result<Mat<f64>, MatrixError>,
) -> Result<Ritz, MatrixError> {
    let block = (wanted + GUARD).min(len);
    let capacity = (BLOCKS * block).max(VECTORS).min(len);
    let (mut space, mut image) = (Mat::zeros(len, capacity), Mat::zeros(len, capacity));
    let mut size = 0;
    let noise = noise(len, block);
    let mut candidates = MatRef::from_column_major_slice(&noise, len, block).to_owned();
    let mut worst = MatrixError::Modes { mode: 0, rounds: 0, residual: f64::NAN };
    for rounds in 1..=ROUNDS {
        let grown = extend(&mut space, size, candidates.as_ref());
        let new = apply(space.subcols(size, grown - size))?;
        image.subcols_mut(size, grown - size).copy_from(&new);
        let stuck = grown == size || grown < block;
        size = grown;
        if stuck {
            break;
        }

        let projected = space.subcols(0, size).transpose() * image.subcols(0, size);
        let projected = (&projected + projected.transpose()) * faer::Scale(0.5);
        let eigen = projected.self_adjoint_eigen(Side::Lower).map_err(|e| algebra(len, format!("{e:?}")))?;
        // Ascending there.
        let best = |count: usize| eigen.U().subcols(size - count, count);
        let values: Vec<f64> = (0..wanted).map(|k| eigen.S()[size - 1 - k]).collect();
        let coefficients = best(wanted).reverse_cols();
        let vectors = space.subcols(0, size) * coefficients;
        let images = image.subcols(0, size) * coefficients;
        let mut residuals = Mat::zeros(len, wanted);
        let mut open = Vec::new();
        for (k, &value) in values.iter().enumerate() {
            let residual = images.col(k) - vectors.col(k) * faer::Scale(value);
            residuals.col_mut(k).copy_from(&residual);
            let relative = residual.norm_l2() / value.abs();
            if relative > tolerance(value, values[0]) || relative.is_nan() {
                open.push((k, relative));
            }
        }
        match open.first() {
            Some(&(mode, residual)) if size < len => worst = MatrixError::Modes { mode, rounds, residual },
            // In the whole space nothing is left to be found.
            _ => {
                let mut vectors = Mat::zeros(len, wanted);
                extend(&mut vectors, 0, images.as_ref());
                return Ok(Ritz { values, vectors });
            }
        }
        candidates = Mat::from_fn(len, open.len(), |row, k| residuals[(row, open[k].0)]);
        if size + open.len() > capacity {
            let kept = best(block);
            let (cut, cut_image) = (space.subcols(0, size) * kept, image.subcols(0, size) * kept);
            space.subcols_mut(0, block).copy_from(&cut);
            image.subcols_mut(0, block).copy_from(&cut_image);
            size = block;
        }
    }
    Err(worst)
}

/// Adds to the first `size` columns of `space` what the candidates have outside of them, orthonormal;
/// returns the new size.
fn extend(space: &mut Mat<f64>, mut size: usize, candidates: MatRef<'_, f64>) -> usize {
    for candidate in candidates.col_iter() {
        if size == space.ncols() {
            break;
        }
        let mut new: Col<f64> = candidate * faer::Scale(1.0 / candidate.norm_l2());
        let mut left = 1.0;
        // Twice is enough (Kahan, in Parlett, The Symmetric Eigenvalue Problem, section 6.9).
        for _ in 0..2 {
            let known = space.subcols(0, size);
            new -= known * (known.transpose() * &new);
            let norm = new.norm_l2();
            left *= norm;
            new *= faer::Scale(1.0 / norm);
        }
        // NaN is nothing new either.
        if left > NOTHING_NEW {
            space.col_mut(size).copy_from(&new);
            size += 1;
        }
    }
    size
}

/// Reproducible noise in `[-0.5, 0.5)`, `columns` vectors one after the other.
pub(super) fn noise(len: usize, columns: usize) -> Vec<f64> {
    let mut state = 1_u64;
    let mut next = || {
        // Knuth's linear congruential generator, upper bits.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / (1_u64 << 24) as f64 - 0.5
    };
    (0..len * columns).map(|_| next()).collect()
}
