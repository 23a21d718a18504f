//! What is inside a region.

use super::region::{Corners, Disc, Point, Region};

impl Region {
    /// Whether the point \[m\] is inside. What is less than `margin` \[m\] outside the surface of a simple shape
    /// counts as inside of that shape, so that points on a surface have one answer whatever the rounding.
    pub fn contains(&self, point: &[f64], margin: f64) -> bool {
        match self {
            Self::Box(Corners { lower, upper }) => point
                .iter()
                .zip(lower.iter().zip(upper))
                .all(|(x, (low, high))| *x >= low - margin && *x <= high + margin),
            Self::Circle(Disc { center, radius }) => {
                let square: f64 = point.iter().zip(center).map(|(x, c)| (x - c) * (x - c)).sum();
                square.sqrt() <= radius + margin
            }
            Self::Polygon(corners) => in_polygon(corners, point, margin),
            Self::Union(parts) => parts.iter().any(|part| part.contains(point, margin)),
            Self::Difference(parts) => parts.split_first().is_some_and(|(whole, taken)| {
                whole.contains(point, margin) && !taken.iter().any(|part| part.contains(point, margin))
            }),
        }
    }

    /// The smallest box around the region \[m\]; of a difference, that of what was there before. `None` if it is made
    /// of nothing.
    pub fn bounds(&self) -> Option<Corners> {
        match self {
            Self::Box(corners) => Some(corners.clone()),
            Self::Circle(Disc { center, radius }) => Some(Corners {
                lower: center.iter().map(|c| c - radius).collect(),
                upper: center.iter().map(|c| c + radius).collect(),
            }),
            Self::Polygon(corners) => around(corners.iter().cloned().map(|c| (c.clone(), c))),
            Self::Union(parts) => {
                around(parts.iter().filter_map(Self::bounds).map(|Corners { lower, upper }| (lower, upper)))
            }
            Self::Difference(parts) => parts.first()?.bounds(),
        }
    }
}

/// The box around boxes, given by their corners.
fn around(boxes: impl Iterator<Item = (Point, Point)>) -> Option<Corners> {
    let each = |a: Point, b: Point, pick: fn(f64, f64) -> f64| -> Point {
        a.into_iter().zip(b).map(|(a, b)| pick(a, b)).collect()
    };
    let both = |a: (Point, Point), b: (Point, Point)| (each(a.0, b.0, f64::min), each(a.1, b.1, f64::max));
    boxes.reduce(both).map(|(lower, upper)| Corners { lower, upper })
}

/// Whether a ray from the point crosses the line an odd number of times, or the line is near.
fn in_polygon(corners: &[Point], point: &[f64], margin: f64) -> bool {
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
