//! Where fluid enters and leaves.

use super::region::Corners;
use super::solids::Side;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where fluid enters, with a given speed. Walls have to go on beside the stack of points behind its plane, which is as deep as
/// the effective radius and a spacing
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Inlet {
    /// The opening, a box without thickness along x or y; a whole number of spacings wide
    pub opening: Corners,
    /// Where the fluid goes
    pub toward: Side,
    /// Mean speed over the opening (m/s)
    pub mean_speed: f64,
    /// Speed over the opening
    #[serde(default)]
    pub profile: Profile,
    /// Time in which the speed rises from zero, as half a cosine (s); 0 for full speed from the start on
    #[serde(default)]
    pub ramp: f64,
}

/// Speed over an opening
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Profile {
    /// The same everywhere
    #[default]
    Uniform,
    /// Zero at both ends, in the middle half as much again as the mean: laminar flow between two walls
    Parabola,
}

impl Profile {
    /// Speed over its mean at this share of the width, from 0 to 1.
    pub fn at(self, share: f64) -> f64 {
        match self {
            Self::Uniform => 1.0,
            Self::Parabola => 6.0 * share * (1.0 - share),
        }
    }

    /// Largest speed over its mean.
    pub fn largest(self) -> f64 {
        match self {
            Self::Uniform => 1.0,
            Self::Parabola => 1.5,
        }
    }
}

/// Where fluid leaves. The zone behind its plane, twice the effective radius and a spacing deep, is filled with fluid of the mean
/// speed of that before it; walls have to go on an effective radius further, and other fluid has to be two spacings from it
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Outlet {
    /// The opening, a box without thickness along x or y; a whole number of spacings wide
    pub opening: Corners,
    /// Where the fluid goes
    pub toward: Side,
    /// Pressure behind its plane, at the middle of the opening (Pa), hydrostatic from there; the background pressure if left out
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressure: Option<f64>,
    /// Whether sound goes out through it; the flow is then that of the inlets, shared by area. If not, the pressure is constant, and sound is reflected as from an open end
    #[serde(default = "yes")]
    pub absorbing: bool,
}

fn yes() -> bool {
    true
}
