//! Finding the rows: one distance test for every candidate of the cells around a point.

use crate::cells::Cells;
use crate::grid::check_finite;
use crate::rows::{BLOCK, Block, Rows};
use crate::{Domain, NeighborError, Parallel};
use core::ops::Range;
use mps_kernel::{Real, Vector};

/// Most runs of places around a cell: 25 lines of cells, each cut once by the end of the grid.
const MOST_RUNS: usize = 50;

impl Rows {
    /// Row `i` becomes the particles `j != i` within `reach` \[m\] (inclusive) of `points[i]`.
    /// Every pair appears in both rows. `cells` must have been built from `points`.
    ///
    /// # Errors
    /// If `cells` were built from other positions, for another domain or for a smaller reach. The
    /// rows are empty then.
    pub fn build_within<T: Real, const D: usize, P: Domain<T, D>>(
        &mut self,
        parallel: &Parallel,
        domain: &P,
        cells: &Cells<T, D>,
        points: &[Vector<T, D>],
        reach: T,
    ) -> Result<(), NeighborError> {
        self.resize(0);
        cells.check(parallel, domain, points, reach)?;
        self.search(parallel, &Search::new(domain, cells, reach, true), points);
        Ok(())
    }

    /// Row `i` becomes the particles of `targets` within `reach` \[m\] (inclusive) of `queries[i]`.
    /// `cells` must have been built from `targets`.
    ///
    /// # Errors
    /// As [`build_within`](Rows::build_within), and if a query is not finite.
    pub fn build_between<T: Real, const D: usize, P: Domain<T, D>>(
        &mut self,
        parallel: &Parallel,
        domain: &P,
        cells: &Cells<T, D>,
        queries: &[Vector<T, D>],
        targets: &[Vector<T, D>],
        reach: T,
    ) -> Result<(), NeighborError> {
        self.resize(0);
        cells.check(parallel, domain, targets, reach)?;
        let finite = |i: usize| queries[i].iter().all(|x| x.is_finite());
        if !parallel.fold(queries.len(), true, &finite, &|a, b| a & b) {
            check_finite(queries)?;
        }
        self.search(parallel, &Search::new(domain, cells, reach, false), queries);
        Ok(())
    }

    fn search<T: Real, const D: usize, P: Domain<T, D>>(
        &mut self,
        parallel: &Parallel,
        search: &Search<'_, T, D, P>,
        queries: &[Vector<T, D>],
    ) {
        self.resize(queries.len());
        parallel.blocks(self.used_mut(), |b, block| {
            let first = b * BLOCK;
            let last = (first + BLOCK).min(queries.len());
            search.fill(block, first, &queries[first..last]);
        });
    }
}

struct Search<'a, T: Real, const D: usize, P> {
    domain: &'a P,
    cells: &'a Cells<T, D>,
    reach2: T,
    /// Cells to look at in each direction.
    steps: [i64; D],
    /// Queries are the particles of the cells themselves and do not find themselves.
    within: bool,
}

/// The places in which neighbours of one cell can be.
struct Runs {
    list: [(u32, u32); MOST_RUNS],
    len: usize,
    places: usize,
}

impl<'a, T: Real, const D: usize, P: Domain<T, D>> Search<'a, T, D, P> {
    fn new(domain: &'a P, cells: &'a Cells<T, D>, reach: T, within: bool) -> Self {
        let steps = cells.grid.steps(reach.to_double(), cells.size);
        Self { domain, cells, reach2: reach * reach, steps, within }
    }

    fn fill(&self, block: &mut Block, first: usize, queries: &[Vector<T, D>]) {
        let cells = self.cells;
        let mut runs = Runs { list: [(0, 0); MOST_RUNS], len: 0, places: 0 };
        let mut at = None;
        let mut len = 0;
        block.starts.push(0);
        for (k, from) in queries.iter().enumerate() {
            let cell = cells.grid.cell(from);
            // Particles in spatial order come cell by cell.
            if at != Some(cell) {
                at = Some(cell);
                self.find_runs(&cell, &mut runs);
            }
            block.reserve(len, runs.places);
            let row = &mut block.indices[len..len + runs.places];
            len += if cells.in_order {
                // Runs ascend and place k is particle k: the row comes out as wanted.
                let me = if self.within { first + k } else { usize::MAX };
                self.collect(from, me, &runs, row)
            } else {
                let found = self.collect(from, usize::MAX, &runs, row);
                let me = if self.within { Some((first + k) as u32) } else { None };
                name(&mut row[..found], cells.order(), me)
            };
            block.starts.push(len);
        }
    }

    fn find_runs(&self, cell: &[i64; D], runs: &mut Runs) {
        (runs.len, runs.places) = (0, 0);
        let starts = &self.cells.starts;
        self.cells.grid.for_runs(cell, &self.steps, |from, to| {
            let (start, end) = (starts[from], starts[to]);
            if start < end {
                runs.list[runs.len] = (start, end);
                runs.len += 1;
                runs.places += (end - start) as usize;
            }
        });
        // Out of order only where the grid wraps.
        if !runs.list[..runs.len].is_sorted() {
            runs.list[..runs.len].sort_unstable();
        }
    }

    /// Writes the places within reach, except place `me`.
    #[inline(always)]
    fn collect(&self, from: &Vector<T, D>, me: usize, runs: &Runs, row: &mut [u32]) -> usize {
        let mut len = 0;
        for &(start, end) in &runs.list[..runs.len] {
            let (start, end) = (start as usize, end as usize);
            if (start..end).contains(&me) {
                len += self.test(from, start..me, &mut row[len..]);
                len += self.test(from, me + 1..end, &mut row[len..]);
            } else {
                len += self.test(from, start..end, &mut row[len..]);
            }
        }
        len
    }

    #[inline(always)]
    fn test(&self, from: &Vector<T, D>, places: Range<usize>, row: &mut [u32]) -> usize {
        let mut len = 0;
        for (place, to) in places.clone().zip(&self.cells.sorted[places]) {
            let near = self.domain.separation(from, to).norm_squared() <= self.reach2;
            // Written always and kept if near: the branch would be mispredicted every third time.
            row[len] = place as u32;
            len += usize::from(near);
        }
        len
    }
}

/// Turns places into particles other than `me`, ascending. Returns how many there are.
fn name(row: &mut [u32], order: &[u32], me: Option<u32>) -> usize {
    for place in row.iter_mut() {
        *place = order[*place as usize];
    }
    row.sort_unstable();
    match me.map(|me| row.binary_search(&me)) {
        Some(Ok(k)) => {
            row.copy_within(k + 1.., k);
            row.len() - 1
        }
        _ => row.len(),
    }
}
