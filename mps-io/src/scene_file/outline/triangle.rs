//! A triangle of a surface, seen by points and by rays along x.

use mps_kernel::Vector;

type Place = Vector<f64, 3>;

/// A triangle with its corners \[m\] counter-clockwise seen from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::scene_file) struct Triangle {
    pub(super) corners: [Place; 3],
}

impl From<[[f64; 3]; 3]> for Triangle {
    fn from(corners: [[f64; 3]; 3]) -> Self {
        Self { corners: corners.map(Place::from) }
    }
}

impl Triangle {
    /// Its sides, each with the next.
    pub(super) fn sides(&self) -> [[Place; 2]; 3] {
        let [a, b, c] = self.corners;
        [[a, b], [b, c], [c, a]]
    }

    /// Across it, to the outside, with twice its area as length.
    pub(super) fn normal(&self) -> Place {
        let [a, b, c] = self.corners;
        (b - a).cross(&(c - a))
    }

    /// Volume of the tetrahedron to the origin, negative if the outside is on its side \[m^3\].
    pub(super) fn volume(&self) -> f64 {
        let [a, b, c] = self.corners;
        a.dot(&b.cross(&c)) / 6.0
    }

    /// How often a ray from `r` along x goes out through it: 1, -1 for in, 0 for not at all.
    ///
    /// The plane across z through `r` cuts it from one side to another one. Each end is computed of its side alone, so that those of all
    /// triangles make closed lines, to which a triangle seen edge-on belongs like any other.
    pub(super) fn crossed_by_a_ray(&self, r: &Place) -> i32 {
        let (mut up, mut down) = (None, None);
        for side in self.sides() {
            let end = if side[0].z > r.z { &mut down } else { &mut up };
            *end = at_height(r.z, side).or(*end);
        }
        let (Some([x, y]), Some([x_down, y_down])) = (up, down) else { return 0 };
        if (y > r.y) == (y_down > r.y) || x + (x_down - x) * ((r.y - y) / (y_down - y)) <= r.x {
            return 0;
        }
        if y > r.y { 1 } else { -1 }
    }

    /// Whether a point is at most this far away \[m\].
    pub(super) fn is_near(&self, r: &Place, distance: f64) -> bool {
        let (lower, upper) = self.bounds();
        if (0..3).any(|axis| r[axis] < lower[axis] - distance || r[axis] > upper[axis] + distance) {
            return false;
        }
        let normal = self.normal();
        let over = self.sides().iter().all(|[a, b]| normal.dot(&(b - a).cross(&(r - a))) >= 0.0);
        let off = (r - self.corners[0]).dot(&normal).abs() / normal.norm();
        over && off <= distance || self.sides().iter().any(|side| to_side(r, *side) <= distance)
    }

    /// Its point nearest to a place: within it, or on one of its sides.
    pub(in crate::scene_file) fn foot(&self, r: &Place) -> Place {
        let normal = self.normal();
        if self.sides().iter().all(|[a, b]| normal.dot(&(b - a).cross(&(r - a))) >= 0.0) {
            let off = normal.dot(&(r - self.corners[0])) / normal.norm_squared();
            if off.is_finite() {
                return r - normal * off;
            }
        }
        let [mut nearest, second, third] = self.sides().map(|side| on_side(r, side));
        for foot in [second, third] {
            if (foot - r).norm_squared() < (nearest - r).norm_squared() {
                nearest = foot;
            }
        }
        nearest
    }

    /// The corners of the box around it \[m\].
    pub(super) fn bounds(&self) -> (Place, Place) {
        let [a, b, c] = &self.corners;
        (a.inf(b).inf(c), a.sup(b).sup(c))
    }
}

/// x and y where a side passes this height, the same for both triangles that share it; an end belongs to the part of the side above it.
fn at_height(z: f64, [a, b]: [Place; 2]) -> Option<[f64; 2]> {
    if (a.z > z) == (b.z > z) {
        return None;
    }
    let [a, b] = if a.z < b.z { [a, b] } else { [b, a] };
    let share = (z - a.z) / (b.z - a.z);
    Some([a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share])
}

/// Distance to a side \[m\].
fn to_side(r: &Place, side: [Place; 2]) -> f64 {
    (r - on_side(r, side)).norm()
}

/// The point of a side nearest to a place.
fn on_side(r: &Place, [a, b]: [Place; 2]) -> Place {
    let along = b - a;
    a + along * ((r - a).dot(&along) / along.norm_squared()).clamp(0.0, 1.0)
}
