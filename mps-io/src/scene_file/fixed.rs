//! Rigid bodies at rest that feel the fluid.

use super::region::{Disc, Region};
use super::walls::Slip;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A rigid body that does not move: a wall whose load is known
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fixed {
    /// Name in probes, fields and messages
    pub name: String,
    /// Where it is
    pub region: Region,
    /// Distance of its points (m); that of the fluid if left out
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spacing: Option<f64>,
    /// How its points lie
    #[serde(default)]
    pub packing: Packing,
    /// How the fluid moves along it
    #[serde(default)]
    pub slip: Slip,
}

/// How points fill the region of a fixed body
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Packing {
    /// In a square lattice
    #[default]
    Lattice,
    /// Following the surface of any region, whose outermost points lie half a spacing inside it
    Fitted,
    /// In rings, as far in as the fluid reaches: for a circle, whose surface is then round
    Rings,
    /// In rows along a box that begin on this disc at its left end, as those of an elastic body that is held on it
    Rows(Disc),
}
