//! Volume of a shape, and as many cells of a lattice as it has.

use super::{FitError, Shape};
use crate::Parallel;
use mps_kernel::Vector;

/// Parts of a cell along each axis where the surface passes through it.
const PARTS: usize = 4;
/// Cells beyond which a box is refused.
const MOST: f64 = 1e8;

/// Where points begin, and how much volume each stands for.
pub(super) struct Seeds<const D: usize> {
    pub(super) places: Vec<Vector<f64, D>>,
    pub(super) volume: f64,
}

/// A cell of the lattice.
#[derive(Clone, Copy)]
struct Cell {
    /// Depth of its centre over the spacing.
    depth: f64,
    /// Share of it that is inside.
    share: f64,
}

/// As many cells as have the volume of the shape, those with the deepest centres.
///
/// The lattice begins at the lower corner of the box, so that one of whole cells is filled exactly.
pub(super) fn seeds<const D: usize>(
    shape: &impl Shape<D>,
    spacing: f64,
    parallel: &Parallel,
) -> Result<Seeds<D>, FitError> {
    let [lower, upper] = shape.bounds();
    let sides = (upper - lower) / spacing;
    if !(spacing > 0.0 && spacing.is_finite() && sides.iter().all(|side| *side > 0.0 && side.is_finite())) {
        return Err(FitError::Size { spacing });
    }
    let counts: [f64; D] = core::array::from_fn(|axis| (sides[axis] - 1e-6).ceil());
    let count: f64 = counts.iter().product();
    if count > MOST {
        return Err(FitError::TooMany { cells: count, spacing });
    }
    let centre = |k: usize| lower + digits::<D>(k, counts.map(|n| n as usize)).map(|n| n + 0.5) * spacing;
    let mut cells = vec![Cell { depth: 0.0, share: 0.0 }; count as usize];
    parallel.update(&mut cells[..], |k, cell| *cell = inside(shape, &centre(k), spacing));
    let volume = parallel.sum(cells.len(), |k| cells[k].share);
    let wanted = volume.round();
    if wanted < 1.0 {
        return Err(FitError::Empty { spacing });
    }
    let mut order: Vec<usize> = (0..cells.len()).collect();
    order.sort_by(|a, b| cells[*b].depth.total_cmp(&cells[*a].depth).then(a.cmp(b)));
    order.truncate(wanted as usize);
    order.sort_unstable();
    let places = order.into_iter().map(centre).collect();
    Ok(Seeds { places, volume: volume / wanted * spacing.powi(D as i32) })
}

/// How much of a cell is inside.
fn inside<const D: usize>(shape: &impl Shape<D>, centre: &Vector<f64, D>, spacing: f64) -> Cell {
    let depth = |place: &Vector<f64, D>| shape.nearest(place).map_or(-f64::INFINITY, |n| n.depth / spacing);
    let middle = depth(centre);
    let corner = 0.5 * (D as f64).sqrt();
    if middle.abs() >= corner {
        return Cell { depth: middle, share: if middle > 0.0 { 1.0 } else { 0.0 } };
    }
    let width = 1.0 / PARTS as f64;
    let parts = PARTS.pow(D as u32);
    let part = |k: usize| digits::<D>(k, [PARTS; D]).map(|n| (n + 0.5) * width - 0.5);
    let shares = (0..parts).map(|k| (0.5 + depth(&(centre + part(k) * spacing)) / width).clamp(0.0, 1.0));
    Cell { depth: middle, share: shares.sum::<f64>() / parts as f64 }
}

/// The number `k` of a cell as its numbers along the axes.
fn digits<const D: usize>(mut k: usize, counts: [usize; D]) -> Vector<f64, D> {
    Vector::from_fn(|axis, _| {
        let here = k % counts[axis];
        k /= counts[axis];
        here as f64
    })
}
