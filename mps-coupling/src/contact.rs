//! Structures that come too near to a wall or to each other.
//!
//! Nothing but water acts between them: where none is left they would pass through one another without a word. So on the occasion of new
//! neighbour rows, which there are whenever somebody has moved by half a skin, their points are compared. Bodies in contact have points half
//! the sum of their spacings apart, and a quarter less is looked upon as one inside the other, whatever the offset of their
//! points: no place in a lattice is farther from it than 0.71 of its spacing, in space 0.87, where a body that comes nearer passes
//! 0.71.
//!
//! What touched from the start may go on to: a gate that stands on the floor, a flag held in a cylinder. A point that was near to a partner then
//! is never held against it, but the points behind it are.

use mps_fluid::Boundary;
use mps_kernel::{Real, Vector};
use mps_neighbors::{Cells, NeighborError, Open, Parallel, Rows};

/// Over half the sum of the spacings: nearer is too near, and what was nearer than this when it was added belongs together.
const TOO_NEAR: f64 = 0.75;
const NEAR: f64 = 1.5;
/// Owners that are told apart where points remember whom they were near to. The rest count as one.
const TOLD_APART: u32 = 63;

/// Two points that are too near.
pub(crate) struct Touch<T: Real, const D: usize> {
    /// Number of the structure.
    pub(crate) index: usize,
    /// Number of the other one; `None` for a wall.
    pub(crate) other: Option<usize>,
    /// Where the structure's point is \[m\].
    pub(crate) place: Vector<T, D>,
    /// Their distance \[m\].
    pub(crate) distance: T,
}

/// Who the points of a boundary belong to, and whom they have been near to from the start.
///
/// Images of periodic domains are not looked for.
#[derive(Default)]
pub(crate) struct Contacts<T: Real, const D: usize> {
    /// Spacing of each point \[m\].
    spacing: Vec<T>,
    largest: T,
    /// 0 for walls, 1 for structure 0 and so on.
    owner: Vec<u32>,
    /// The owners each point was near to, a bit for each.
    known: Vec<u64>,
    cells: Cells<T, D>,
    rows: Rows,
}

const fn bit(owner: u32) -> u64 {
    1 << if owner < TOLD_APART { owner } else { TOLD_APART }
}

impl<T: Real, const D: usize> Contacts<T, D> {
    /// Takes in the points of structure number `index` that the boundary is about to get, with their volumes over that of a particle of the
    /// fluid, and before the first one all walls. `spacing` \[m\] is that of the fluid.
    ///
    /// # Errors
    /// If a position is not finite; nothing has changed then.
    pub(crate) fn add(
        &mut self,
        parallel: &Parallel,
        index: usize,
        boundary: &Boundary<T, D>,
        points: &[Vector<T, D>],
        volumes: impl Iterator<Item = T>,
        spacing: T,
    ) -> Result<(), NeighborError> {
        let root = T::of(1.0 / D as f64);
        let side = |volume: T| spacing * volume.powf(root);
        let walls = boundary.volume.get(self.spacing.len()..).unwrap_or_default();
        self.spacing.extend(walls.iter().map(|volume| side(*volume)));
        self.owner.resize(boundary.len(), 0);
        self.known.resize(boundary.len(), 0);
        let new: Vec<T> = volumes.map(side).collect();
        self.largest = self.spacing.iter().chain(&new).fold(T::zero(), |most, l| most.max(*l));
        self.find(parallel, boundary, points, NEAR)?;

        let owner = index as u32 + 1;
        let mut known = vec![0; points.len()];
        for (p, point) in points.iter().enumerate() {
            for &q in self.rows.row(p) {
                let q = q as usize;
                let limit = (new[p] + self.spacing[q]) * T::of(0.5 * NEAR);
                if (point - boundary.position[q]).norm() < limit {
                    known[p] |= bit(self.owner[q]);
                    self.known[q] |= bit(owner);
                }
            }
        }
        self.spacing.extend(new);
        self.owner.resize(boundary.len() + points.len(), owner);
        self.known.extend(known);
        Ok(())
    }

    /// The first point of a structure that has come too near to somebody else.
    ///
    /// # Errors
    /// If a position is not finite.
    pub(crate) fn search(
        &mut self,
        parallel: &Parallel,
        boundary: &Boundary<T, D>,
    ) -> Result<Option<Touch<T, D>>, NeighborError> {
        let at_rest = |u: &Vector<T, D>| u.iter().all(|x| *x == T::zero());
        let alone = self.owner.first() == self.owner.last();
        if alone || boundary.len() != self.owner.len() || boundary.velocity.iter().all(at_rest) {
            return Ok(None);
        }
        let structures = boundary.reactive();
        self.find(parallel, boundary, &boundary.position[structures.clone()], TOO_NEAR)?;
        for (row, p) in structures.enumerate() {
            let Some(index) = (self.owner[p] as usize).checked_sub(1) else { continue };
            for &q in self.rows.row(row) {
                let q = q as usize;
                if let Some(distance) = self.too_near(boundary, p, q) {
                    let (other, place) = ((self.owner[q] as usize).checked_sub(1), boundary.position[p]);
                    return Ok(Some(Touch { index, other, place, distance }));
                }
            }
        }
        Ok(None)
    }

    /// Rows from these points to all points of the boundary that may be within so many spacings.
    fn find(
        &mut self,
        parallel: &Parallel,
        boundary: &Boundary<T, D>,
        from: &[Vector<T, D>],
        share: f64,
    ) -> Result<(), NeighborError> {
        let (points, reach) = (&boundary.position, self.largest * T::of(share));
        self.cells.build(parallel, &Open, points, reach)?;
        self.rows.build_between(parallel, &Open, &self.cells, from, points, reach)
    }

    /// Distance of two points \[m\] if it is too small, they have different owners and were not near to them from the start.
    fn too_near(&self, boundary: &Boundary<T, D>, p: usize, q: usize) -> Option<T> {
        let [a, b] = [self.owner[p], self.owner[q]];
        let together = a == b || self.known[p] & bit(b) != 0 || self.known[q] & bit(a) != 0;
        let distance = (boundary.position[p] - boundary.position[q]).norm();
        let limit = (self.spacing[p] + self.spacing[q]) * T::of(0.5 * TOO_NEAR);
        (!together && distance < limit).then_some(distance)
    }
}
