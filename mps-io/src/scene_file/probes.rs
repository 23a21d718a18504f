//! What is measured.

use super::region::Point;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A column of probes.csv, or two
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name of the column
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

/// Height (m) of the fluid that hangs together above the foot, within two spacings along x
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
    /// The point in the undeformed body, at most a spacing outside (m)
    pub at: Point,
}

/// Force (N, in two dimensions N/m), one column per dimension: the mean since the row before, from the impulse handed over
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ForceProbe {
    /// Names of the bodies, elastic or fixed, whose forces are added
    pub on: Vec<String>,
}
