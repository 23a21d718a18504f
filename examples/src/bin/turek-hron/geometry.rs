//! Where water, walls and bodies are.

use crate::setup::Settings;
use mps_examples::rings;
use mps_examples::solid::flag::{CYLINDER, END, RADIUS, THICKNESS};
use mps_kernel::{Real, Vector};

/// Height of the channel \[m\].
pub(crate) const HEIGHT: f64 = 0.41;

/// The channel at rest: cell centres of a lattice outside cylinder and flag.
pub(crate) fn water<T: Real>(settings: &Settings) -> Vec<Vector<T, 2>> {
    let l0 = settings.spacing;
    let mut places = lattice([0.0, 0.0], [settings.length, HEIGHT], l0);
    places.retain(|place| !inside(*place, l0));
    to_vectors(&places)
}

/// Whether a cell centre is in a body, or so close to the cylinder that its cell is mostly inside.
fn inside(place: [f64; 2], l0: f64) -> bool {
    let [x, y] = [place[0] - CYLINDER[0], place[1] - CYLINDER[1]];
    let in_flag = x > 0.0 && place[0] < END[0] && y.abs() < 0.5 * THICKNESS;
    in_flag || x.hypot(y) < RADIUS + 0.3 * l0
}

/// Both walls, from the rear of the inlet to beyond the outlet.
pub(crate) fn walls<T: Real>(settings: &Settings) -> Vec<Vector<T, 2>> {
    let l0 = settings.spacing;
    let reach = settings.layers() as f64 * l0;
    let (from, to) = (-reach - l0, settings.length + 3.0 * reach);
    let mut places = lattice([from, -reach], [to, 0.0], l0);
    places.extend(lattice([from, HEIGHT], [to, HEIGHT + reach], l0));
    to_vectors(&places)
}

/// The cylinder as rings, the outermost half a spacing inside, with the area of each point.
pub(crate) fn cylinder<T: Real>(settings: &Settings) -> (Vec<Vector<T, 2>>, Vec<T>) {
    let (places, areas) = rings(CYLINDER, RADIUS, settings.spacing, settings.layers());
    (to_vectors(&places), areas.into_iter().map(T::of).collect())
}

/// Cell centres from `lower` on.
fn lattice(lower: [f64; 2], upper: [f64; 2], l0: f64) -> Vec<[f64; 2]> {
    let count = |axis: usize| ((upper[axis] - lower[axis]) / l0).round().max(0.0) as usize;
    let place = |axis: usize, k: usize| lower[axis] + (k as f64 + 0.5) * l0;
    (0..count(0)).flat_map(|i| (0..count(1)).map(move |j| [place(0, i), place(1, j)])).collect()
}

fn to_vectors<T: Real>(places: &[[f64; 2]]) -> Vec<Vector<T, 2>> {
    places.iter().map(|place| Vector::from(place.map(T::of))).collect()
}
