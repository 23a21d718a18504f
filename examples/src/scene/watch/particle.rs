//! The particle that a failure is about.

use crate::Failure;
use mps_coupling::CouplingError;
use mps_fluid::FluidError;
use mps_solid::SolidError;
use std::error::Error;
use std::fmt;

use super::alarm::Alarm;

/// A particle of the fluid or of a body, by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Particle {
    Fluid(u32),
    Solid { body: usize, id: u32 },
}

impl fmt::Display for Particle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fluid(id) => write!(f, "fluid particle {id}"),
            Self::Solid { body, id } => write!(f, "particle {id} of solid {}", body + 1),
        }
    }
}

impl Particle {
    /// As two numbers, for a state.
    pub(super) fn code(self) -> [f64; 2] {
        match self {
            Self::Fluid(id) => [0.0, f64::from(id)],
            Self::Solid { body, id } => [body as f64 + 1.0, f64::from(id)],
        }
    }

    /// Back from [`code`](Self::code).
    pub(super) fn of([body, id]: [f64; 2]) -> Self {
        if body < 1.0 {
            Self::Fluid(id as u32)
        } else {
            Self::Solid { body: body as usize - 1, id: id as u32 }
        }
    }

    /// Whom a failure names.
    pub(super) fn named_by(failure: &Failure) -> Option<Self> {
        if let Some(alarm) = failure.downcast_ref::<Alarm>() {
            return Some(alarm.particle());
        }
        match failure.downcast_ref::<CouplingError>()? {
            CouplingError::Fluid(FluidError::NotFinite { id, .. } | FluidError::TimeStep { id, .. }) => {
                Some(Self::Fluid(*id))
            }
            CouplingError::Structure { index, source, .. } => of_solid(*index, &**source),
            _ => None,
        }
    }
}

fn of_solid(body: usize, error: &(dyn Error + Send + Sync + 'static)) -> Option<Particle> {
    match error.downcast_ref::<SolidError>()? {
        SolidError::Inverted { id, .. } | SolidError::NotFinite { id, .. } => {
            Some(Particle::Solid { body, id: *id })
        }
        _ => None,
    }
}
