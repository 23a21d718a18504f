//! Shapes of walls.

use super::super::region::Point;
use super::super::walls::{Shape, Tank};
use super::{Checker, MOST_CELLS};

/// Sharpest turn of the line of a wall \[degrees\]: the corner of a sharper one reaches too far.
const SHARPEST: f64 = 135.0;

impl Checker<'_> {
    /// The shape of a wall, whose points are `spacing` \[m\] apart.
    pub(super) fn wall_shape(&mut self, shape: &Shape, spacing: f64, key: &str) {
        match shape {
            Shape::Region(region) => self.region(region, spacing, &format!("{key}.region")),
            Shape::Line(points) => self.line(points, false, spacing, &format!("{key}.line")),
            Shape::Ring(points) => self.line(points, true, spacing, &format!("{key}.ring")),
            Shape::Tank(tank) => self.tank(tank, spacing, &format!("{key}.tank")),
        }
    }

    fn tank(&mut self, tank: &Tank, spacing: f64, key: &str) {
        let before = self.problems.len();
        self.corners(&tank.inside(), key);
        if self.problems.len() == before {
            // Its walls are cells too: as deep as the fluid can see, ten of their spacings and less.
            self.cells(&tank.outside(10.0 * spacing), spacing, key);
        }
        self.sides(&tank.open, &format!("{key}.open"));
        let closed = tank.open.len() < 2 * self.dimension;
        self.unless(closed, &format!("{key}.open"), "is all sides", "leave at least one closed");
    }

    fn line(&mut self, points: &[Point], closed: bool, spacing: f64, key: &str) {
        if !self.only_in(2, key, "give a tank, or a region") {
            return;
        }
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
