//! What is measured.

use super::region::Point;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A column of the table of probes, or several
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name of the column; where there are several, the beginning of their names
    pub name: String,
    /// What is measured
    pub measure: Measure,
}

/// What a probe measures
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Measure {
    /// Pressure of the fluid at a place, in it or on a wall
    Pressure(PressureProbe),
    /// How far the fluid has come along a bed
    Front(FrontProbe),
    /// Level of the fluid above a place
    Level(LevelProbe),
    /// Displacement of a point of a body
    Displacement(DisplacementProbe),
    /// Force of the fluid on bodies: drag and lift
    Force(ForceProbe),
    /// Velocity of the fluid at a place
    Velocity(VelocityProbe),
    /// Pressure or velocity of the fluid at places along a line
    Line(LineProbe),
    /// Pressure on a part of the surface of a fixed body
    WallPressure(WallPressureProbe),
    /// What has crossed the interface of bodies since the start: impulse, angular impulse, work
    Budget(BudgetProbe),
}

/// Mean of the particles within two spacings, the near ones more; zero where there are none
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PressureProbe {
    /// Place (m)
    pub at: Point,
}

/// Distance (m) from the start to the end of the fluid that hangs together: spray does not count
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FrontProbe {
    /// Where the front is at the start, on the bed (m)
    pub start: Point,
    /// Fluid up to this height above the start counts (m)
    pub height: f64,
    /// Where it goes
    #[serde(default)]
    pub toward: Way,
}

/// A way along x
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Way {
    /// Towards larger x
    #[default]
    Right,
    /// Towards smaller x
    Left,
}

/// Height (m) of the fluid that hangs together above the foot, within two spacings along x and z
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LevelProbe {
    /// Point of the bed (m)
    pub foot: Point,
}

/// Displacement (m) of a point, one column per dimension
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DisplacementProbe {
    /// Name of the body
    pub solid: String,
    /// The point in the undeformed body, or on its surface (m)
    pub at: Point,
}

/// Force (N, in two dimensions N/m), one column per dimension: the mean since the row before, from the impulse handed over
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ForceProbe {
    /// Names of the bodies, elastic or fixed, whose forces are added
    pub on: Vec<String>,
}

/// Mean of the particles within two spacings (m/s), one column per dimension; zero where there are none
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VelocityProbe {
    /// Place (m)
    pub at: Point,
}

/// As the probe of one place, at places with equal distances, the ends included; the columns are numbered from 1
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LineProbe {
    /// First place (m)
    pub from: Point,
    /// Last place (m)
    pub to: Point,
    /// Number of places, 2 to 100
    pub points: usize,
    /// What is measured there
    #[serde(default)]
    pub of: LineQuantity,
}

/// What is measured along a line
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LineQuantity {
    /// Pressure (Pa)
    #[default]
    Pressure,
    /// Velocity (m/s)
    Velocity,
}

/// In two dimensions: load (Pa) on the surface between two points: the force of the last step on the points of the body behind it, up to an effective radius deep, over its length.
/// That is what the surface bears, momentum for momentum, and not the pressure of the particles before it
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WallPressureProbe {
    /// Name of the fixed body
    pub on: String,
    /// Where it begins (m); the fluid is on the left as one walks on, as along a wall
    pub from: Point,
    /// Where it ends (m), a whole number of spacings of the body away
    pub to: Point,
}

/// Impulse per dimension (N s), angular impulse about the origin (N m s), in three dimensions about each axis, and work (J)
/// handed to bodies since the start; in two dimensions all per metre of depth
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BudgetProbe {
    /// Names of the bodies, elastic or fixed, whose sums are added
    pub on: Vec<String>,
}
