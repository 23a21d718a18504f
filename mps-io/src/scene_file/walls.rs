//! Walls, at rest or moved.

use super::region::{Corners, Point, Region};
use super::solids::Side;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A wall for the fluid
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Wall {
    /// Name in messages
    pub name: String,
    /// Where it is
    pub shape: Shape,
    /// How the fluid moves along it
    #[serde(default)]
    pub slip: Slip,
    /// Spacing of its points over that of the fluid (-): 0.5 is smooth to fluid that slides by
    #[serde(default = "one")]
    pub fineness: f64,
    /// How it moves; at rest if left out
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion: Option<Motion>,
}

fn one() -> f64 {
    1.0
}

impl Wall {
    /// A wall at rest that fills a region, with the spacing of the fluid.
    pub fn filling(name: &str, region: Region, slip: Slip) -> Self {
        Self { name: name.into(), shape: Shape::Region(region), slip, fineness: one(), motion: None }
    }
}

/// Shape of a wall
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Shape {
    /// In two dimensions: along the line through these points (m), as thick as the effective radius, built to the right
    /// as one walks along it: the fluid is on the left
    Line(Vec<Point>),
    /// The same, back to its first point: counter-clockwise around the fluid
    Ring(Vec<Point>),
    /// What the region encloses: plates and blocks with fluid on several sides
    Region(Region),
    /// Around a box, as thick as the effective radius
    Tank(Tank),
}

/// The sides of a box, built outwards
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Tank {
    /// Corner with the smallest coordinates of its inside (m)
    pub lower: Point,
    /// Corner with the largest coordinates of its inside (m)
    pub upper: Point,
    /// Sides without a wall; the others end where these begin
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub open: Vec<Side>,
}

impl Tank {
    /// The box it has inside.
    pub fn inside(&self) -> Corners {
        Corners { lower: self.lower.clone(), upper: self.upper.clone() }
    }

    /// The box it fills with its walls, which are `depth` \[m\] thick.
    pub fn outside(&self, depth: f64) -> Corners {
        let Corners { mut lower, mut upper } = self.inside();
        for side in [Side::Left, Side::Right, Side::Bottom, Side::Top, Side::Back, Side::Front] {
            let end = if side.is_upper() { &mut upper } else { &mut lower };
            if let (Some(end), false) = (end.get_mut(side.axis()), self.open.contains(&side)) {
                *end += if side.is_upper() { depth } else { -depth };
            }
        }
        Corners { lower, upper }
    }
}

/// How the fluid moves along a surface
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Slip {
    /// Without shear
    #[default]
    Free,
    /// With the surface
    None,
    /// Held back by a turbulent boundary layer too steep for particles, whatever the viscosity of the fluid (Werner and Wengle 1991):
    /// water that runs over a bed for long
    Law,
}

/// A motion that is given
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Motion {
    /// With a constant velocity
    Steady(Steady),
    /// To and fro as a sine
    Oscillation(Oscillation),
}

/// Motion with a constant velocity
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Steady {
    /// Velocity (m/s)
    pub velocity: Point,
    /// When it stops (s); never if left out
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub until: Option<f64>,
}

/// The displacement `amplitude (1 - cos(2 pi t/period))/2`: starts and turns at rest
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Oscillation {
    /// From one turning point to the other (m)
    pub amplitude: Point,
    /// Period (s)
    pub period: f64,
}
