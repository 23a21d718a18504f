//! Rows seen as a neighbourhood: the weight is evaluated as a pair is visited.

use crate::{Domain, Open, Rows};
use fearless_simd::Simd;
use mps_kernel::by_axis;
use mps_kernel::small::components;
use mps_kernel::{Kernel, Lanes, Neighborhood, Pair, Real, Vector};

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

/// Something that is in a place: a particle, with more of what a sweep reads of it beside.
pub trait Placed<T: Real, const D: usize> {
    /// The place \[m\].
    fn place(&self) -> &Vector<T, D>;
}

impl<T: Real, const D: usize> Placed<T, D> for Vector<T, D> {
    #[inline(always)]
    fn place(&self) -> &Self {
        self
    }
}

/// Several pairs of one particle at a time; see [`RowView::packs`].
#[derive(Clone, Debug)]
pub struct Packs<'a, T: Real, const D: usize, K, P, S, A = Vector<T, D>> {
    simd: S,
    /// The neighbours that are left.
    row: &'a [u32],
    from: Vector<T, D>,
    targets: &'a [A],
    kernel: K,
    radius: T,
    domain: P,
}

impl<'a, T: Real, const D: usize, K: Kernel<T>, P: Domain<T, D>> RowView<'a, T, D, K, P> {
    /// The neighbours of `i` in ascending order, as many at a time as a sweep has lanes.
    ///
    /// Lanes that are left over at the end of the row repeat its last neighbour with weight zero.
    #[inline(always)]
    pub fn packs<S: Simd>(&self, simd: S, i: usize) -> Packs<'a, T, D, K, P, S> {
        self.packs_of(simd, i, self.targets)
    }

    /// [`packs`](Self::packs) with the places of the neighbours from `targets`, which must be those of the view. A sweep that reads more of
    /// a neighbour than its place has both in one piece of memory then, and finds it once.
    #[inline(always)]
    pub fn packs_of<S: Simd, A: Placed<T, D>>(
        &self,
        simd: S,
        i: usize,
        targets: &'a [A],
    ) -> Packs<'a, T, D, K, P, S, A> {
        Packs {
            simd,
            row: self.rows.row(i),
            from: self.points[i],
            targets,
            kernel: self.kernel,
            radius: self.radius,
            domain: self.domain,
        }
    }
}

impl<T, const D: usize, K, P, S, A> Iterator for Packs<'_, T, D, K, P, S, A>
where
    A: Placed<T, D>,
    T: Real,
    K: Kernel<T>,
    P: Domain<T, D>,
    S: Simd,
{
    type Item = Pair<T::Lanes<S>, D, T::LaneIndices>;

    #[inline(always)]
    fn next(&mut self) -> Option<Self::Item> {
        let count = T::Lanes::<S>::COUNT;
        let mut indices = T::LaneIndices::default();
        let used = if self.row.len() >= count {
            let (row, rest) = self.row.split_at(count);
            for (index, &j) in indices.as_mut().iter_mut().zip(row) {
                *index = j as usize;
            }
            self.row = rest;
            count
        } else {
            let &last = self.row.last()?;
            let used = self.row.len();
            for (k, index) in indices.as_mut().iter_mut().enumerate() {
                *index = self.row.get(k).copied().unwrap_or(last) as usize;
            }
            self.row = &[];
            used
        };
        let (targets, j) = (self.targets, indices.as_ref());
        let from = components(&self.from);
        let d = by_axis!(axis => {
            T::Lanes::gather(self.simd, |lane| components(targets[j[lane]].place())[axis]) - from[axis]
        });
        let pair = Pair::new(indices, self.domain.nearest(d), &self.kernel, self.radius);
        Some(pair.masked(T::Lanes::first(self.simd, used)))
    }
}
