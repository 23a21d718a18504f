//! Particles sorted into cells by counting.

use crate::grid::{Grid, check_finite};
use crate::{Domain, NeighborError, Parallel};
use mps_kernel::{Real, Vector};

/// Particles sorted by cell, the base of every search.
///
/// Takes memory in proportion to the number of particles, wherever they are. All buffers are kept
/// for the next [`build`](Cells::build).
///
/// ```
/// use mps_kernel::Vector;
/// use mps_neighbors::{Cells, Open, Parallel, Rows};
///
/// let points = [0.0, 1.0, 5.0, 1e12].map(|x| Vector::<f64, 2>::new(x, 0.0));
/// let (parallel, mut cells, mut rows) = (Parallel::serial(), Cells::new(), Rows::default());
/// cells.build(&parallel, &Open, &points, 2.0)?;
/// rows.build_within(&parallel, &Open, &cells, &points, 2.0)?;
/// assert_eq!((rows.row(0), rows.row(1), rows.row(2)), (&[1][..], &[0][..], &[][..]));
/// # Ok::<(), mps_neighbors::NeighborError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Cells<T: Real, const D: usize> {
    pub(crate) grid: Grid<D>,
    pub(crate) size: f64,
    /// Entry `k` is the particle at place `k` of the spatial order.
    order: Vec<u32>,
    /// Whether `order` is 0, 1, 2, ...
    pub(crate) in_order: bool,
    /// Bucket `b` holds the places `starts[b]..starts[b + 1]`.
    pub(crate) starts: Vec<u32>,
    /// Positions in spatial order.
    pub(crate) sorted: Vec<Vector<T, D>>,
    /// Bucket of each particle.
    keys: Vec<u32>,
}

impl<T: Real, const D: usize> Default for Cells<T, D> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Real, const D: usize> Cells<T, D> {
    /// Cells without particles.
    pub fn new() -> Self {
        const { assert!(D >= 1 && D <= 3, "space has one, two or three dimensions") }
        Self {
            grid: Grid::default(),
            size: 0.0,
            order: Vec::new(),
            in_order: true,
            starts: vec![0; 2],
            sorted: Vec::new(),
            keys: Vec::new(),
        }
    }

    /// Sorts `positions` \[m\] into cells of at least `size` \[m\], the largest reach of a search.
    ///
    /// # Errors
    /// If a position is not finite, the size is not positive, a period is shorter than two sizes
    /// (or a particle very many periods away), or there are more than 2^32 - 1 particles. The cells
    /// are empty then.
    pub fn build<P: Domain<T, D>>(
        &mut self,
        parallel: &Parallel,
        domain: &P,
        positions: &[Vector<T, D>],
        size: T,
    ) -> Result<(), NeighborError> {
        self.clear();
        let size = size.to_double();
        if !(f64::MIN_POSITIVE..f64::INFINITY).contains(&size) {
            return Err(NeighborError::Size(size));
        }
        if u32::try_from(positions.len()).is_err() {
            return Err(NeighborError::TooMany(positions.len()));
        }
        let grid = Grid::fit(parallel, domain, positions, size, 2 * positions.len() + 64)?;
        self.keys.resize(positions.len(), 0);
        parallel.update(&mut self.keys[..], |i, key| *key = grid.bucket(&grid.cell(&positions[i])) as u32);
        self.sort(grid.buckets());
        self.sorted.resize(positions.len(), Vector::zeros());
        let order = &self.order;
        parallel.update(&mut self.sorted[..], |k, p| *p = positions[order[k] as usize]);
        self.grid = grid;
        self.size = size;
        Ok(())
    }

    /// Counting sort of the keys; within a bucket particles stay in ascending order.
    fn sort(&mut self, buckets: usize) {
        self.starts.clear();
        if self.starts.capacity() < buckets + 2 {
            // Headroom: a bounding box that grows a little should not cost memory every time.
            self.starts.reserve_exact(buckets + buckets / 4 + 64);
        }
        self.starts.resize(buckets + 2, 0);
        // Counts of bucket b go two places further: after the running sum, starts[b + 1] is where
        // b begins, and after placing its particles where it ends, that is where b + 1 begins.
        for &key in &self.keys {
            self.starts[key as usize + 2] += 1;
        }
        let mut sum = 0;
        for start in &mut self.starts {
            sum += *start;
            *start = sum;
        }
        self.order.resize(self.keys.len(), 0);
        self.in_order = true;
        for (particle, &key) in self.keys.iter().enumerate() {
            let place = &mut self.starts[key as usize + 1];
            self.in_order &= *place as usize == particle;
            self.order[*place as usize] = particle as u32;
            *place += 1;
        }
        self.starts.truncate(buckets + 1);
    }

    /// The spatial order: entry `k` is the particle that belongs at place `k`.
    ///
    /// Hand it to [`Permutation::apply`](crate::Permutation::apply) now and then, followed by
    /// [`settle`](Cells::settle): a search among ordered particles is more than twice as fast, and so is
    /// every sweep over the rows.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// Tells the cells that the particles have been moved into [`order`](Cells::order), so that
    /// they need not be built again.
    pub fn settle(&mut self) {
        self.in_order = true;
        for (k, particle) in self.order.iter_mut().enumerate() {
            *particle = k as u32;
        }
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.order.len()
    }

    /// Whether there are no particles.
    pub fn is_empty(&self) -> bool {
        self.order.is_empty()
    }

    /// Bytes of all buffers.
    pub fn bytes(&self) -> usize {
        let indices = self.order.capacity() + self.keys.capacity() + self.starts.capacity();
        indices * size_of::<u32>() + self.sorted.capacity() * size_of::<Vector<T, D>>()
    }

    fn clear(&mut self) {
        self.grid = Grid::default();
        self.size = 0.0;
        self.in_order = true;
        self.order.clear();
        self.keys.clear();
        self.starts.clear();
        self.starts.resize(2, 0);
        self.sorted.clear();
    }

    /// Whether a search may use these cells for `points` \[m\].
    pub(crate) fn check<P: Domain<T, D>>(
        &self,
        parallel: &Parallel,
        domain: &P,
        points: &[Vector<T, D>],
        reach: T,
    ) -> Result<(), NeighborError> {
        if points.len() != self.len() {
            return Err(NeighborError::Stale { particle: points.len().min(self.len()) });
        }
        if points.is_empty() {
            return Ok(());
        }
        let reach = reach.to_double();
        if !(0.0..=self.size).contains(&reach) {
            return Err(NeighborError::Reach { reach, size: self.size });
        }
        if !self.grid.is_for(domain) {
            return Err(NeighborError::OtherDomain);
        }
        let differs = |k: usize| points[self.order[k] as usize] != self.sorted[k];
        let first =
            parallel.fold(points.len(), usize::MAX, &|k| if differs(k) { k } else { usize::MAX }, &|a, b| {
                a.min(b)
            });
        if first < usize::MAX {
            check_finite(points)?;
            return Err(NeighborError::Stale { particle: self.order[first] as usize });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Open;

    /// Particles in the fullest bucket: what a search has to go through at worst.
    fn fullest(flyer: f64, offset: f64) -> u32 {
        let mut points: Vec<Vector<f64, 2>> = (0..2500)
            .map(|i| Vector::from([f64::from(i % 50) + offset, f64::from(i / 50) + offset]))
            .collect();
        points[17] = Vector::from([flyer, -flyer]);
        let mut cells = Cells::new();
        cells.build(&Parallel::serial(), &Open, &points, 2.0).unwrap();
        cells.starts.windows(2).map(|pair| pair[1] - pair[0]).max().unwrap_or(0)
    }

    /// Clamping all coordinates to a fixed range once put everything into a single cell.
    #[test]
    fn far_particles_do_not_crowd_the_cells_of_the_others() {
        let regular = fullest(0.0, 0.0);
        assert!(regular <= 8);
        for flyer in [1e3, -1e6, 1e12, -1e12, 1e300] {
            for offset in [0.0, 1e6, -1e13] {
                let found = fullest(flyer, offset);
                assert!(found <= 3 * regular, "{found} in a bucket: one at {flyer}, all at {offset}");
            }
        }
    }
}
