//! Whose turn it is: the halves of a step in their order.
//!
//! `begin_step` can say what is wrong, the calls that follow cannot. What they refuse they leave undone, and the next `begin_step` says so.

use crate::FluidError;
use mps_kernel::Real;

/// How far a step is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Stage {
    /// The last one is finished.
    #[default]
    Between,
    /// It has begun; what the sweeps left behind is not of it yet.
    Begun,
    /// Accelerations are known, and no step can be made with them.
    Stuck,
    /// Accelerations are known.
    Swept,
}

impl Stage {
    /// Whether what the sweeps left behind is of the present step.
    pub(crate) fn is_known(self) -> bool {
        matches!(self, Self::Stuck | Self::Swept)
    }
}

/// How far a step is, and what has been refused on the way.
#[derive(Debug, Default)]
pub(crate) struct Turn {
    pub(crate) stage: Stage,
    /// Whether shift, relaxation and collisions of the step are done: begun twice they happen once.
    pub(crate) regularised: bool,
    /// Whether the change of the speeds at the outlets is known, to which more is added.
    pub(crate) held: bool,
    /// The first call that was refused since the last [`admit`](Self::admit).
    pub(crate) refused: Option<FluidError>,
}

impl Turn {
    /// What has been refused since a step has begun, once.
    pub(crate) fn admit(&mut self) -> Result<(), FluidError> {
        self.refused.take().map_or(Ok(()), Err)
    }

    /// Whether it is the turn of a call that belongs behind a successful `begin_step`; remembers it if not.
    pub(crate) fn may(&mut self, call: &'static str) -> bool {
        let may = self.stage == Stage::Swept;
        if !may {
            self.refuse(FluidError::Turn { call });
        }
        may
    }

    /// Whether a step can be of the length `dt` \[s\].
    pub(crate) fn lasts<T: Real>(&mut self, dt: T) -> bool {
        // NaN is not greater either.
        let is_a_step = dt > T::zero() && dt.is_finite();
        if !is_a_step {
            self.refuse(FluidError::StepLength { dt: dt.to_double() });
        }
        is_a_step
    }

    /// Whether what was `checked` is in order.
    pub(crate) fn accepts(&mut self, checked: Result<(), FluidError>) -> bool {
        checked.map_err(|error| self.refuse(error)).is_ok()
    }

    fn refuse(&mut self, error: FluidError) {
        self.refused.get_or_insert(error);
    }
}
