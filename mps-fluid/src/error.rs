//! What can go wrong, where, and what to do about it.

use mps_kernel::ReferenceDensityError;
use mps_neighbors::NeighborError;
use thiserror::Error;

/// Errors of the fluid.
#[derive(Debug, Error)]
pub enum FluidError {
    /// A parameter is out of its range.
    #[error("fluid parameter `{name}` is {value}, allowed is {low:e} to {high:e}: {hint}")]
    Parameter {
        /// Name of the parameter.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Smallest allowed value.
        low: f64,
        /// Largest allowed value.
        high: f64,
        /// What the parameter means.
        hint: &'static str,
    },
    /// A field of the initial particles has the wrong length.
    #[error(
        "fluid field `{field}` has {len} entries for {particles} particles: all fields need one entry per particle"
    )]
    FieldLength {
        /// Name of the field.
        field: &'static str,
        /// Its length.
        len: usize,
        /// Number of particles.
        particles: usize,
    },
    /// A particle cannot begin as it is.
    #[error("fluid particle {id} begins with the {quantity} {value}: {hint}")]
    Initial {
        /// Identity of the particle.
        id: u32,
        /// Which quantity.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        hint: &'static str,
    },
    /// A field of the boundary has the wrong length.
    #[error(
        "boundary field `{field}` has {len} entries for {points} points: all fields need one entry per point; add points with `add_wall` or \
         `add_structure`, the latter with as many volumes as points"
    )]
    BoundaryLength {
        /// Name of the field.
        field: &'static str,
        /// Its length.
        len: usize,
        /// Number of points.
        points: usize,
    },
    /// A wall was added behind a structure.
    #[error("a wall was added after a structure and was left out: add walls first, then structures")]
    WallTooLate,
    /// A boundary point is nothing a fluid could feel.
    #[error("boundary point {point} has the {quantity} {value}: {hint}")]
    BoundaryPoint {
        /// Index of the point.
        point: usize,
        /// Which quantity.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        hint: &'static str,
    },
    /// The reference density could not be formed.
    #[error(transparent)]
    Reference(#[from] ReferenceDensityError),
    /// The neighbour search failed.
    #[error(transparent)]
    Neighbors(#[from] NeighborError),
    /// An opening that cannot be.
    #[error("an opening for the fluid is refused: {what}")]
    Opening {
        /// What is wrong and what to do.
        what: String,
    },
    /// A half of a step out of its turn.
    #[error(
        "`{call}` of the fluid was called where no step had begun, or one that could not go on, and has done nothing: call `begin_step` before, \
         once a step, and stop at its errors"
    )]
    Turn {
        /// The function.
        call: &'static str,
    },
    /// A step of no length.
    #[error(
        "`finish_step` of the fluid was asked for a step of {dt} s and has done nothing: give it what `begin_step` has returned, or a shorter \
         time greater than zero"
    )]
    StepLength {
        /// The length \[s\].
        dt: f64,
    },
    /// An inlet is asked to draw fluid in, or for no number.
    #[error(
        "an inlet has the speed {speed} m/s at t = {time:e} s, position {place:?} m: it has to be a number, not negative; \
         where fluid is to leave, put an outlet"
    )]
    Inflow {
        /// Speed \[m/s\].
        speed: f64,
        /// Time \[s\].
        time: f64,
        /// Position \[m\].
        place: Vec<f64>,
    },
    /// A particle's state is no longer a finite number.
    #[error(
        "fluid particle {id} has {quantity} {value} at t = {time:e} s (step {step}), position {position:?} m: the run has become unstable; \
         reduce cfl, raise the sound speed above ten times the largest velocity, or switch collisions on"
    )]
    NotFinite {
        /// Identity of the particle.
        id: u32,
        /// Which quantity.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Position \[m\].
        position: Vec<f64>,
        /// Time \[s\].
        time: f64,
        /// Number of steps done.
        step: u64,
    },
    /// The time step has become too small to get anywhere.
    #[error(
        "the fluid time step fell to {dt:e} s at t = {time:e} s because of fluid particle {id}, which moves at {speed} m/s: \
         it has most likely escaped or been hit; look at it in the last fields written"
    )]
    TimeStep {
        /// The step \[s\].
        dt: f64,
        /// Time \[s\].
        time: f64,
        /// The particle that limits it.
        id: u32,
        /// Its speed \[m/s\].
        speed: f64,
    },
}
