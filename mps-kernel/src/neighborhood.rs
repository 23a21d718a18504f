//! The two traits that separate *what a pair does* from *who is paired with whom*.
//!
//! The example at the head of the crate implements one and evaluates the other; the operators are
//! pinned by the property tests named in [`operators`](crate::operators).

use crate::{Pair, Real};

/// Who is paired with whom.
///
/// Implemented by the compressed rows and the frozen reference lists of `mps-neighbors`; an
/// embedding program may implement it over its own search.
pub trait Neighborhood<T: Real, const D: usize>: Sync {
    /// Number of particles that have a row.
    fn len(&self) -> usize;

    /// Whether there is no row at all.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Visits the neighbours of `i` in ascending order of `j`, the order on which bitwise
    /// reproducible sums rest.
    fn for_each(&self, i: usize, visit: impl FnMut(&Pair<T, D>));
}

/// A sum over neighbours: gradient, divergence, Laplacian, corrected matrix.
///
/// An operator is a value, so that its parameters travel with it. The sum starts at
/// [`zero`](PairOperator::zero), every pair is added by [`add`](PairOperator::add) and
/// [`finish`](PairOperator::finish) applies the factor in front of the sum.
pub trait PairOperator<T: Real, const D: usize, F: Copy> {
    /// Type of the sum and of the result.
    type Output: Copy;

    /// The empty sum.
    fn zero(&self) -> Self::Output;

    /// Adds what neighbour `pair.j` with field value `fj` does to particle `i` with value `fi`.
    fn add(&self, sum: &mut Self::Output, fi: &F, fj: &F, pair: &Pair<T, D>);

    /// Applies the factor in front of the sum.
    fn finish(&self, sum: Self::Output) -> Self::Output;
}

/// Evaluates one operator at particle `i`: the readable form, for set-up, output and tests.
/// Solvers fuse several operators into one visit of the neighbours instead.
#[inline]
pub fn apply<T, const D: usize, F, N, O>(operator: &O, neighborhood: &N, i: usize, field: &[F]) -> O::Output
where
    T: Real,
    F: Copy,
    N: Neighborhood<T, D>,
    O: PairOperator<T, D, F>,
{
    let mut sum = operator.zero();
    neighborhood.for_each(i, |pair| operator.add(&mut sum, &field[i], &field[pair.j], pair));
    operator.finish(sum)
}
