//! What can go wrong when fluid and structure meet.

use mps_fluid::FluidError;
use mps_kernel::ReferenceDensityError;
use mps_neighbors::NeighborError;
use std::error::Error;
use thiserror::Error;

/// Errors of a coupled scene.
#[derive(Debug, Error)]
pub enum CouplingError {
    /// The fluid cannot go on.
    #[error(transparent)]
    Fluid(#[from] FluidError),
    /// A structure cannot go on.
    #[error("structure {index} at t = {time:e} s: {source}")]
    Structure {
        /// Number of the structure in the scene.
        index: usize,
        /// Time \[s\].
        time: f64,
        /// The structure's own words.
        source: Box<dyn Error + Send + Sync>,
    },
    /// The interface could not be registered.
    #[error(transparent)]
    Interface(#[from] NeighborError),
    /// The spacing of a structure gives no lattice to compare its surface with.
    #[error("the spacing of a structure is unusable: {0}")]
    Spacing(#[from] ReferenceDensityError),
    /// A structure would need more sub-steps than makes sense.
    #[error(
        "structure {index} would need {substeps} sub-steps of {limit:e} s in one fluid step of {dt:e} s: \
         it is far stiffer than the fluid's sound speed warrants; check its modulus (Pa) and spacing, or raise max_substeps"
    )]
    SubSteps {
        /// Number of the structure in the scene.
        index: usize,
        /// Sub-steps needed.
        substeps: f64,
        /// Longest sub-step of the structure \[s\].
        limit: f64,
        /// Step of the fluid \[s\].
        dt: f64,
    },
    /// The structure's fields do not fit together.
    #[error(
        "structure {index} shows {positions} positions but {volumes} volumes: one of each per point is needed"
    )]
    Lengths {
        /// Number of the structure in the scene.
        index: usize,
        /// Number of positions.
        positions: usize,
        /// Number of volumes.
        volumes: usize,
    },
    /// Structures must be added before the first step.
    #[error("structures must be added before the first step; {steps} steps have been done")]
    TooLate {
        /// Steps done.
        steps: u64,
    },
}
