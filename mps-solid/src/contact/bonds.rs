//! Who of a body can meet whom of it.
//!
//! Particles of its surface can, unless a short way of reference pairs joins them. Where they were does not say it: the
//! sides of a narrow slot are near and belong to different walls, which nothing but contact holds apart. A short way
//! keeps its ends apart by itself, and what it joins comes near in every strained body: a row four pairs away is within the
//! reach of contact where the body is pressed to less than half. Particles inside meet nobody before the surface does, so
//! that no strain, however large, brings contact into the body.

use super::{ContactError, Shape};
use mps_kernel::{Neighborhood, Real, Vector};
use mps_neighbors::FrozenPairs;

/// Length of the directions to the neighbours, summed, over their number, from which on a particle belongs to the surface:
/// 0.48 and 0.29 on a plane face in 2D and 3D, 0.14 and 0.06 in a corner that points inwards, 0 inside.
const SURFACE: f64 = 0.05;

/// What the particles of the surface are joined to.
#[derive(Clone, Debug)]
pub(crate) struct Bonds {
    /// Row `i` is `list[starts[i]..starts[i + 1]]`.
    starts: Vec<usize>,
    /// For those of the surface, who is at most two pairs away and they themselves, ascending; nothing for the others.
    list: Vec<u32>,
}

impl Bonds {
    /// From the reference pairs of body number `body`.
    pub(crate) fn new<T: Real, const D: usize>(
        shape: &Shape<'_, T, D>,
        body: usize,
    ) -> Result<Self, ContactError> {
        let particles = shape.reference.len();
        let got = Neighborhood::len(shape.pairs);
        if got != particles {
            return Err(ContactError::Length { body, name: "pairs", got, particles });
        }
        let (mut starts, mut list) = (vec![0], Vec::new());
        let mut near: Vec<u32> = Vec::new();
        for i in 0..particles {
            if on_surface(shape.pairs, i) {
                near.clear();
                near.push(i as u32);
                for pair in shape.pairs.row(i) {
                    near.push(pair.j);
                    near.extend(shape.pairs.row(pair.j as usize).iter().map(|next| next.j));
                }
                near.sort_unstable();
                near.dedup();
                list.extend_from_slice(&near);
            }
            starts.push(list.len());
        }
        Ok(Self { starts, list })
    }

    /// Whether `i` and `j` can meet: both of the surface, more than four pairs apart.
    pub(crate) fn can_meet(&self, i: usize, j: usize) -> bool {
        let (a, b) = (self.row(i), self.row(j));
        if a.is_empty() || b.is_empty() || a.binary_search(&(j as u32)).is_ok() {
            return false;
        }
        // Two ways of two pairs that share their end are one of four.
        let (mut p, mut q) = (0, 0);
        while p < a.len() && q < b.len() {
            match a[p].cmp(&b[q]) {
                core::cmp::Ordering::Less => p += 1,
                core::cmp::Ordering::Greater => q += 1,
                core::cmp::Ordering::Equal => return false,
            }
        }
        true
    }

    fn row(&self, i: usize) -> &[u32] {
        &self.list[self.starts[i]..self.starts[i + 1]]
    }
}

fn on_surface<T: Real, const D: usize>(pairs: &FrozenPairs<T, D>, i: usize) -> bool {
    let row = pairs.row(i);
    let sum: Vector<T, D> = row.iter().map(|pair| pair.r0_ij / pair.r0_ij.norm()).sum();
    // A particle without neighbours is all surface.
    sum.norm() >= T::of(SURFACE * row.len() as f64)
}
