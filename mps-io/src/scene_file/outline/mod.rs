//! Shapes from files of their own: a closed line in two dimensions, a closed surface in three.
//!
//! | file | what it does |
//! |---|---|
//! | `line` | a line from text, and what is wrong with it |
//! | `stl` | triangles from STL, binary or text |
//! | `surface`, `triangle` | a closed surface of triangles, what is wrong with it, and what is inside it |
//! | `load` | reads the files of a scene |
//! | `copy` | writes a scene with its files to another directory |

mod copy;
mod line;
mod load;
mod stl;
mod surface;
mod triangle;

pub(super) use load::load;
pub(super) use triangle::Triangle;

use super::inside::{around, in_polygon};
use super::region::{Corners, Point};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use surface::Surface;

/// What a closed line (in two dimensions) or a closed surface (in three) encloses that is in a file of its own
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Outline {
    /// The file, from the directory of the scene: in two dimensions text with x and y of a corner in every line, in three STL,
    /// binary or text, with triangles that are counter-clockwise seen from outside
    pub file: String,
    /// Factor for its lengths (-), first: 1e-3 for a file in millimetres
    #[serde(default = "one")]
    pub scale: f64,
    /// By which it is moved (m), then
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub translate: Point,
    /// Checksum of the file, which a run writes into its own scene, so that it is not resumed with another file; leave it out
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub checksum: Option<String>,
    #[serde(skip)]
    loaded: Option<Arc<Loaded>>,
}

fn one() -> f64 {
    1.0
}

/// A file that was read, and what it is.
#[derive(Debug, PartialEq)]
struct Loaded {
    bytes: Vec<u8>,
    shape: Shape,
}

#[derive(Debug, PartialEq)]
enum Shape {
    Line(Vec<Point>),
    Surface(Surface),
}

impl Outline {
    /// Of a file, which a scene reads with itself.
    pub fn new(file: impl Into<String>) -> Self {
        Self { file: file.into(), scale: one(), translate: Vec::new(), checksum: None, loaded: None }
    }

    /// As [`Region::contains`](super::Region::contains); without its file it contains nothing.
    pub(super) fn contains(&self, point: &[f64], margin: f64) -> bool {
        self.loaded.as_ref().is_some_and(|loaded| match (&loaded.shape, point) {
            (Shape::Line(corners), _) => in_polygon(corners, point, margin),
            (Shape::Surface(surface), &[x, y, z]) => surface.contains([x, y, z], margin),
            (Shape::Surface(_), _) => false,
        })
    }

    /// The corners of its line in two dimensions; none without its file.
    pub(super) fn corners(&self) -> &[Point] {
        match self.loaded.as_ref().map(|loaded| &loaded.shape) {
            Some(Shape::Line(corners)) => corners,
            _ => &[],
        }
    }

    /// The triangles of its surface in three dimensions; none without its file.
    pub(super) fn triangles(&self) -> &[Triangle] {
        match self.loaded.as_ref().map(|loaded| &loaded.shape) {
            Some(Shape::Surface(surface)) => surface.triangles(),
            _ => &[],
        }
    }

    /// The smallest box around it; none without its file.
    pub(super) fn bounds(&self) -> Option<Corners> {
        match &self.loaded.as_ref()?.shape {
            Shape::Line(corners) => around(corners.iter().cloned().map(|c| (c.clone(), c))),
            Shape::Surface(surface) => Some(surface.bounds()),
        }
    }
}
