//! Which fields are written, and in which forms fields and tables are.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A field of particles; in the files its name has spaces
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Field {
    /// Velocity (m/s) of fluid and bodies
    Velocity,
    /// Pressure (Pa) of the fluid
    Pressure,
    /// Density of the fluid over its reference (-)
    DensityRatio,
    /// How densely the particles of the fluid lie (-): 1 inside, less at a free surface
    Packing,
    /// Where particles of the fluid are: 0 inside, 1 at the free surface, 2 detached
    Surface,
    /// Number of each particle of the fluid, the same as long as it is there
    Id,
    /// Displacement (m) of the particles of bodies
    Displacement,
    /// Largest principal value of the Green-Lagrange strain (-) of bodies
    PrincipalStrain,
    /// Force of the fluid on the particles of bodies (N, in two dimensions N/m)
    ForceOfTheFluid,
}

impl Field {
    /// Those of fluids, in the order in which they are written.
    pub const OF_FLUIDS: [Self; 6] =
        [Self::Velocity, Self::Pressure, Self::DensityRatio, Self::Packing, Self::Surface, Self::Id];
    /// Those of bodies, in the order in which they are written.
    pub const OF_BODIES: [Self; 4] =
        [Self::Displacement, Self::Velocity, Self::PrincipalStrain, Self::ForceOfTheFluid];

    /// Its name in the files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Velocity => "velocity",
            Self::Pressure => "pressure",
            Self::DensityRatio => "density ratio",
            Self::Packing => "packing",
            Self::Surface => "surface",
            Self::Id => "id",
            Self::Displacement => "displacement",
            Self::PrincipalStrain => "principal strain",
            Self::ForceOfTheFluid => "force of the fluid",
        }
    }

    /// Bytes of a particle in a file whose reals have `real` bytes, uncompressed.
    pub fn bytes(self, real: usize) -> usize {
        match self {
            Self::Velocity | Self::Displacement | Self::ForceOfTheFluid => 3 * real,
            Self::Pressure | Self::DensityRatio | Self::Packing | Self::PrincipalStrain => real,
            Self::Surface | Self::Id => 4,
        }
    }
}

/// Precision of the numbers in the files of fields
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FieldPrecision {
    /// Seven digits: enough for pictures, half the size
    #[default]
    F32,
    /// As they were computed, to the last bit of a run in double precision
    F64,
}

impl FieldPrecision {
    /// Bytes of a number.
    pub fn bytes(self) -> usize {
        match self {
            Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

/// Form of the files of fields
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FieldForm {
    /// VTK's XML, an unstructured grid, listed in a `.pvd`
    #[default]
    Vtu,
    /// VTK's XML, polygonal data, listed in a `.pvd`: for what takes surfaces and points only
    Vtp,
    /// HDF5 in the layout of VTK (9.3 or later), listed in a `.vtkhdf.series`
    Vtkhdf,
}

/// Form of the table of probes
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ProbeForm {
    /// Text, `probes.csv`
    #[default]
    Csv,
    /// Binary, `probes.npy`, for long runs: `numpy.load("probes.npy")["time [s]"]` is a column
    Npy,
}
