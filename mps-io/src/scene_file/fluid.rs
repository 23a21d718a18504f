//! The water and the numbers it is computed with.

use super::openings::{Inlet, Outlet};
use super::region::{Filling, Point, Region};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The fluid: one density and one viscosity for all its bodies
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fluid {
    /// Distance of the particles at the start (m)
    pub spacing: f64,
    /// Density (kg/m3)
    #[serde(default = "water")]
    pub density: f64,
    /// Largest speed the flow is expected to reach (m/s); the numerical sound speed is ten times as much. Give this
    /// or `sound_speed`
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected_speed: Option<f64>,
    /// Numerical sound speed (m/s)
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sound_speed: Option<f64>,
    /// Viscosity
    #[serde(default)]
    pub viscosity: Viscosity,
    /// Kinematic viscosity in the law of walls with the slip `law` (m2/s); it has no other effect
    #[serde(default = "of_water", skip_serializing_if = "is_of_water")]
    pub wall_viscosity: f64,
    /// Where the fluid is at the start
    pub bodies: Vec<Body>,
    /// Where fluid enters
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub inlets: Vec<Inlet>,
    /// Where fluid leaves
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub outlets: Vec<Outlet>,
    /// How it is computed
    #[serde(default)]
    pub numerics: Numerics,
}

impl Fluid {
    /// Water of particles this far apart \[m\], with the default numerics, and without a speed yet.
    pub fn new(spacing: f64, bodies: Vec<Body>) -> Self {
        Self {
            spacing,
            density: water(),
            expected_speed: None,
            sound_speed: None,
            viscosity: Viscosity::default(),
            wall_viscosity: of_water(),
            bodies,
            inlets: Vec::new(),
            outlets: Vec::new(),
            numerics: Numerics::default(),
        }
    }

    /// Numerical sound speed \[m/s\]; zero if the scene says nothing of it, which the check refuses.
    pub fn sound(&self) -> f64 {
        self.sound_speed.or(self.expected_speed.map(|speed| 10.0 * speed)).unwrap_or(0.0)
    }
}

fn water() -> f64 {
    1000.0
}

/// Kinematic viscosity of water \[m^2/s\].
fn of_water() -> f64 {
    1e-6
}

fn is_of_water(viscosity: &f64) -> bool {
    *viscosity == of_water()
}

/// A connected piece of fluid at the start
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Where it is
    pub region: Region,
    /// How its particles lie, in a lattice if left out; fitted beside fitted bodies
    #[serde(default, skip_serializing_if = "Filling::is_lattice")]
    pub packing: Filling,
    /// Pressure at the start
    #[serde(default)]
    pub pressure: InitialPressure,
    /// Velocity at the start (m/s); at rest if left out
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub velocity: Point,
}

impl Body {
    /// Fluid at rest in a lattice.
    pub fn new(region: Region, pressure: InitialPressure) -> Self {
        Self { region, packing: Filling::default(), pressure, velocity: Vec::new() }
    }
}

/// Pressure at the start
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InitialPressure {
    /// That of rest below the highest point of the region
    #[default]
    Hydrostatic,
    /// None but the background pressure: falling fluid
    None,
    /// That of a column of water, a box, at the moment its right side is let go: zero there and at the top
    ReleasedColumn,
}

/// Viscosity of the fluid
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Viscosity {
    /// None at all
    None,
    /// Artificial viscosity of this strength (-), which vanishes with the spacing: 0.01 to 0.1
    Artificial(f64),
    /// Laminar, with this kinematic viscosity (m2/s); water has 1e-6
    Laminar(f64),
    /// The same between near neighbours: for boundary layers of one or two spacings, with the smooth weight
    Compact(f64),
}

impl Default for Viscosity {
    fn default() -> Self {
        Self::Artificial(0.02)
    }
}

/// How the fluid is computed; every key may be left out
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Numerics {
    /// Weight of the sums over neighbours
    pub weight: Weight,
    /// Effective radius over the spacing (-): usually 4 with the smooth weight and 3 with the rational one
    pub radius: f64,
    /// Diffusion of the density
    pub diffusion: Diffusion,
    /// Whether close particles collide (DPC)
    pub collisions: bool,
    /// Parts of the particle shifting (icPS) in a step, 0 for none
    pub shifting: u32,
    /// Courant number (-)
    pub cfl: f64,
    /// What becomes of pressures below zero
    pub tension: Tension,
    /// Pressure at reference density (Pa): 0 with a free surface, for fluid that fills its domain a level above the
    /// largest suction
    pub background_pressure: f64,
    /// Form of pressure gradient and divergence
    pub pressure_form: PressureForm,
    /// Share of the difference between density and packing that goes in the time sound takes for a spacing (-): 0.01
    /// for fluid that fills its domain and is shifted, 0 with a free surface
    pub density_relaxation: f64,
}

impl Default for Numerics {
    fn default() -> Self {
        Self {
            weight: Weight::Smooth,
            radius: 4.0,
            diffusion: Diffusion::Filter(0.5),
            collisions: true,
            shifting: 0,
            cfl: 0.5,
            tension: Tension::Clip,
            background_pressure: 0.0,
            pressure_form: PressureForm::Plain,
            density_relaxation: 0.0,
        }
    }
}

/// Weight of the sums over neighbours
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Weight {
    /// Gradient of Wendland's function
    Smooth,
    /// That of the paper, re/r - 1
    Rational,
    /// Wendland's function itself
    Wendland,
}

/// Diffusion of the density
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Diffusion {
    /// None: cheapest, and noisy
    None,
    /// The filter of fourth order with this strength (-), usually 0.5
    Filter(f64),
    /// Without a strength, with the hydrostatic part removed
    Hydrostatic,
}

/// What becomes of pressures below zero
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Tension {
    /// They become zero: flows with a free surface
    Clip,
    /// They are kept: fluid that fills its domain
    Keep,
}

/// Form of pressure gradient and divergence
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PressureForm {
    /// Plain sums
    Plain,
    /// Corrected by the moment matrix of each particle: for smooth flows
    Corrected,
}
