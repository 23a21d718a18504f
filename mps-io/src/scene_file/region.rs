//! Shapes and what can be made of them.

use super::outline::Outline;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A place or a vector: one number per dimension
pub type Point = Vec<f64>;

/// A part of space: a simple shape, or several put together
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Region {
    /// A box along the axes
    Box(Corners),
    /// A disc, in two dimensions
    Circle(Disc),
    /// A ball, in three dimensions
    Ball(Disc),
    /// A cylinder with flat ends, in three dimensions
    Cylinder(Tube),
    /// Everything on one side of a plane (in two dimensions of a line): only to be taken away in a difference, because it
    /// has no end
    HalfSpace(HalfSpace),
    /// What a closed line through these corners (m) encloses, in two dimensions; where it crosses itself, every
    /// other part
    Polygon(Vec<Point>),
    /// What a closed line or surface from a file encloses
    Outline(Outline),
    /// Everything that is in one of them at least
    Union(Vec<Region>),
    /// The first without all the others
    Difference(Vec<Region>),
}

/// How particles fill a region
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Filling {
    /// In a square or cubic lattice, elastic boxes in rows that are fitted to their sides
    #[default]
    Lattice,
    /// Following the surface, the outermost particles half a spacing inside it
    Fitted,
}

impl Filling {
    /// Whether it is the usual one, which need not be written.
    pub(super) fn is_lattice(&self) -> bool {
        *self == Self::Lattice
    }
}

/// A box, by two opposite corners
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Corners {
    /// Corner with the smallest coordinates (m)
    pub lower: Point,
    /// Corner with the largest coordinates (m)
    pub upper: Point,
}

/// A disc, in three dimensions a ball
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Disc {
    /// Centre (m)
    pub center: Point,
    /// Radius (m)
    pub radius: f64,
}

/// A cylinder with flat ends
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Tube {
    /// Middle of one end (m)
    pub from: Point,
    /// Middle of the other (m)
    pub to: Point,
    /// Radius (m)
    pub radius: f64,
}

/// One side of a plane, in two dimensions of a line
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HalfSpace {
    /// A point of the plane (m)
    pub through: Point,
    /// Across the plane, to the side that is meant, of any length
    pub toward: Point,
}

impl Corners {
    /// The box between two corners \[m\].
    pub fn between<const D: usize>(lower: [f64; D], upper: [f64; D]) -> Self {
        Self { lower: lower.into(), upper: upper.into() }
    }
}

impl Region {
    /// The box between two corners \[m\].
    pub fn between<const D: usize>(lower: [f64; D], upper: [f64; D]) -> Self {
        Self::Box(Corners::between(lower, upper))
    }
}

impl Disc {
    /// Where its line is at the height `y` \[m\], on the right of its centre; `None` above and below it.
    pub fn right_of(&self, y: f64) -> Option<f64> {
        let &[x, middle] = self.center.as_slice() else { return None };
        let square = self.radius * self.radius - (y - middle) * (y - middle);
        (square >= 0.0).then(|| x + square.sqrt())
    }
}
