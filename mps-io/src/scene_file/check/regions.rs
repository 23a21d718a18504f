//! Shapes.

use super::super::region::{Corners, Disc, HalfSpace, Region, Tube};
use super::super::solids::Side;
use super::{Checker, MOST_CELLS};

impl Checker<'_> {
    /// Refuses a region that is made of nothing, or of too many cells.
    pub(super) fn region(&mut self, region: &Region, spacing: f64, key: &str) {
        let before = self.problems.len();
        self.shape(region, key);
        if self.problems.len() > before || spacing <= 0.0 {
            return;
        }
        if let Some(around) = region.bounds() {
            self.cells(&around, spacing, key);
        }
    }

    /// Refuses a lattice that would not fit into memory.
    pub(super) fn cells(&mut self, Corners { lower, upper }: &Corners, spacing: f64, key: &str) {
        let cells: f64 = lower.iter().zip(upper).map(|(low, high)| (high - low) / spacing + 1.0).product();
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
            Region::Circle(disc) => {
                self.disc(disc, 2, "give a ball, or a cylinder", &format!("{key}.circle"))
            }
            Region::Ball(disc) => self.disc(disc, 3, "give a circle", &format!("{key}.ball")),
            Region::Cylinder(tube) => self.tube(tube, &format!("{key}.cylinder")),
            Region::HalfSpace(_) => {
                let remedy = "take it away from a shape: { difference = [ shape, { half_space = ... } ] }";
                self.unless(false, &format!("{key}.half_space"), "has no end", remedy);
            }
            Region::Polygon(corners) => {
                let key = format!("{key}.polygon");
                if !self.only_in(2, &key, "put boxes, balls and cylinders together, or cut with half-spaces")
                {
                    return;
                }
                let what = format!("has {} corners", corners.len());
                self.unless(corners.len() >= 3, &key, what, "give at least 3");
                for (k, corner) in corners.iter().enumerate() {
                    self.point(corner, &format!("{key}[{k}]"));
                }
            }
            Region::Outline(outline) => {
                let key = format!("{key}.outline");
                let remedy = "give a factor above zero, 1e-3 for a file in millimetres";
                self.positive(outline.scale, &format!("{key}.scale"), remedy);
                self.vector(&outline.translate, &format!("{key}.translate"));
            }
            Region::Union(parts) => self.parts(parts, 1, &format!("{key}.union")),
            Region::Difference(parts) => self.parts(parts, 2, &format!("{key}.difference")),
        }
    }

    fn parts(&mut self, parts: &[Region], least: usize, key: &str) {
        let what = format!("has {} parts", parts.len());
        self.unless(parts.len() >= least, key, what, format!("give at least {least}"));
        for (k, part) in parts.iter().enumerate() {
            match part {
                // What is taken away may have no end.
                Region::HalfSpace(half) if least == 2 && k > 0 => {
                    self.half_space(half, &format!("{key}[{k}].half_space"));
                }
                _ => self.shape(part, &format!("{key}[{k}]")),
            }
        }
    }

    /// A disc or a ball.
    fn disc(&mut self, Disc { center, radius }: &Disc, dimension: usize, remedy: &str, key: &str) {
        if self.only_in(dimension, key, remedy) {
            self.point(center, &format!("{key}.center"));
            self.positive(*radius, &format!("{key}.radius"), "give the radius in metres");
        }
    }

    fn tube(&mut self, Tube { from, to, radius }: &Tube, key: &str) {
        if !self.only_in(3, key, "give a box, or a circle") {
            return;
        }
        let ends = [(from, "from"), (to, "to")].map(|(end, name)| self.point(end, &format!("{key}.{name}")));
        self.positive(*radius, &format!("{key}.radius"), "give the radius in metres");
        let long = ends != [true, true] || from != to;
        self.unless(long, key, "has no length", "give its ends different places");
    }

    fn half_space(&mut self, HalfSpace { through, toward }: &HalfSpace, key: &str) {
        self.point(through, &format!("{key}.through"));
        let toward_key = format!("{key}.toward");
        if self.point(toward, &toward_key) {
            let somewhere = toward.iter().any(|x| *x != 0.0);
            self.unless(somewhere, &toward_key, "points nowhere", "give a vector across the plane");
        }
    }

    /// Sides that the scene has.
    pub(super) fn sides(&mut self, sides: &[Side], key: &str) {
        let good = sides.iter().all(|side| side.axis() < self.dimension);
        let remedy = "in two dimensions there are \"left\", \"right\", \"bottom\" and \"top\"";
        self.unless(good, key, "is a side along z", remedy);
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
}
