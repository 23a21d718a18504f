//! A triangle of a surface, seen by points and by rays along x.

use mps_kernel::Vector;

type Place = Vector<f64, 3>;

/// A triangle with its corners \[m\] counter-clockwise seen from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Triangle {
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
    pub(super) fn crossed_by_a_ray(&self, r: &Place) -> i32 {
        let normal = self.normal();
        // Seen along x: a point is inside if a ray from it along y crosses an odd number of sides.
        let odd = self.sides().into_iter().filter(|side| is_below(r, *side)).count() % 2 == 1;
        let ahead = (self.corners[0] - r).dot(&normal) / normal.x;
        if odd && ahead > 0.0 { if normal.x > 0.0 { 1 } else { -1 } } else { 0 }
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

    /// The corners of the box around it \[m\].
    pub(super) fn bounds(&self) -> (Place, Place) {
        let [a, b, c] = &self.corners;
        (a.inf(b).inf(c), a.sup(b).sup(c))
    }
}

/// Whether a ray from a point along y crosses a side, seen along x. Of two triangles that share the side both get the same answer,
/// because it is always computed from the same end; an end belongs to the part of the side above it.
fn is_below(r: &Place, [a, b]: [Place; 2]) -> bool {
    let [a, b] = if (a.z, a.y) <= (b.z, b.y) { [a, b] } else { [b, a] };
    (a.z > r.z) != (b.z > r.z) && r.y < a.y + (b.y - a.y) * (r.z - a.z) / (b.z - a.z)
}

/// Distance to a side \[m\].
fn to_side(r: &Place, [a, b]: [Place; 2]) -> f64 {
    let along = b - a;
    let share = ((r - a).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
    (r - a - along * share).norm()
}
