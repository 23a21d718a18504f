//! The surface of a region: where it is nearest to a place.
//!
//! | file | what it does |
//! |---|---|
//! | `piece` | simple surfaces, and their nearest points |
//! | `pieces` | the simple surfaces that a region is bounded by |

mod piece;
mod pieces;

use super::region::{Corners, Region};
use mps_kernel::Vector;
use piece::Piece;
use pieces::pieces;

type Place = Vector<f64, 3>;

/// What rounding may move, over the size of the region.
const ROUNDING: f64 = 1e-9;
/// How far on both sides of a point it is looked whether the surface is there, over the size of the region.
const BESIDE: f64 = 1e-6;
/// Directions in which it is looked.
const DIRECTIONS: usize = 32;
/// How far beside a covered point the way to an edge begins, over its distance.
const ASIDE: f64 = 0.1;
/// Most often that a place is put from one piece to another one.
const TURNS: usize = 60;

/// The surface of a region, in two dimensions its line.
///
/// Parts of a union or a difference cover some of each other's surfaces. What is left are pieces of them, up to the edges where
/// they cross.
#[derive(Clone, Debug)]
pub struct Surface<'a> {
    region: &'a Region,
    pieces: Vec<(usize, Piece)>,
    directions: Vec<Place>,
    size: f64,
}

/// Where a surface is nearest to a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// The point of the surface \[m\], in two dimensions with a zero behind.
    pub place: [f64; 3],
    /// How deep the place is inside the region \[m\], negative outside.
    pub depth: f64,
}

/// A piece, its point that is nearest to a place, and how far that is.
#[derive(Clone, Copy)]
struct Near {
    piece: usize,
    foot: Place,
    distance: f64,
}

impl Region {
    /// Its surface; `None` if it has no end or is made of nothing.
    pub fn surface(&self) -> Option<Surface<'_>> {
        let Corners { lower, upper } = self.bounds()?;
        let size = (place(&upper) - place(&lower)).norm();
        let directions = (0..DIRECTIONS).map(|k| direction(k, lower.len())).collect();
        Some(Surface { region: self, pieces: pieces(self), directions, size })
    }
}

impl Surface<'_> {
    /// Where the surface is nearest to a place \[m\]. Exact where the nearest point is on a simple shape, or where two of them cross
    /// in the plane; at an edge in space, where a curved surface crosses another one, a point of that edge near it.
    pub fn nearest(&self, point: &[f64]) -> Option<Foot> {
        let from = place(point);
        let mut best: Option<Near> = None;
        let mut last = (-1.0, 0);
        // The pieces from the nearest on, until the surface is found.
        while let Some(near) = self.next(&from, last, best.map_or(f64::INFINITY, |best| best.distance)) {
            if self.is_surface(&near.foot, &from, point.len()) {
                best = Some(near);
                break;
            }
            best = self.edge(&near, &from, best, point.len());
            last = (near.distance, near.piece + 1);
        }
        let Near { foot, distance, .. } = best?;
        let inside = self.region.contains(point, ROUNDING * self.size);
        Some(Foot { place: foot.into(), depth: if inside { distance } else { -distance } })
    }

    /// The piece that is nearest, of those beyond the last one, and within `reach` \[m\].
    fn next(&self, from: &Place, (last, beyond): (f64, usize), reach: f64) -> Option<Near> {
        let near = self.pieces.iter().enumerate().map(|(piece, (_, shape))| {
            let foot = shape.foot(from);
            Near { piece, foot, distance: (foot - from).norm() }
        });
        near.filter(|near| (near.distance, near.piece) >= (last, beyond) && near.distance < reach)
            .min_by(|a, b| a.distance.total_cmp(&b.distance))
    }

    /// Whether the region begins at a place: it is on one side of it and not on the other.
    fn is_surface(&self, foot: &Place, from: &Place, dimension: usize) -> bool {
        let inside = |direction: &Place| {
            let beside: [f64; 3] = (foot + direction * (BESIDE * self.size)).into();
            self.region.contains(&beside[..dimension], ROUNDING * self.size)
        };
        let toward = (from - foot).try_normalize(ROUNDING * self.size).unwrap_or(self.directions[0]);
        let first = inside(&toward);
        inside(&-toward) != first || self.directions.iter().any(|direction| inside(direction) != first)
    }

    /// The best place so far, or the edge where a covered piece comes out of another shape, if that is nearer.
    fn edge(&self, covered: &Near, from: &Place, mut best: Option<Near>, dimension: usize) -> Option<Near> {
        let (shape, piece) = &self.pieces[covered.piece];
        for (_, other) in self.pieces.iter().filter(|(of, _)| of != shape) {
            let reach = best.map_or(f64::INFINITY, |best| best.distance);
            if (other.foot(&covered.foot) - covered.foot).norm() > covered.distance + reach {
                continue;
            }
            // Also from beside the foot: two round pieces may face each other there, and the edge be on either side.
            let aside = self.directions.iter().step_by(DIRECTIONS / 4).copied();
            for direction in core::iter::once(Place::zeros()).chain(aside) {
                let start = covered.foot + direction * (ASIDE * covered.distance);
                let Some(foot) = crossing(piece, other, start, ROUNDING * self.size) else { continue };
                let distance = (foot - from).norm();
                if best.is_none_or(|best| distance < best.distance) && self.is_surface(&foot, from, dimension)
                {
                    best = Some(Near { piece: covered.piece, foot, distance });
                }
            }
        }
        best
    }
}

/// Where two pieces cross, near a place.
///
/// From one piece to the other and back; each turn is a share of the one before, so that after two all that would follow is done at
/// once: where pieces cross at a small angle, hundreds would be needed.
fn crossing(one: &Piece, other: &Piece, mut place: Place, rounding: f64) -> Option<Place> {
    let mut before: Option<f64> = None;
    for _ in 0..TURNS {
        let there = other.foot(&place);
        let next = one.foot(&there);
        if (next - there).norm() <= rounding {
            return Some(next);
        }
        let turn = next - place;
        let share = before.map_or(1.0, |before| turn.norm() / before);
        (place, before) = if share < 1.0 {
            (one.foot(&(next + turn * (share / (1.0 - share)))), None)
        } else {
            (next, Some(turn.norm()))
        };
    }
    None
}

/// Directions that are spread over a circle or, along a spiral, over a sphere; none along an axis.
fn direction(k: usize, dimension: usize) -> Place {
    let k = k as f64 + 0.5;
    let n = DIRECTIONS as f64;
    if dimension == 2 {
        let angle = core::f64::consts::TAU * (k + 0.1) / n;
        return Place::new(angle.cos(), angle.sin(), 0.0);
    }
    let z = 1.0 - 2.0 * k / n;
    let (round, angle) = ((1.0 - z * z).sqrt(), 2.399963 * k);
    Place::new(round * angle.cos(), round * angle.sin(), z)
}

/// A place of two or three numbers.
fn place(point: &[f64]) -> Place {
    Place::from_fn(|axis, _| point.get(axis).copied().unwrap_or(0.0))
}

#[cfg(test)]
mod tests;
