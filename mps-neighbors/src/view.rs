//! Rows seen as a neighbourhood: the weight is evaluated as a pair is visited.

use crate::{Domain, Open, Rows};
use mps_kernel::{Kernel, Neighborhood, Pair, Real, Vector};

/// Rows, positions and a weight, together a [`Neighborhood`].
///
/// The rows must belong to these positions: row `i` to `points[i]`, its entries to `targets`.
/// Pairs of the skin zone, farther apart than the radius, are visited with weight zero.
#[derive(Clone, Copy, Debug)]
pub struct RowView<'a, T: Real, const D: usize, K, P = Open> {
    /// Who is paired with whom.
    pub rows: &'a Rows,
    /// Positions of the particles that look \[m\].
    pub points: &'a [Vector<T, D>],
    /// Positions of the particles that are seen \[m\]; the same slice within one set.
    pub targets: &'a [Vector<T, D>],
    /// The weight.
    pub kernel: K,
    /// Effective radius \[m\].
    pub radius: T,
    /// Open or periodic space.
    pub domain: P,
}

impl<T, const D: usize, K, P> Neighborhood<T, D> for RowView<'_, T, D, K, P>
where
    T: Real,
    K: Kernel<T>,
    P: Domain<T, D>,
{
    #[inline(always)]
    fn len(&self) -> usize {
        self.rows.len()
    }

    #[inline(always)]
    fn for_each(&self, i: usize, mut visit: impl FnMut(&Pair<T, D>)) {
        let from = self.points[i];
        for &j in self.rows.row(i) {
            let j = j as usize;
            let r_ij = self.domain.separation(&from, &self.targets[j]);
            visit(&Pair::new(j, r_ij, &self.kernel, self.radius));
        }
    }
}
