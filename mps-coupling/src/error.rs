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
        "structure {index} shows {positions} positions but {got} {what}: one of each per point is needed, before its first step too"
    )]
    Lengths {
        /// Number of the structure in the scene.
        index: usize,
        /// Number of positions.
        positions: usize,
        /// What it shows another number of.
        what: &'static str,
        /// That number.
        got: usize,
    },
    /// A structure has lost points, or has got more.
    #[error(
        "structure {index} shows {now} {what} in the step from t = {time:e} s, and has {before} points: their number and order must never change; \
         let `Structure::advance` leave the length of its fields alone"
    )]
    Points {
        /// Number of the structure in the scene.
        index: usize,
        /// Time at the start of the step \[s\].
        time: f64,
        /// What it shows another number of.
        what: &'static str,
        /// Its points, when it was added.
        before: usize,
        /// What it shows now.
        now: usize,
    },
    /// A structure shows a position or a velocity that is no finite number.
    #[error(
        "point {point} of structure {index} has the {what} {value:?} {unit} in the step from t = {time:e} s: every component must be finite; \
         look for a division by zero in its `advance`, or a `max_step` beyond its own stability"
    )]
    NoNumber {
        /// Number of the structure in the scene.
        index: usize,
        /// Number of the point in the structure.
        point: usize,
        /// What is no number.
        what: &'static str,
        /// Its unit.
        unit: &'static str,
        /// Its components.
        value: Vec<f64>,
        /// Time at the start of the step \[s\].
        time: f64,
    },
    /// A structure says that its forces have nothing to move.
    #[error(
        "{} of structure {index} has a mass of {mass:e} kg (`Structure::inertia`): it must be greater than zero, infinite for what nothing moves; \
         or say `Inertia::Unknown`",
        whose(*.point)
    )]
    Mass {
        /// Number of the structure in the scene.
        index: usize,
        /// Number of the point in the structure; `None` for the mass of a rigid body.
        point: Option<usize>,
        /// The mass \[kg\].
        mass: f64,
    },
    /// A structure can take no sub-step.
    #[error(
        "structure {index} says that it can take sub-steps of at most {limit:e} s (`Structure::max_step`): it must be longer than zero, infinite if any \
         will do"
    )]
    Limit {
        /// Number of the structure in the scene.
        index: usize,
        /// The limit \[s\].
        limit: f64,
    },
    /// A point of a structure stands for no volume.
    #[error("a point of structure {index} has a volume of {volume:e}: it must be positive and finite")]
    Volume {
        /// Number of the structure in the scene.
        index: usize,
        /// The volume \[m^D\].
        volume: f64,
    },
    /// The points of a structure lie closer than its spacing says, so that its surface cannot be told from its inside.
    #[error(
        "the points of a structure lie closer than its spacing of {spacing:?} m says, with {density:.2} times the number density of that lattice: \
         its surface would not be found; give the distance between neighbouring points along each axis (`Structure::spacings`)"
    )]
    Crowded {
        /// Spacing along each axis \[m\].
        spacing: Vec<f64>,
        /// Largest number density over that of the lattice \[-\].
        density: f64,
    },
    /// A structure has come so near to a wall or another structure that the next thing would be to pass through.
    #[error(
        "structure {index} has come within {distance:.3e} m of {} near {place:?} m at t = {time:e} s: contact is not modelled in a scene with a fluid, and they \
         would pass through each other; keep them apart by a support, a spring or an earlier end, or set `Scene::refuse_contacts` to false",
        whom(*.other)
    )]
    Contact {
        /// Number of the structure in the scene.
        index: usize,
        /// Number of the other structure; `None` for a wall.
        other: Option<usize>,
        /// Place of the structure's point \[m\].
        place: Vec<f64>,
        /// Distance of the two points \[m\].
        distance: f64,
        /// Time \[s\].
        time: f64,
    },
    /// A structure has been drawn into the fluid.
    #[error(
        "the fluid has a particle inside structure {index}, {distance:.3e} m from one of its points, at {place:?} m: cut the body out of the fluid, so that its \
         particles ({spacing:e} m apart) begin half a spacing before the body's surface"
    )]
    InWater {
        /// Number the structure would have in the scene.
        index: usize,
        /// Place of the particle \[m\].
        place: Vec<f64>,
        /// Its distance from the nearest point of the structure \[m\].
        distance: f64,
        /// Spacing of the fluid \[m\].
        spacing: f64,
    },
    /// A step without length was asked for.
    #[error("a step of at most {longest:e} s was asked for: it must be longer than zero")]
    Step {
        /// Longest step allowed \[s\].
        longest: f64,
    },
    /// A step has failed, and its state is no start for another one.
    #[error(
        "the step from t = {time:e} s has failed, and fluid and structures stand at different times: restore a saved state, or build the scene anew"
    )]
    Broken {
        /// Time at the start of the step \[s\].
        time: f64,
    },
    /// Structures must be added before the first step.
    #[error("structures must be added before the first step; {steps} steps have been done")]
    TooLate {
        /// Steps done.
        steps: u64,
    },
}

fn whose(point: Option<usize>) -> String {
    point.map_or_else(|| "the whole".to_owned(), |point| format!("point {point}"))
}

fn whom(other: Option<usize>) -> String {
    other.map_or_else(|| "a wall".to_owned(), |other| format!("structure {other}"))
}
