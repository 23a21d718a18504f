//! Moves points until they rest.

use super::repulsion::{REACH, direction, push, wall};
use super::seeds::{Seeds, seeds};
use super::shape::{at_depth, inward};
use super::{FitError, Fitted, Shape};
use crate::{Cells, NeighborError, Open, Parallel, Rows, Skin};
use mps_kernel::Vector;

/// Move over push: twice of it, and waves of the lattice would grow.
const MOBILITY: f64 = 0.5;
/// Longest move in a sweep over the spacing.
const LONGEST: f64 = 0.1;
/// Points rest when the longest move is shorter, over the spacing.
const REST: f64 = 2e-3;
/// Most sweeps.
const SWEEPS: usize = 400;
/// Room for moves between two searches, over the spacing.
const SKIN: f64 = 0.4;
/// Depth of the outermost points over the spacing.
const OUTERMOST: f64 = 0.5;
/// Depth that points need to have over the spacing.
const SHALLOW: f64 = 0.49;
/// Distance that points need to have over the spacing.
const CLOSE: f64 = 0.7;

/// A point on its way.
#[derive(Clone, Copy)]
struct Mover<const D: usize> {
    /// It is at least this deep, over the spacing, as far as it is known.
    depth: f64,
    /// How far it moved in this sweep, over the spacing.
    moved: f64,
    /// Where it goes \[m\].
    next: Vector<f64, D>,
}

/// Fills a shape with points about one `spacing` \[m\] apart, the outermost half a spacing inside its surface.
///
/// As many points as the volume of the shape has cells of the spacing, rounded. They begin as a lattice and repel each
/// other until none moves by more than 0.002 spacings, or 400 times. A box of whole cells is a lattice. The same bits for any
/// number of threads.
///
/// # Errors
/// If the spacing is no length, the shape has more than 1e8 cells or no room for a point, or is so thin somewhere that points
/// cannot be half a spacing inside, or not 0.7 spacings apart.
pub fn fit<const D: usize>(
    shape: &impl Shape<D>,
    spacing: f64,
    parallel: &Parallel,
) -> Result<Fitted<D>, FitError> {
    let Seeds { mut places, volume } = seeds(shape, spacing, parallel)?;
    let rest = Mover { depth: 0.0, moved: 0.0, next: Vector::zeros() };
    let mut movers = vec![rest; places.len()];
    parallel.update((&mut places[..], &mut movers[..]), |_, (place, mover)| {
        let (back, depth) = at_depth(shape, *place, OUTERMOST * spacing);
        (*place, mover.depth) = (back, depth / spacing);
    });
    let mut near = Near::new(spacing);
    let mut sweeps = 0;
    while sweeps < SWEEPS {
        near.search(&places, parallel)?;
        parallel.update(&mut movers[..], |i, mover| step(shape, &places, &near.rows, spacing, i, mover));
        parallel.update(&mut places[..], |i, place| *place = movers[i].next);
        sweeps += 1;
        if parallel.max(movers.len(), 0.0, |i| movers[i].moved) < REST {
            break;
        }
    }
    near.search(&places, parallel)?;
    check(shape, &places, &near.rows, spacing)?;
    Ok(Fitted { places, volume, sweeps })
}

/// Moves one point by what pushes it, and puts it back where it is too near to the surface.
fn step<const D: usize>(
    shape: &impl Shape<D>,
    places: &[Vector<f64, D>],
    rows: &Rows,
    spacing: f64,
    i: usize,
    mover: &mut Mover<D>,
) {
    let place = places[i];
    let mut pushed = Vector::zeros();
    for &j in rows.row(i) {
        let apart = (place - places[j as usize]) / spacing;
        pushed += direction(&apart, i < j as usize) * push(apart.norm());
    }
    // Who was deep before need not ask how deep it is.
    if mover.depth < REACH - 0.5
        && let Some(nearest) = shape.nearest(&place)
    {
        mover.depth = nearest.depth / spacing;
        if let Some(inward) = inward(shape, &place, &nearest, spacing) {
            pushed += inward * wall::<D>(mover.depth);
        }
    }
    let far = MOBILITY * pushed.norm();
    let shortened = if far > LONGEST { LONGEST / far } else { 1.0 };
    mover.next = place + pushed * (MOBILITY * shortened * spacing);
    mover.depth -= far * shortened;
    if mover.depth < OUTERMOST {
        let (back, depth) = at_depth(shape, mover.next, OUTERMOST * spacing);
        (mover.next, mover.depth) = (back, depth / spacing);
    }
    mover.moved = (mover.next - place).norm() / spacing;
}

/// Refuses points that are too near to the surface or to each other.
fn check<const D: usize>(
    shape: &impl Shape<D>,
    places: &[Vector<f64, D>],
    rows: &Rows,
    spacing: f64,
) -> Result<(), FitError> {
    let words = |place: &Vector<f64, D>| {
        let numbers: Vec<String> = place.iter().map(|x| format!("{x:.3e}")).collect();
        format!("({})", numbers.join(", "))
    };
    for (i, place) in places.iter().enumerate() {
        let depth = shape.nearest(place).map_or(0.0, |nearest| nearest.depth / spacing);
        if depth < SHALLOW {
            return Err(FitError::TooThin { place: words(place), depth, spacing });
        }
        for &j in rows.row(i) {
            let distance = (place - places[j as usize]).norm() / spacing;
            if distance < CLOSE {
                return Err(FitError::TooClose { place: words(place), distance, spacing });
            }
        }
    }
    Ok(())
}

/// Neighbours of points that move.
struct Near<const D: usize> {
    reach: f64,
    cells: Cells<f64, D>,
    rows: Rows,
    skin: Skin<f64, D>,
}

impl<const D: usize> Near<D> {
    fn new(spacing: f64) -> Self {
        let reach = (REACH + SKIN) * spacing;
        Self { reach, cells: Cells::new(), rows: Rows::default(), skin: Skin::new(SKIN * spacing) }
    }

    /// Finds the neighbours, unless those of before are still all.
    fn search(&mut self, places: &[Vector<f64, D>], parallel: &Parallel) -> Result<(), NeighborError> {
        if self.skin.expired(parallel, &Open, &[places]) {
            self.cells.build(parallel, &Open, places, self.reach)?;
            self.rows.build_within(parallel, &Open, &self.cells, places, self.reach)?;
            self.skin.renew(&[places]);
        }
        Ok(())
    }
}
