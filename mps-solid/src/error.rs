//! What can go wrong with a solid, and what to do about it.

use mps_neighbors::FrozenError;
use thiserror::Error;

/// Why a solid could not be built or moved.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SolidError {
    /// A parameter is out of range.
    #[error("{name} must be {must}, got {value}")]
    Parameter {
        /// Which one.
        name: &'static str,
        /// What it must be.
        must: &'static str,
        /// What it was.
        value: f64,
    },
    /// The body has no particles.
    #[error("the solid has no particles: add some before building it")]
    Empty,
    /// A block was asked for with an edge that cannot carry a lattice.
    #[error(
        "a block needs a positive length and at least 2 particles along every axis, got {count} particles over {length} m along axis {axis}: a solid one particle thick has no bending stiffness"
    )]
    Block {
        /// The axis.
        axis: usize,
        /// Particles along it.
        count: usize,
        /// Length along it \[m\].
        length: f64,
    },
    /// A particle has no volume.
    #[error("particle {id} has volume {volume}: it must be positive and finite")]
    Volume {
        /// Identity of the particle.
        id: u32,
        /// Its volume \[m^D\].
        volume: f64,
    },
    /// The reference pairs could not be found.
    #[error("reference neighbours: {0}")]
    Reference(#[from] FrozenError),
    /// A particle's reference neighbours do not span the space.
    #[error(
        "the {neighbors} reference neighbours of particle {id} at {position:?} lie on a line or plane: the deformation is undefined there; make the body at least 2 particles thick, or check the spacing against the particle distance"
    )]
    Collinear {
        /// Identity of the particle.
        id: u32,
        /// Reference position \[m\].
        position: Vec<f64>,
        /// Number of neighbours it has.
        neighbors: usize,
    },
    /// A particle has no reference neighbour at all.
    #[error(
        "particle {id} at {position:?} has no neighbour in the undeformed body: check the spacing against the particle distance"
    )]
    Alone {
        /// Identity of the particle.
        id: u32,
        /// Reference position \[m\].
        position: Vec<f64>,
    },
    /// A slice given to the solid does not fit its number of particles.
    #[error("{name} has {got} entries, but the solid has {particles} particles")]
    Length {
        /// What was given.
        name: &'static str,
        /// Its length.
        got: usize,
        /// Number of particles.
        particles: usize,
    },
    /// A load was asked for on a face that is clamped.
    #[error("the face at the {} end of axis {axis} is clamped: a load there would go straight into the support", if *upper { "upper" } else { "lower" })]
    ClampedFace {
        /// Axis the face is normal to.
        axis: usize,
        /// Whether it is at the upper end.
        upper: bool,
    },
    /// A face was to slide that is not held.
    #[error(
        "the face at the {} end of axis {axis} cannot slide, it is not clamped: name it among the clamped faces when the block is made, so that a row of particles lies on it", if *upper { "upper" } else { "lower" }
    )]
    FreeFace {
        /// Axis the face is normal to.
        axis: usize,
        /// Whether it is at the upper end.
        upper: bool,
    },
    /// A face that the body does not have.
    #[error("axis {axis} does not exist in {dimensions} dimensions")]
    NoSuchFace {
        /// Axis the face would be normal to.
        axis: usize,
        /// Number of axes.
        dimensions: usize,
    },
    /// A point of the drawing has too few particles around it.
    #[error(
        "the point {point:?} has too few particles around it: it must lie in the undeformed body or on its surface"
    )]
    Outside {
        /// The point \[m\].
        point: Vec<f64>,
    },
    /// A static answer was not reached.
    #[error(
        "not at rest after {steps} steps: the forces still miss each other by {residual:e} of the load, {tolerance:e} was asked for; allow more steps, or look whether the body is supported against every rigid motion"
    )]
    NotSettled {
        /// Steps taken.
        steps: usize,
        /// What is left of the forces, over the load.
        residual: f64,
        /// What was asked for.
        tolerance: f64,
    },
    /// A support cannot be moved like this.
    #[error("the motion of a support {problem}")]
    Motion {
        /// What is wrong, and what to do.
        problem: &'static str,
    },
    /// A particle was turned inside out.
    #[error(
        "particle {id} at {position:?} is turned inside out (det F = {determinant}): halve the sub-step (SolidConfig::cfl); if that does not help the load is too large for this resolution or the material too soft under compression (try NeoHookean)"
    )]
    Inverted {
        /// Identity of the particle.
        id: u32,
        /// Where it is \[m\].
        position: Vec<f64>,
        /// Determinant of its deformation gradient.
        determinant: f64,
    },
    /// A position became NaN or infinite.
    #[error(
        "the surroundings of particle {id} at {position:?} are not finite: check the external force and gravity, then halve the sub-step (SolidConfig::cfl)"
    )]
    NotFinite {
        /// Identity of the particle.
        id: u32,
        /// Where it is \[m\].
        position: Vec<f64>,
    },
}
