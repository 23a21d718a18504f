//! What a counted fluid has and what it has not.

use mps_fluid::{Diffusion, FluidConfig, PressureForm, Shifting, Slip, Tension};
use mps_kernel::Real;

/// One physics or option of the fluid. Each is counted on top of a fluid that has nothing but pressure, continuity and gravity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Physics {
    /// Floor and side walls with free slip, three points deep.
    Walls,
    /// Walls with no slip, in a fluid with laminar viscosity.
    NoSlip,
    /// Walls with the law of the wall.
    WallLaw,
    /// Artificial viscosity.
    Artificial,
    /// Laminar viscosity.
    Laminar,
    /// Density diffusion by the filter.
    Filter,
    /// Density diffusion by the hydrostatic Laplacian.
    Hydrostatic,
    /// Pairwise collisions (DPC).
    Collisions,
    /// One part of the particle shifting (icPS).
    Shifting,
    /// Corrected sums.
    Corrected,
    /// Relaxation of the density to the packing.
    Relaxation,
    /// An inlet on one side and an outlet on the other.
    Openings,
    /// Books of the energy.
    Books,
    /// A scene around the fluid, with an elastic body beside the water.
    Structure,
}

impl Physics {
    /// All of them.
    pub const ALL: [Self; 14] = [
        Self::Walls,
        Self::NoSlip,
        Self::WallLaw,
        Self::Artificial,
        Self::Laminar,
        Self::Filter,
        Self::Hydrostatic,
        Self::Collisions,
        Self::Shifting,
        Self::Corrected,
        Self::Relaxation,
        Self::Openings,
        Self::Books,
        Self::Structure,
    ];

    /// Name in tables and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Walls => "walls",
            Self::NoSlip => "no-slip",
            Self::WallLaw => "wall-law",
            Self::Artificial => "artificial-viscosity",
            Self::Laminar => "laminar-viscosity",
            Self::Filter => "filter-diffusion",
            Self::Hydrostatic => "hydrostatic-diffusion",
            Self::Collisions => "collisions",
            Self::Shifting => "shifting",
            Self::Corrected => "corrected-sums",
            Self::Relaxation => "density-relaxation",
            Self::Openings => "openings",
            Self::Books => "books",
            Self::Structure => "structure",
        }
    }

    /// The subject it is counted on top of.
    pub fn base(self) -> &'static str {
        match self {
            Self::NoSlip => "walls+laminar-viscosity",
            Self::WallLaw => "walls",
            Self::Structure => "scene",
            _ => "bare",
        }
    }

    /// The files of the source, or folders, in which nothing is executed without it.
    pub fn sources(self) -> &'static [&'static str] {
        match self {
            Self::Walls => &["mps-fluid/src/terms/wall.rs", "mps-fluid/src/terms/guard.rs"],
            Self::NoSlip => &["mps-fluid/src/shear/no_slip.rs", "mps-fluid/src/shear/surface.rs"],
            Self::WallLaw => &["mps-fluid/src/shear/wall_law.rs"],
            // Formulas of lanes: their instructions belong to the files of the lanes.
            Self::Artificial | Self::Laminar | Self::Filter | Self::Hydrostatic => &[],
            Self::Collisions => &["mps-fluid/src/regularize/dpc.rs"],
            Self::Shifting => &["mps-fluid/src/regularize/icps.rs"],
            Self::Corrected => &["mps-fluid/src/correction.rs"],
            Self::Relaxation => &["mps-fluid/src/regularize/relaxation.rs"],
            Self::Openings => &["mps-fluid/src/open/"],
            Self::Books => &["mps-fluid/src/budget/"],
            Self::Structure => &["mps-fluid/src/exchange/", "mps-coupling/src/", "mps-solid/src/"],
        }
    }
}

/// What a fluid has.
#[derive(Clone, Copy, Debug)]
pub struct Recipe(pub &'static [Physics]);

impl Recipe {
    /// What the elastic gate has, without the gate, with the weight of the paper.
    pub const GATE: Self = Self(&[Physics::Walls, Physics::Artificial, Physics::Filter, Physics::Collisions]);

    /// Whether it has this.
    pub fn has(self, physics: Physics) -> bool {
        self.0.contains(&physics)
    }

    /// Its walls, if any.
    pub(super) fn walls(self) -> Option<Slip> {
        if self.has(Physics::NoSlip) {
            Some(Slip::None)
        } else if self.has(Physics::WallLaw) {
            Some(Slip::Law)
        } else {
            self.has(Physics::Walls).then_some(Slip::Free)
        }
    }

    /// Switches on what it has and off what it has not.
    pub fn configure<T: Real, const D: usize>(self, config: &mut FluidConfig<T, D>) {
        if !self.has(Physics::Collisions) {
            config.collisions = None;
        }
        if self.has(Physics::Hydrostatic) {
            config.diffusion = Diffusion::Hydrostatic;
        } else if !self.has(Physics::Filter) {
            config.diffusion = Diffusion::None;
        }
        if self.has(Physics::Shifting) {
            config.shifting = Some(Shifting { iterations: 1, ..Shifting::default() });
        }
        if self.has(Physics::Corrected) {
            config.pressure_form = PressureForm::Corrected;
        }
        if self.has(Physics::Relaxation) {
            config.tension = Tension::Keep;
            config.density_relaxation = T::of(0.01);
        }
    }
}
