//! A closed surface of triangles.

use super::super::region::Corners;
use super::line::Fault;
use super::triangle::Triangle;
use mps_kernel::Vector;
use std::collections::BTreeMap;

/// A surface that is closed and has its outside outside.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Surface {
    triangles: Vec<Triangle>,
    lower: Vector<f64, 3>,
    upper: Vector<f64, 3>,
}

/// The bits of a place, which order places.
type Key = [u64; 3];

fn key(place: &Vector<f64, 3>) -> Key {
    // Zero has two signs and is one place.
    [place.x, place.y, place.z].map(|x| (x + 0.0).to_bits())
}

fn words(place: &Vector<f64, 3>) -> String {
    format!("({:.4}, {:.4}, {:.4})", place.x, place.y, place.z)
}

impl Surface {
    /// Of triangles, without those that have no area.
    ///
    /// # Errors
    /// If it has a hole, triangles that face different ways, or its inside outside.
    pub(super) fn new(mut triangles: Vec<Triangle>) -> Result<Self, Fault> {
        // Two corners in one place: the others close the surface without it.
        triangles.retain(|triangle| triangle.sides().iter().all(|[a, b]| key(a) != key(b)));
        let Some((mut lower, mut upper)) = triangles.first().map(Triangle::bounds) else {
            return Err(("has no triangles".to_owned(), "give a closed surface"));
        };
        for (low, high) in triangles.iter().map(Triangle::bounds) {
            (lower, upper) = (lower.inf(&low), upper.sup(&high));
        }
        if let Some(fault) = open_side(&triangles) {
            return Err(fault);
        }
        let volume: f64 = triangles.iter().map(Triangle::volume).sum();
        if volume <= 0.0 {
            let what = format!(
                "is inside out: it encloses {volume:.3e} m3, between {} and {}",
                words(&lower),
                words(&upper)
            );
            return Err((
                what,
                "let the triangles be counter-clockwise seen from outside (programs call it flipping normals)",
            ));
        }
        Ok(Self { triangles, lower, upper })
    }

    /// Whether a point is inside, or at most `margin` \[m\] outside.
    pub(super) fn contains(&self, point: [f64; 3], margin: f64) -> bool {
        let r = Vector::from(point);
        let near = |axis: usize| r[axis] >= self.lower[axis] - margin && r[axis] <= self.upper[axis] + margin;
        if !(0..3).all(near) {
            return false;
        }
        // How often a ray leaves the surface more often than it enters it: the number of times the surface is wound around the point.
        let wound: i32 = self.triangles.iter().map(|triangle| triangle.crossed_by_a_ray(&r)).sum();
        wound > 0 || self.triangles.iter().any(|triangle| triangle.is_near(&r, margin))
    }

    pub(super) fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    pub(super) fn bounds(&self) -> Corners {
        Corners::between(self.lower.into(), self.upper.into())
    }
}

/// A side along which the surface is not closed: as many triangles have to run along it one way as the other.
fn open_side(triangles: &[Triangle]) -> Option<Fault> {
    let mut sides: BTreeMap<(Key, Key), ([i32; 2], usize)> = BTreeMap::new();
    for (number, triangle) in triangles.iter().enumerate() {
        for [a, b] in triangle.sides() {
            let (a, b) = (key(&a), key(&b));
            let (count, _) = sides.entry((a.min(b), a.max(b))).or_insert(([0; 2], number));
            count[usize::from(a > b)] += 1;
        }
    }
    let of = |number: usize, wanted: (Key, Key)| {
        let is = |[a, b]: &[Vector<f64, 3>; 2]| (key(a).min(key(b)), key(a).max(key(b))) == wanted;
        let side = triangles[number].sides().into_iter().find(is);
        side.map_or(String::new(), |[a, b]| format!("from {} to {}", words(&a), words(&b)))
    };
    // The first one in the order of the file.
    let mut open: Vec<_> = sides.into_iter().filter(|(_, ([one, other], _))| one != other).collect();
    open.sort_by_key(|(_, (_, number))| *number);
    let count = open.len();
    let (side, ([one, other], number)) = open.into_iter().next()?;
    let place = of(number, side);
    Some(if (one + other) % 2 == 0 {
        let what = format!(
            "has triangles that face different ways: on both sides of the edge {place} (one of {count} such edges)"
        );
        (what, "let all of them be counter-clockwise seen from outside")
    } else {
        let what =
            format!("is not closed: there is a hole along the edge {place} (one of {count} such edges)");
        (
            what,
            "close it, and let neighbours have exactly the same corners (programs call it merging vertices)",
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An octahedron around a centre, with corners at a distance of 1.
    fn octahedron(center: [f64; 3]) -> Vec<Triangle> {
        let mut triangles = Vec::new();
        for k in 0..8 {
            let sign = |bit: usize| if k >> bit & 1 == 0 { 1.0 } else { -1.0 };
            let corner = |axis: usize| {
                let mut place = center;
                place[axis] += sign(axis);
                place
            };
            let [x, y, z] = [0, 1, 2].map(corner);
            let even = sign(0) * sign(1) * sign(2) > 0.0;
            triangles.push(if even { [x, y, z].into() } else { [x, z, y].into() });
        }
        triangles
    }

    #[test]
    fn an_octahedron_is_what_its_formula_says_at_every_point_of_a_lattice() {
        let center = [0.1, -0.2, 0.3];
        let surface = Surface::new(octahedron(center)).unwrap();
        let mut inside = 0;
        // The lattice has points in the planes of corners and edges, where rays meet both.
        for k in 0..21_u32.pow(3) {
            let off = [k % 21, k / 21 % 21, k / 441].map(|k| 0.1 * (f64::from(k) - 10.0));
            let reach: f64 = off.iter().map(|x| x.abs()).sum();
            if (reach - 1.0).abs() < 1e-6 {
                continue;
            }
            let point = [0, 1, 2].map(|axis| center[axis] + off[axis]);
            assert_eq!(surface.contains(point, 1e-9), reach < 1.0, "{point:?}");
            inside += u32::from(reach < 1.0);
        }
        assert!(inside > 1000);
        // The surface belongs to it, and what the margin allows.
        assert!(surface.contains([0.1 + 0.4, -0.2 + 0.3, 0.3 + 0.3], 1e-9));
        assert!(
            surface.contains([1.1 + 1e-3, -0.2, 0.3], 2e-3)
                && !surface.contains([1.1 + 1e-3, -0.2, 0.3], 5e-4)
        );
        assert_eq!(surface.bounds(), Corners::between([-0.9, -1.2, -0.7], [1.1, 0.8, 1.3]));
    }

    /// A prism cut from a cube along `y + z = s`, its slanted face of triangles whose corners at one end are not those at the other:
    /// rays along x run within them.
    fn wedge(s: f64) -> Vec<Triangle> {
        let place = |x: f64, t: f64| [x, s * (1.0 - t), s * t];
        let (near, far) = ([0.0, 0.37, 1.0], [0.0, 0.17, 0.71, 1.0]);
        let mut triangles: Vec<Triangle> = Vec::new();
        let mut face = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| triangles.push([a, b, c].into());
        let square = |x: f64| [[x, 0.0, 0.0], [x, s, 0.0], [x, s, s], [x, 0.0, s]];
        // At x = 0 the whole square, at s/2 its upper half, at s the lower one.
        let [a, b, c, d] = square(0.0);
        face(a, c, b);
        face(a, d, c);
        for k in 0..2 {
            face([0.5 * s, s, s], place(0.5 * s, near[k + 1]), place(0.5 * s, near[k]));
        }
        for k in 0..3 {
            face([s, 0.0, 0.0], place(s, far[k]), place(s, far[k + 1]));
        }
        // The slanted face between the two cuts.
        let (mut i, mut j) = (0, 0);
        while i < 2 || j < 3 {
            let (p, q) = (place(0.5 * s, near[i]), place(s, far[j]));
            if i < 2 && (j == 3 || near[i + 1] <= far[j + 1]) {
                face(p, place(0.5 * s, near[i + 1]), q);
                i += 1;
            } else {
                face(p, place(s, far[j + 1]), q);
                j += 1;
            }
        }
        // Bottoms and sides, whole up to s, or up to s/2 where the upper half ends.
        let [p, q] = [[0.0, 0.0, 0.0], [s, 0.0, 0.0]];
        face(p, [0.0, s, 0.0], [0.5 * s, s, 0.0]);
        face(p, [0.5 * s, s, 0.0], [s, s, 0.0]);
        face(p, [s, s, 0.0], q);
        face(p, q, [s, 0.0, s]);
        face(p, [s, 0.0, s], [0.5 * s, 0.0, s]);
        face(p, [0.5 * s, 0.0, s], [0.0, 0.0, s]);
        face([0.0, s, 0.0], [0.0, s, s], [0.5 * s, s, s]);
        face([0.0, s, 0.0], [0.5 * s, s, s], [0.5 * s, s, 0.0]);
        face([0.0, 0.0, s], [0.5 * s, 0.0, s], [0.5 * s, s, s]);
        face([0.0, 0.0, s], [0.5 * s, s, s], [0.0, s, s]);
        triangles
    }

    #[test]
    fn points_in_the_plane_of_a_face_that_is_seen_edge_on_are_inside() {
        for s in [0.3, 0.7, 1.0] {
            let surface = Surface::new(wedge(s)).unwrap();
            for k in 0..40 {
                let share = (f64::from(k) + 0.5) / 40.0;
                for (x, within) in [(0.1, true), (0.4, true), (-0.1, false), (1.1, false)] {
                    let point = [x * s, s * (1.0 - share), s * share];
                    assert_eq!(surface.contains(point, 1e-9), within, "{point:?}");
                }
            }
        }
    }

    #[test]
    fn holes_and_triangles_that_are_turned_are_told_with_their_place() {
        let fault = |change: &dyn Fn(&mut Vec<Triangle>)| {
            let mut triangles = octahedron([0.0; 3]);
            change(&mut triangles);
            Surface::new(triangles).unwrap_err().0
        };
        let hole = fault(&|triangles| {
            triangles.remove(3);
        });
        assert!(
            hole.starts_with("is not closed: there is a hole along the edge from (")
                && hole.ends_with("(one of 3 such edges)"),
            "{hole}"
        );
        let turned = fault(&|triangles| triangles[5].corners.swap(0, 1));
        assert!(
            turned.starts_with("has triangles that face different ways: on both sides of the edge from ("),
            "{turned}"
        );
        let out = fault(&|triangles| triangles.iter_mut().for_each(|t| t.corners.swap(0, 1)));
        assert!(out.starts_with("is inside out: it encloses -1.333e0 m3"), "{out}");
        assert_eq!(fault(&Vec::clear), "has no triangles");
        // A triangle without area closes nothing and opens nothing.
        let mut triangles = octahedron([0.0; 3]);
        triangles.push([[1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].into());
        assert!(Surface::new(triangles).is_ok());
    }
}
