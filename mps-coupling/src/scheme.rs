//! How a step of the fluid and the sub-steps of the structures are brought together.

use crate::CouplingError;
use mps_kernel::{Real, Vector};

/// The structures' part of one step of the fluid, as a [`Scheme`] sees it.
///
/// All forces of the fluid are known before; what is not known is how fast the fluid at the interface moves while the structures do, on
/// which depends how it is compressed between them.
pub trait Passage<T: Real, const D: usize> {
    /// Takes the sub-steps, in each of which the structures feel the pressure that their own motion has raised so far.
    ///
    /// # Errors
    /// If a structure cannot go on.
    fn advance(&mut self) -> Result<(), CouplingError>;

    /// Keeps the state of the structures, for [`go_back`](Passage::go_back).
    ///
    /// # Errors
    /// If a structure cannot.
    fn keep(&mut self) -> Result<(), CouplingError>;

    /// Takes the sub-steps back, with everything that was booked; velocities supposed since then stay.
    ///
    /// # Errors
    /// If a structure cannot be brought back.
    fn go_back(&mut self) -> Result<(), CouplingError>;

    /// Velocities the fluid at the interface is supposed to have during the sub-steps \[m/s\]; at first those of the start of the step.
    fn supposed(&mut self) -> &mut [Vector<T, D>];

    /// Velocities that the same particles get by the sub-steps that have been taken \[m/s\], in the same order.
    fn found(&self, velocities: &mut Vec<Vector<T, D>>);
}

/// What a scheme has done in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Passed<T> {
    /// How often the sub-steps were taken.
    pub passes: u32,
    /// Difference between the velocities of the fluid supposed and found, over those found \[-\]; zero of a
    /// scheme that does not look.
    pub residual: T,
}

/// A way to take the sub-steps. Called once in a step of the fluid.
pub trait Scheme<T: Real, const D: usize>: Send + Sync {
    /// Moves the structures through one step.
    ///
    /// # Errors
    /// If a structure cannot go on, or cannot go back and has to.
    fn pass(&mut self, passage: &mut dyn Passage<T, D>) -> Result<Passed<T>, CouplingError>;
}

/// Once through the sub-steps, the fluid at the interface with the velocity of the start of the step (paper, sections 2.2.5 and 2.2.8).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sequential;

impl<T: Real, const D: usize> Scheme<T, D> for Sequential {
    fn pass(&mut self, passage: &mut dyn Passage<T, D>) -> Result<Passed<T>, CouplingError> {
        passage.advance()?;
        Ok(Passed { passes: 1, residual: T::zero() })
    }
}
