//! From coordinates to buckets: a wrapping grid over unbounded space.
//!
//! Cells cover all of space, buckets are few: along each axis cell `c` belongs to bucket
//! `c mod n`. When the particles' bounding box fits, every cell has its own bucket; when a particle
//! has flown far off, distant cells share one and the distance test tells their particles apart. So
//! memory depends on the number of particles alone, never on where they are.

use crate::{Domain, NeighborError, Parallel};
use mps_kernel::{Real, Vector};

/// Cells are wider than asked for by this factor: far more than the rounding of cell coordinates.
const MARGIN: f64 = 1.0 + 1.0 / 1024.0;
/// Farther out than this many cells everything shares the last cell (2^32: rounding stays below
/// the margin).
const FARTHEST: f64 = 4_294_967_296.0;
/// Makes cell coordinates positive, so that cutting off the fraction rounds down.
const SHIFT: f64 = 2.0 * FARTHEST;
/// More periods away than this the place in the box is not known well enough.
const MOST_PERIODS: f64 = 1_048_576.0;

#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Axis {
    origin: f64,
    /// One over the cell size, or over the period.
    inverse: f64,
    periodic: bool,
    /// Occupied cells are `lowest..lowest + cells` along an open axis.
    lowest: i64,
    cells: i64,
    buckets: i64,
}

impl Axis {
    /// Non-decreasing in `x` along an open axis: clamping and rounding bring cells closer together,
    /// never farther apart. Relative to the lowest occupied cell.
    #[inline(always)]
    fn cell(&self, x: f64) -> i64 {
        let u = (x - self.origin) * self.inverse;
        if self.periodic {
            let fraction = if (0.0..1.0).contains(&u) { u } else { u - u.floor() };
            ((fraction * self.buckets as f64) as i64).min(self.buckets - 1)
        } else {
            (u.clamp(-FARTHEST, FARTHEST) + SHIFT) as i64 - self.lowest
        }
    }

    #[inline(always)]
    fn bucket(&self, cell: i64) -> i64 {
        if (0..self.buckets).contains(&cell) { cell } else { cell.rem_euclid(self.buckets) }
    }

    /// First bucket and number of buckets of the cells up to `steps` away; they may run over the
    /// end. Each bucket appears once, so no particle is found twice.
    #[inline]
    fn around(&self, cell: i64, steps: i64) -> (i64, i64) {
        let (from, to) = if self.periodic {
            (cell - steps, cell + steps)
        } else {
            ((cell - steps).max(0), (cell + steps).min(self.cells - 1))
        };
        (self.bucket(from), (to - from + 1).clamp(0, self.buckets))
    }
}

/// The grid of one set of particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grid<const D: usize> {
    axes: [Axis; D],
    /// Cells along each axis that make up one size.
    per_size: [i64; D],
    /// Lower end and length of periodic axes, to recognise the domain.
    periods: [Option<(f64, f64)>; D],
}

/// Least and greatest coordinate of every axis.
#[derive(Clone, Copy)]
struct Bounds<T: Real, const D: usize> {
    least: Vector<T, D>,
    greatest: Vector<T, D>,
    finite: bool,
}

impl<T: Real, const D: usize> Bounds<T, D> {
    fn of(parallel: &Parallel, positions: &[Vector<T, D>]) -> Self {
        let empty = Self {
            least: Vector::repeat(T::of(f64::INFINITY)),
            greatest: Vector::repeat(T::of(f64::NEG_INFINITY)),
            finite: true,
        };
        let point = |i: usize| {
            let p = positions[i];
            Self { least: p, greatest: p, finite: p.iter().all(|x| x.is_finite()) }
        };
        parallel.fold(positions.len(), empty, &point, &|a, b| Self {
            least: a.least.zip_map(&b.least, |x, y| if y < x { y } else { x }),
            greatest: a.greatest.zip_map(&b.greatest, |x, y| if y > x { y } else { x }),
            finite: a.finite & b.finite,
        })
    }
}

impl<const D: usize> Default for Grid<D> {
    fn default() -> Self {
        Self { axes: [Axis { buckets: 1, ..Axis::default() }; D], per_size: [1; D], periods: [None; D] }
    }
}

impl<const D: usize> Grid<D> {
    /// A grid for these positions, in at most `budget` buckets. `size` is the largest reach.
    pub(crate) fn fit<T: Real, P: Domain<T, D>>(
        parallel: &Parallel,
        domain: &P,
        positions: &[Vector<T, D>],
        size: f64,
        budget: usize,
    ) -> Result<Self, NeighborError> {
        let bounds = Bounds::of(parallel, positions);
        if !bounds.finite {
            check_finite(positions)?;
        }
        let periods = periods(domain);
        if positions.is_empty() {
            return Ok(Self { periods, ..Self::default() });
        }
        // Finer cells hug the sphere of the search more closely. Along x this costs nothing, as
        // cells in a line are searched in one go; in 2D more lines cost more than they save.
        let fine = core::array::from_fn(|axis| if axis == 0 || D == 3 { 2 } else { 1 });
        let mut grid = Self { periods, per_size: fine, ..Self::default() };
        grid.lay(positions, &bounds, size)?;
        if grid.largest_side(budget) < grid.most_cells() {
            grid.per_size = [1; D];
            grid.lay(positions, &bounds, size)?;
        }
        let side = grid.largest_side(budget);
        for axis in &mut grid.axes {
            axis.buckets = axis.cells.min(side);
        }
        Ok(grid)
    }

    /// Lays the axes through the bounds of the positions, as many buckets as cells.
    fn lay<T: Real>(
        &mut self,
        positions: &[Vector<T, D>],
        bounds: &Bounds<T, D>,
        size: f64,
    ) -> Result<(), NeighborError> {
        for index in 0..D {
            let (least, greatest) = (bounds.least[index].to_double(), bounds.greatest[index].to_double());
            let per_size = self.per_size[index] as f64;
            let mut axis = Axis::default();
            if let Some((lower, length)) = self.periods[index] {
                if length < 2.0 * size {
                    return Err(NeighborError::ShortPeriod { axis: index, length, size });
                }
                let farthest = (least - lower).abs().max((greatest - lower).abs());
                if farthest > MOST_PERIODS * length {
                    return Err(too_far(positions, index, lower, length));
                }
                // Separations across the edge are rounded relative to the period, not to the size.
                let rounding = 16.0 * T::default_epsilon().to_double() * (farthest + length);
                axis.origin = lower;
                axis.inverse = 1.0 / length;
                axis.periodic = true;
                axis.cells = (length * per_size / (size * MARGIN + rounding)).clamp(1.0, FARTHEST) as i64;
            } else {
                let cell = size * MARGIN / per_size;
                axis.inverse = 1.0 / cell;
                // Zero unless everything is very far away: cells then do not depend on the order of the
                // particles, and sorted particles are found to be sorted.
                axis.origin = (typical(positions, index) * axis.inverse / FARTHEST).round() * FARTHEST * cell;
                axis.lowest = axis.cell(least);
                axis.cells = axis.cell(greatest) + 1;
            }
            axis.buckets = axis.cells;
            self.axes[index] = axis;
        }
        Ok(())
    }

    fn most_cells(&self) -> i64 {
        self.axes.iter().map(|axis| axis.cells).max().unwrap_or(1)
    }

    /// Largest side to which the axes can be cut so that all buckets are within `budget`.
    fn largest_side(&self, budget: usize) -> i64 {
        let fits = |side: i64| {
            let product: u128 = self.axes.iter().map(|axis| axis.cells.min(side) as u128).product();
            product <= budget as u128
        };
        let (mut good, mut bad) = (1, self.most_cells().min(budget as i64) + 1);
        while bad - good > 1 {
            let side = good + (bad - good) / 2;
            if fits(side) { good = side } else { bad = side }
        }
        good
    }

    /// How many cells `reach` extends over along each axis, if cells were made for `size`.
    pub(crate) fn steps(&self, reach: f64, size: f64) -> [i64; D] {
        self.per_size
            .map(|per_size| (reach * per_size as f64 / size).ceil().clamp(1.0, per_size as f64) as i64)
    }

    /// Number of buckets.
    pub(crate) fn buckets(&self) -> usize {
        self.axes.iter().map(|axis| axis.buckets as usize).product()
    }

    /// Whether the periods are those the grid was made for.
    pub(crate) fn is_for<T: Real>(&self, domain: &impl Domain<T, D>) -> bool {
        self.periods == periods(domain)
    }

    /// The cell a point lies in.
    #[inline(always)]
    pub(crate) fn cell<T: Real>(&self, p: &Vector<T, D>) -> [i64; D] {
        core::array::from_fn(|axis| self.axes[axis].cell(p[axis].to_double()))
    }

    /// The bucket of a cell; x runs fastest.
    #[inline(always)]
    pub(crate) fn bucket(&self, cell: &[i64; D]) -> usize {
        (0..D).rev().fold(0, |index, a| index * self.axes[a].buckets + self.axes[a].bucket(cell[a])) as usize
    }

    /// Shows the buckets of the cells up to `steps` from `cell`, each once, as runs `first..end`.
    #[inline]
    pub(crate) fn for_runs(&self, cell: &[i64; D], steps: &[i64; D], mut run: impl FnMut(usize, usize)) {
        // A missing axis is one bucket wide.
        let around = |a: usize| match self.axes.get(a) {
            Some(axis) => (axis.around(cell[a], steps[a]), axis.buckets),
            None => ((0, 1), 1),
        };
        let ((x, x_count), x_side) = around(0);
        let ((y, y_count), y_side) = around(1);
        let ((z, z_count), z_side) = around(2);
        let turn = |bucket: i64, side: i64| if bucket >= side { bucket - side } else { bucket };
        for z in (z..z + z_count).map(|z| turn(z, z_side)) {
            for y in (y..y + y_count).map(|y| turn(y, y_side)) {
                let line = (z * y_side + y) * x_side;
                let end = x + x_count;
                run((line + x) as usize, (line + end.min(x_side)) as usize);
                if end > x_side {
                    run(line as usize, (line + end - x_side) as usize);
                }
            }
        }
    }
}

/// An error naming the first position that is not finite.
pub(crate) fn check_finite<T: Real, const D: usize>(positions: &[Vector<T, D>]) -> Result<(), NeighborError> {
    for (particle, p) in positions.iter().enumerate() {
        if let Some(axis) = p.iter().position(|x| !x.is_finite()) {
            return Err(NeighborError::NotFinite { particle, axis, value: p[axis].to_double() });
        }
    }
    Ok(())
}

fn too_far<T: Real, const D: usize>(
    positions: &[Vector<T, D>],
    axis: usize,
    lower: f64,
    length: f64,
) -> NeighborError {
    let away = |p: &Vector<T, D>| (p[axis].to_double() - lower).abs() > MOST_PERIODS * length;
    let particle = positions.iter().position(away).unwrap_or_default();
    NeighborError::TooFar { particle, axis, value: positions[particle][axis].to_double(), length }
}

fn periods<T: Real, const D: usize>(domain: &impl Domain<T, D>) -> [Option<(f64, f64)>; D] {
    core::array::from_fn(|a| domain.period(a).map(|(lower, length)| (lower.to_double(), length.to_double())))
}

/// The median of some of the coordinates: near the bulk, wherever single particles have gone.
fn typical<T: Real, const D: usize>(positions: &[Vector<T, D>], axis: usize) -> f64 {
    const SAMPLES: usize = 63;
    let mut samples: [f64; SAMPLES] =
        core::array::from_fn(|k| positions[k * positions.len() / SAMPLES][axis].to_double());
    samples.sort_unstable_by(f64::total_cmp);
    samples[SAMPLES / 2]
}
