//! Elastic bodies.

use super::region::{Disc, Filling, Point, Region};
use super::walls::Slip;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An elastic body
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Solid {
    /// Name in probes, fields and messages
    pub name: String,
    /// Where it is, undeformed
    pub region: Region,
    /// Distance of its particles (m); along the sides of a box fitted to whole numbers
    pub spacing: f64,
    /// How its particles lie, in a lattice if left out
    #[serde(default, skip_serializing_if = "Filling::is_lattice")]
    pub packing: Filling,
    /// Density (kg/m3)
    pub density: f64,
    /// What it is made of
    pub material: Material,
    /// Where it is held; free if left out
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clamp: Option<Clamp>,
    /// How the fluid moves along it
    #[serde(default)]
    pub slip: Slip,
    /// Pressure from all sides under which it has the shape that is described (Pa); the background pressure of the fluid
    /// if left out
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ambient_pressure: Option<f64>,
    /// Velocity at the start; at rest if left out
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub velocity: Option<InitialVelocity>,
    /// Damping of every velocity (1/s), as in `du/dt = ... - damping u`: for answers at rest; under the load of a fluid it changes them by about `damping dt/4` of themselves, `dt` the sub-step
    #[serde(default, skip_serializing_if = "is_zero")]
    pub damping: f64,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde hands references")]
fn is_zero(number: &f64) -> bool {
    *number == 0.0
}

impl Solid {
    /// An elastic body at rest, free, without friction and damping; `spacing` \[m\], `density` \[kg/m^3\].
    pub fn new(name: &str, region: Region, spacing: f64, density: f64, material: Material) -> Self {
        Self {
            name: name.into(),
            region,
            spacing,
            packing: Filling::default(),
            density,
            material,
            clamp: None,
            slip: Slip::default(),
            ambient_pressure: None,
            velocity: None,
            damping: 0.0,
        }
    }
}

/// Law of an elastic material, in two dimensions in plane strain
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Material {
    /// Hooke's law in the frame that turns with the material: large rotations, small strains
    Corotational(Elasticity),
    /// That of Saint Venant and Kirchhoff: the same, and usual in benchmarks
    SaintVenant(Elasticity),
    /// The compressible neo-Hookean law: large strains
    NeoHookean(Elasticity),
    /// Rubber that hardly changes its volume
    NearlyIncompressible(Elasticity),
}

impl Material {
    /// Its constants.
    pub fn elasticity(&self) -> Elasticity {
        match *self {
            Self::Corotational(e) | Self::SaintVenant(e) | Self::NeoHookean(e) => e,
            Self::NearlyIncompressible(e) => e,
        }
    }

    /// Its key in a scene file.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Corotational(_) => "corotational",
            Self::SaintVenant(_) => "saint_venant",
            Self::NeoHookean(_) => "neo_hookean",
            Self::NearlyIncompressible(_) => "nearly_incompressible",
        }
    }
}

/// The constants of an isotropic elastic material
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Elasticity {
    /// Young's modulus (Pa)
    pub youngs_modulus: f64,
    /// Poisson's ratio (-), between -1 and 0.5
    pub poissons_ratio: f64,
}

/// Where a body is held
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Clamp {
    /// On these sides of a box, whose first row of particles then lies exactly on the side
    Sides(Vec<Side>),
    /// All particles in this region
    Region(Region),
    /// On this disc at the left end of a box: each row of particles is stretched until it begins on it, and is held there
    Disc(Disc),
}

/// A side of a box
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// Lower end of x
    Left,
    /// Upper end of x
    Right,
    /// Lower end of y
    Bottom,
    /// Upper end of y
    Top,
    /// Lower end of z
    Back,
    /// Upper end of z
    Front,
}

impl Side {
    /// The axis it lies across: 0 for x, 1 for y, 2 for z.
    pub fn axis(self) -> usize {
        match self {
            Self::Left | Self::Right => 0,
            Self::Bottom | Self::Top => 1,
            Self::Back | Self::Front => 2,
        }
    }

    /// Whether it is the upper end of its axis.
    pub fn is_upper(self) -> bool {
        matches!(self, Self::Right | Self::Top | Self::Front)
    }
}

/// Velocity of a body at the start
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InitialVelocity {
    /// The same everywhere (m/s)
    Uniform(Point),
    /// That of the first bending mode of a box held on its left side, with this speed of the free end along y (m/s)
    FirstMode(f64),
}
