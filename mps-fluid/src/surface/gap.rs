//! The gap between neighbours: the largest cone around a particle in which nobody stands.
//!
//! In the plane this is the largest angle between neighbours next to each other, a share of the full angle `2 pi`. In space it is the
//! largest circular cone without a neighbour, a share of the full solid angle `4 pi`: a cone of half-angle `a` has the share
//! `a/pi` of the one and `(1 - cos a)/2` of the other. A quarter, the limit of the paper, is half-angles of 45 and 60 degrees.

use core::f64::consts::PI;
use mps_kernel::{Real, Vector};

/// Neighbours that are looked at, the first ones: more than a neighbourhood of four spacings in space has, half of it a wall of points at
/// half the spacing.
pub(super) const MOST: usize = 2048;
/// How far round-off moves the cosine of an angle, and by how much a gap has to be wider than the limit.
const ROUND_OFF: f64 = 1e-9;
const WIDER: f64 = 1e-6;

/// Whether directions to the neighbours leave a gap of more than `share` of the full angle (2D) or solid angle (3D).
///
/// `lean`: the mean direction to the neighbours; its opposite is tried first. The answer does not depend on it.
pub fn has_gap<T: Real, const D: usize>(neighbors: &[Vector<T, D>], lean: &Vector<T, D>, share: f64) -> bool {
    if D == 2 {
        return largest_gap(neighbors) > 2.0 * (share * PI);
    }
    let (mut units, mut len) = ([[0.0; 3]; MOST], 0);
    for unit in neighbors.iter().filter_map(|r| direction(r)).take(MOST) {
        units[len] = unit;
        len += 1;
    }
    let cones = Cones { units: &units[..len], cosine: 1.0 - 2.0 * share - WIDER };
    direction(&-lean).is_some_and(|axis| cones.is_free(&axis)) || cones.any_free()
}

/// Largest angle \[rad\] between neighbours next to each other, seen from the particle (2D).
/// Without neighbours it is the full angle.
pub fn largest_gap<T: Real, const D: usize>(neighbors: &[Vector<T, D>]) -> f64 {
    let mut angles = [0.0_f64; MOST];
    let mut len = 0;
    for r in neighbors.iter().take(MOST) {
        angles[len] = r[1].to_double().atan2(r[0].to_double());
        len += 1;
    }
    let full = 2.0 * PI;
    let angles = &mut angles[..len];
    angles.sort_unstable_by(f64::total_cmp);
    match (angles.first(), angles.last()) {
        (Some(first), Some(last)) => {
            let around = first + full - last;
            angles.windows(2).map(|w| w[1] - w[0]).fold(around, f64::max)
        }
        _ => full,
    }
}

/// Unit vectors to the neighbours, and the cosine of the half-angle of the cone that is looked for.
struct Cones<'a> {
    units: &'a [[f64; 3]],
    cosine: f64,
}

impl Cones<'_> {
    /// Whether nobody stands in the cone about `axis`; on its edge they may.
    fn is_free(&self, axis: &[f64; 3]) -> bool {
        self.units.iter().all(|unit| dot(unit, axis) <= self.cosine + ROUND_OFF)
    }

    /// Whether any cone is free. The axes of free cones are what the caps of this half-angle about all neighbours leave of
    /// the sphere. If they leave something, then also a piece of its rim: a point where two rims cross, or the whole rim of a cap.
    fn any_free(&self) -> bool {
        let rims = self.units.iter().enumerate();
        self.units.is_empty()
            || rims.clone().any(|(i, a)| {
                self.is_free(&self.on_rim(a))
                    || self.units[..i].iter().any(|b| {
                        self.crossings(a, b).is_some_and(|both| both.iter().any(|axis| self.is_free(axis)))
                    })
            })
    }

    /// Any point of the rim of the cap about `a`.
    fn on_rim(&self, a: &[f64; 3]) -> [f64; 3] {
        // The coordinate axis that is least along it.
        let least = (0..3).fold(0, |least, k| if a[k].abs() < a[least].abs() { k } else { least });
        let mut other = [0.0; 3];
        other[least] = 1.0;
        let side = cross(a, &other);
        let sine = ((1.0 - self.cosine * self.cosine).max(0.0) / dot(&side, &side)).sqrt();
        core::array::from_fn(|k| self.cosine * a[k] + sine * side[k])
    }

    /// Where the rims of the caps about `a` and `b` cross.
    fn crossings(&self, a: &[f64; 3], b: &[f64; 3]) -> Option<[[f64; 3]; 2]> {
        let normal = cross(a, b);
        let (sine2, together) = (dot(&normal, &normal), 1.0 + dot(a, b));
        let along = self.cosine / together;
        let off = ((1.0 - self.cosine * along * 2.0) / sine2).sqrt();
        // Neither where they lie side by side or opposite, nor where they are too far apart.
        off.is_finite()
            .then(|| [off, -off].map(|off| core::array::from_fn(|k| along * (a[k] + b[k]) + off * normal[k])))
    }
}

/// Of length one, with zeros for what a space of fewer dimensions lacks; `None` without a length.
fn direction<T: Real, const D: usize>(r: &Vector<T, D>) -> Option<[f64; 3]> {
    let r = core::array::from_fn(|k| if k < D { r[k].to_double() } else { 0.0 });
    let norm = dot(&r, &r).sqrt();
    (norm > 0.0).then(|| r.map(|x| x / norm))
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    core::array::from_fn(|k| {
        let (l, m) = ((k + 1) % 3, (k + 2) % 3);
        a[l] * b[m] - a[m] * b[l]
    })
}
