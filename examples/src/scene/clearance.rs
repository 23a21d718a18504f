//! How near two sets of points come to each other.

use super::lattice::Place;
use super::vector;
use mps_kernel::Vector;
use mps_neighbors::{Cells, NeighborError, Open, Parallel, Rows};

/// The nearest pair of two sets.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearest<const D: usize> {
    /// Distance \[m\].
    pub(super) distance: f64,
    /// Where it is, among the first set \[m\].
    pub(super) place: Place<D>,
}

/// The nearest pair of a point of `a` and one of `b`, if any two are within `reach` \[m\] of each other.
pub(super) fn nearest<const D: usize>(
    a: &[Place<D>],
    b: &[Place<D>],
    reach: f64,
    parallel: &Parallel,
) -> Result<Option<Nearest<D>>, NeighborError> {
    let [a, b] = [a, b].map(|places| places.iter().map(|p| vector(p)).collect::<Vec<Vector<f64, D>>>());
    let mut cells = Cells::new();
    cells.build(parallel, &Open, &b, reach)?;
    let mut rows = Rows::default();
    rows.build_between(parallel, &Open, &cells, &a, &b, reach)?;
    let pairs = (0..a.len()).flat_map(|i| rows.row(i).iter().map(move |j| (i, *j as usize)));
    let distances = pairs.map(|(i, j)| Nearest { distance: (a[i] - b[j]).norm(), place: a[i].into() });
    Ok(distances.min_by(|x, y| x.distance.total_cmp(&y.distance)))
}
