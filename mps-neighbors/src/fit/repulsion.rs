//! What a point feels of others and of the surface. Lengths are over the spacing here.

use mps_kernel::Vector;

/// Distance from which points do not feel each other: two rows of a lattice.
pub(super) const REACH: f64 = 2.0;

/// Push of one point on another at a distance: the slope of the weight `(1 - q/2)^3`, which does not vanish for points in one place.
pub(super) fn push(distance: f64) -> f64 {
    let s = (1.0 - distance / REACH).max(0.0);
    s * s
}

/// Share of the push of a row behind the surface: with all of it points would not come to rest on the outermost depth
/// but around it, with nothing they would crowd there. Found by trial between 0 and 1, on the shapes of `tests/fit.rs`.
const WALL: f64 = 0.5;

/// Push of the surface on a point at this depth, to the inside: a part of that of a row of the lattice half a spacing behind it.
/// The second row of a lattice feels none.
pub(super) fn wall<const D: usize>(depth: f64) -> f64 {
    let off = depth + 0.5;
    let around = 2 * REACH as usize + 1;
    let beside = |mut k: usize| -> f64 {
        let squares = (1..D).map(|_| {
            let along = (k % around) as f64 - REACH;
            k /= around;
            along * along
        });
        squares.sum()
    };
    let rows = (0..around.pow(D as u32 - 1)).map(|k| {
        let distance = (off * off + beside(k)).sqrt();
        push(distance) * off / distance
    });
    WALL * rows.sum::<f64>()
}

/// Direction of the push on a point that is this far from another one; from one in the same place, opposite for the two.
pub(super) fn direction<const D: usize>(apart: &Vector<f64, D>, first: bool) -> Vector<f64, D> {
    let along = if first { 1.0 } else { -1.0 };
    apart
        .try_normalize(1e-12)
        .unwrap_or_else(|| Vector::from_fn(|axis, _| if axis == 0 { along } else { 0.0 }))
}
