//! What is inside a region.

use super::region::{Corners, Disc, HalfSpace, Point, Region, Tube};

impl Region {
    /// Whether the point \[m\] is inside. What is less than `margin` \[m\] outside the surface of a simple shape
    /// counts as inside of that shape, so that points on a surface have one answer whatever the rounding.
    pub fn contains(&self, point: &[f64], margin: f64) -> bool {
        match self {
            Self::Box(Corners { lower, upper }) => point
                .iter()
                .zip(lower.iter().zip(upper))
                .all(|(x, (low, high))| *x >= low - margin && *x <= high + margin),
            Self::Circle(Disc { center, radius }) | Self::Ball(Disc { center, radius }) => {
                let square: f64 = point.iter().zip(center).map(|(x, c)| (x - c) * (x - c)).sum();
                square.sqrt() <= radius + margin
            }
            Self::Cylinder(tube) => in_tube(tube, point, margin),
            Self::HalfSpace(half) => in_half_space(half, point, margin),
            Self::Polygon(corners) => in_polygon(corners, point, margin),
            Self::Outline(outline) => outline.contains(point, margin),
            Self::Union(parts) => parts.iter().any(|part| part.contains(point, margin)),
            Self::Difference(parts) => parts.split_first().is_some_and(|(whole, taken)| {
                whole.contains(point, margin) && !taken.iter().any(|part| part.contains(point, margin))
            }),
        }
    }

    /// The smallest box around the region \[m\]; of a difference, that of what was there before. `None` if it is made
    /// of nothing, or has no end.
    pub fn bounds(&self) -> Option<Corners> {
        match self {
            Self::Box(corners) => Some(corners.clone()),
            Self::Circle(Disc { center, radius }) | Self::Ball(Disc { center, radius }) => Some(Corners {
                lower: center.iter().map(|c| c - radius).collect(),
                upper: center.iter().map(|c| c + radius).collect(),
            }),
            Self::Cylinder(tube) => Some(around_tube(tube)),
            Self::HalfSpace(_) => None,
            Self::Outline(outline) => outline.bounds(),
            Self::Polygon(corners) => around(corners.iter().cloned().map(|c| (c.clone(), c))),
            Self::Union(parts) => {
                around(parts.iter().filter_map(Self::bounds).map(|Corners { lower, upper }| (lower, upper)))
            }
            Self::Difference(parts) => parts.first()?.bounds(),
        }
    }
}

/// The box around boxes, given by their corners.
pub(super) fn around(boxes: impl Iterator<Item = (Point, Point)>) -> Option<Corners> {
    let each = |a: Point, b: Point, pick: fn(f64, f64) -> f64| -> Point {
        a.into_iter().zip(b).map(|(a, b)| pick(a, b)).collect()
    };
    let both = |a: (Point, Point), b: (Point, Point)| (each(a.0, b.0, f64::min), each(a.1, b.1, f64::max));
    boxes.reduce(both).map(|(lower, upper)| Corners { lower, upper })
}

/// The box around a cylinder: a disc across its axis reaches less far along an axis the steeper it lies to it.
fn around_tube(Tube { from, to, radius }: &Tube) -> Corners {
    let axis: Vec<f64> = from.iter().zip(to).map(|(a, b)| b - a).collect();
    let square: f64 = axis.iter().map(|x| x * x).sum();
    let reach = |x: &f64| radius * (1.0 - x * x / square).max(0.0).sqrt();
    let ends = || from.iter().zip(to).zip(&axis);
    Corners {
        lower: ends().map(|((a, b), x)| a.min(*b) - reach(x)).collect(),
        upper: ends().map(|((a, b), x)| a.max(*b) + reach(x)).collect(),
    }
}

/// Whether a point is between the planes of both ends, and near enough to the axis.
fn in_tube(Tube { from, to, radius }: &Tube, point: &[f64], margin: f64) -> bool {
    let parts = || from.iter().zip(to).zip(point).map(|((a, b), x)| (b - a, x - a));
    let length = parts().map(|(axis, _)| axis * axis).sum::<f64>().sqrt();
    let along = parts().map(|(axis, arm)| axis * arm).sum::<f64>() / length;
    let off: f64 = parts().map(|(axis, arm)| (arm - along * axis / length).powi(2)).sum();
    along >= -margin && along <= length + margin && off.sqrt() <= radius + margin
}

fn in_half_space(HalfSpace { through, toward }: &HalfSpace, point: &[f64], margin: f64) -> bool {
    let length = toward.iter().map(|n| n * n).sum::<f64>().sqrt();
    let beyond: f64 = toward.iter().zip(through.iter().zip(point)).map(|(n, (a, x))| n * (x - a)).sum();
    beyond >= -margin * length
}

/// Whether a ray from the point crosses the line an odd number of times, or the line is near.
pub(super) fn in_polygon(corners: &[Point], point: &[f64], margin: f64) -> bool {
    let &[x, y] = point else { return false };
    let mut inside = false;
    for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let (&[ax, ay], &[bx, by]) = (a.as_slice(), b.as_slice()) else { return false };
        let (dx, dy) = (bx - ax, by - ay);
        let along = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy);
        let along = if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.0 };
        if (x - ax - along * dx).hypot(y - ay - along * dy) <= margin {
            return true;
        }
        if (ay > y) != (by > y) && x < ax + dx * (y - ay) / dy {
            inside = !inside;
        }
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube(lower: [f64; 2], upper: [f64; 2]) -> Region {
        Region::Box(Corners { lower: lower.into(), upper: upper.into() })
    }

    #[test]
    fn a_difference_and_what_was_taken_away_make_the_whole_again() {
        let whole = cube([0.0, 0.0], [1.0, 1.0]);
        let disc = Region::Circle(Disc { center: vec![1.0, 1.0], radius: 0.5 });
        let rest = Region::Difference(vec![whole.clone(), disc.clone()]);
        for k in 0..121 {
            let point = [f64::from(k % 11) * 0.1, f64::from(k / 11) * 0.1];
            let taken = whole.contains(&point, 1e-9) && disc.contains(&point, 1e-9);
            assert_ne!(rest.contains(&point, 1e-9), taken, "{point:?}");
        }
        assert_eq!(rest.bounds(), whole.bounds());
    }

    #[test]
    fn a_slanted_cylinder_fills_its_box_from_side_to_side() {
        let tube = Tube { from: vec![0.1, 0.2, 0.3], to: vec![1.3, 1.1, 0.3], radius: 0.4 };
        let (along, across) = ([0.8, 0.6, 0.0], [-0.6, 0.8, 0.0]);
        let region = Region::Cylinder(tube);
        let Corners { lower, upper } = region.bounds().unwrap();
        // The outermost points of the discs at the ends.
        for (corner, want) in [(lower, [-0.14, -0.12, -0.1]), (upper, [1.54, 1.42, 0.7])] {
            assert!(corner.iter().zip(want).all(|(x, want)| (x - want).abs() < 1e-12), "{corner:?} {want:?}");
        }
        let at = |s: f64, r: f64| [0, 1, 2].map(|k| [0.1, 0.2, 0.3][k] + s * along[k] + r * across[k]);
        for (s, r, inside) in [
            (0.01, 0.39, true),
            (1.49, -0.39, true),
            (0.7, 0.41, false),
            (-0.01, 0.0, false),
            (1.51, 0.0, false),
        ] {
            assert_eq!(region.contains(&at(s, r), 1e-9), inside, "{s} {r}");
        }
    }

    #[test]
    fn a_half_space_cuts_a_ball_in_two() {
        let ball = Region::Ball(Disc { center: vec![0.0; 3], radius: 1.0 });
        let half = Region::HalfSpace(HalfSpace { through: vec![0.1, 0.0, 0.0], toward: vec![2.0, 0.0, 2.0] });
        let rest = Region::Difference(vec![ball.clone(), half]);
        assert_eq!(rest.bounds(), ball.bounds());
        for (point, inside) in
            [([0.0, 0.5, 0.09], true), ([0.0, 0.5, 0.11], false), ([0.9, 0.0, -0.9], false)]
        {
            assert_eq!(rest.contains(&point, 1e-9), inside, "{point:?}");
        }
    }

    #[test]
    fn a_polygon_is_what_its_line_encloses() {
        let step = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
        let polygon = Region::Polygon(step.map(Vec::from).to_vec());
        let boxes = Region::Union(vec![cube([0.0, 0.0], [2.0, 1.0]), cube([0.0, 0.0], [1.0, 2.0])]);
        for k in 0..900 {
            let point = [f64::from(k % 30) * 0.1 - 0.43, f64::from(k / 30) * 0.1 - 0.41];
            assert_eq!(polygon.contains(&point, 1e-9), boxes.contains(&point, 1e-9), "{point:?}");
        }
        assert_eq!(polygon.bounds(), boxes.bounds());
        // On its line the margin decides.
        assert!(polygon.contains(&[1.0, 1.5], 1e-9) && !polygon.contains(&[1.1, 1.5], 1e-9));
    }
}
