//! Shapes.

use super::super::region::{Corners, Disc, Point, Region};
use super::super::walls::Shape;
use super::{Checker, MOST_CELLS};

/// Sharpest turn of the line of a wall \[degrees\]: the corner of a sharper one reaches too far.
const SHARPEST: f64 = 135.0;

impl Checker<'_> {
    /// Refuses a region that is made of nothing, or of too many cells.
    pub(super) fn region(&mut self, region: &Region, spacing: f64, key: &str) {
        let before = self.problems.len();
        self.shape(region, key);
        if self.problems.len() > before || spacing <= 0.0 {
            return;
        }
        let Some(Corners { lower, upper }) = region.bounds() else { return };
        let cells: f64 = lower.iter().zip(&upper).map(|(low, high)| (high - low) / spacing + 1.0).product();
        let what = format!("is a lattice of {cells:.1e} cells of {spacing:e} m");
        self.unless(
            cells <= MOST_CELLS,
            key,
            what,
            "check that lengths are in metres, or give a larger spacing",
        );
    }

    /// Refuses shapes without inside.
    pub(super) fn shape(&mut self, region: &Region, key: &str) {
        match region {
            Region::Box(corners) => self.corners(corners, &format!("{key}.box")),
            Region::Circle(Disc { center, radius }) => {
                self.point(center, &format!("{key}.circle.center"));
                self.positive(*radius, &format!("{key}.circle.radius"), "give the radius in metres");
            }
            Region::Polygon(corners) => {
                let key = format!("{key}.polygon");
                let what = format!("has {} corners", corners.len());
                self.unless(corners.len() >= 3, &key, what, "give at least 3");
                for (k, corner) in corners.iter().enumerate() {
                    self.point(corner, &format!("{key}[{k}]"));
                }
            }
            Region::Union(parts) => self.parts(parts, 1, &format!("{key}.union")),
            Region::Difference(parts) => self.parts(parts, 2, &format!("{key}.difference")),
        }
    }

    fn parts(&mut self, parts: &[Region], least: usize, key: &str) {
        let what = format!("has {} parts", parts.len());
        self.unless(parts.len() >= least, key, what, format!("give at least {least}"));
        parts.iter().enumerate().for_each(|(k, part)| self.shape(part, &format!("{key}[{k}]")));
    }

    pub(super) fn corners(&mut self, Corners { lower, upper }: &Corners, key: &str) {
        let points = [(lower, "lower"), (upper, "upper")]
            .map(|(point, name)| self.point(point, &format!("{key}.{name}")));
        if points == [true, true] {
            for (axis, name) in ["x", "y", "z"].iter().enumerate().take(self.dimension) {
                let length = upper[axis] - lower[axis];
                let what = format!("has the thickness {length:.3e} m along {name}");
                self.unless(
                    length > 0.0,
                    key,
                    what,
                    "let every number of `upper` be larger than that of `lower`",
                );
            }
        }
    }

    /// The shape of a wall, whose points are `spacing` \[m\] apart.
    pub(super) fn wall_shape(&mut self, shape: &Shape, spacing: f64, key: &str) {
        match shape {
            Shape::Region(region) => self.region(region, spacing, &format!("{key}.region")),
            Shape::Line(points) => self.line(points, false, spacing, &format!("{key}.line")),
            Shape::Ring(points) => self.line(points, true, spacing, &format!("{key}.ring")),
        }
    }

    fn line(&mut self, points: &[Point], closed: bool, spacing: f64, key: &str) {
        let least = if closed { 3 } else { 2 };
        let what = format!("has {} points", points.len());
        self.unless(points.len() >= least, key, what, format!("give at least {least}"));
        let good: Vec<bool> =
            points.iter().enumerate().map(|(k, point)| self.point(point, &format!("{key}[{k}]"))).collect();
        if points.len() < least || good.contains(&false) {
            return;
        }
        let count = points.len();
        let side = |k: usize| {
            let (a, b) = (&points[k % count], &points[(k + 1) % count]);
            [b[0] - a[0], b[1] - a[1]]
        };
        let sides = if closed { count } else { count - 1 };
        for k in 0..sides {
            let ([x, y], end) = (side(k), format!("{key}[{}]", (k + 1) % count));
            let length = x.hypot(y);
            let what = format!("is {length:.3e} m from the point before");
            self.unless(
                length >= spacing,
                &end,
                &what,
                "leave one of the two out: a side has at least one spacing",
            );
            self.unless(length <= spacing * MOST_CELLS.sqrt() * 10.0, &end, &what, "give a larger spacing");
            if k + 1 < sides || closed {
                let [p, q] = side(k + 1);
                let turn = (x * q - y * p).atan2(x * p + y * q).to_degrees();
                let what = format!("turns the line by {turn:.0} degrees");
                let remedy = "cut the corner with one more point: at most 135 degrees";
                self.unless(turn.abs() <= SHARPEST + 1e-9, &end, what, remedy);
            }
        }
    }
}
