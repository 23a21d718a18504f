//! What was examined, and what was found.

use crate::SolidError;
use thiserror::Error;

/// What a material is examined for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Check {
    /// All it remembers is in the history: written as bytes, read back and led on, it gives the same bits.
    Restart,
    /// Asked again with `elapsed = 0` it gives the same stress and does not change its history.
    ElapsedZero,
    /// After [`settle`](crate::ConstitutiveModel::settle) the stress is that of a path which has been held for long, a
    /// thousand times `elapsed`.
    Settle,
    /// `P = dw/dF` with the history held at rest and `elapsed = 0`.
    EnergyGradient,
    /// `w(Q F) = w(F)` and `P(Q F) = Q P(F)`, along whole paths with a rotation of its own for each state.
    Objectivity,
    /// `P F^T` is symmetric (so is Cauchy's stress), along whole paths.
    StressSymmetry,
    /// `w(R) = 0` and `P(R) = 0` for the identity and for every other rotation.
    Rest,
    /// `dP_ij/dF_kl = dP_kl/dF_ij`. Follows from [`EnergyGradient`](Self::EnergyGradient), and is of use alone
    /// for a stress whose energy is not known.
    TangentSymmetry,
    /// `w(F Q) = w(F)`: no direction is special.
    Isotropy,
    /// The stress of small strains is Hooke's with the moduli that the model reports.
    Moduli,
    /// A small pulse in a bar that cannot become thinner travels with the wave speed that the model reports.
    WaveSpeed,
}

impl Check {
    /// All checks in the order in which they are made.
    pub const ALL: [Self; 11] = [
        Self::Restart,
        Self::ElapsedZero,
        Self::Settle,
        Self::EnergyGradient,
        Self::Objectivity,
        Self::StressSymmetry,
        Self::Rest,
        Self::TangentSymmetry,
        Self::Isotropy,
        Self::Moduli,
        Self::WaveSpeed,
    ];

    /// Whether the check makes sense for an isotropic material only.
    pub fn needs_isotropy(self) -> bool {
        matches!(self, Self::Isotropy | Self::Moduli | Self::WaveSpeed)
    }

    /// What is probably wrong with a model that fails.
    pub fn hint(self) -> &'static str {
        match self {
            Self::ElapsedZero => {
                "with elapsed = 0 nothing may be divided by elapsed or written to the history, and a stress that depends on a rate is made of the rate kept in the history"
            }
            Self::Settle => {
                "settle must leave the history of a body at rest, where it is: a rate that is kept must be set to zero, or the strain of a search for the equilibrium counts as a motion"
            }
            Self::Restart => {
                "the model keeps something outside its History (a cell, an atomic, a counter): every particle and every restart needs it inside"
            }
            Self::EnergyGradient => {
                "a wrong factor or a missing term in first_piola or in energy; if the entries differ as in a transpose, F and F^T (or F^-1 and F^-T) are exchanged"
            }
            Self::Objectivity => {
                "the energy must see F through F^T F (or the stretch of the polar decomposition) only, and a rate must be that of F^T F, not of F"
            }
            Self::StressSymmetry => {
                "P must be F S with a symmetric S: a stress with a torque of its own turns bodies that nobody turns"
            }
            Self::Rest => {
                "the energy lacks a constant, or the undeformed state is under stress (in 2D: is the third stretch, which is 1, taken into account?)"
            }
            Self::TangentSymmetry => "the stress is no derivative of any energy: a cycle would gain energy",
            Self::Isotropy => {
                "a direction is built in; if that is meant, set Conformance::isotropic to false"
            }
            Self::Moduli => {
                "first_lame_modulus or shear_modulus is not that of the energy: the bending correction and the stable step are made of them"
            }
            Self::WaveSpeed => {
                "wave_speed must be sqrt((lambda + 2 mu)/rho): look for a factor, a missing root, or a speed of shear waves or of a free bar"
            }
        }
    }
}

/// Why a material does not conform.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ConformanceError {
    /// A check found a deviation.
    #[error(
        "material {material} fails {check:?}: {quantity} is {value:e} at F = {deformation:?}, expected {expected:e} within {tolerance:e}; {}",
        check.hint()
    )]
    Violated {
        /// Which check.
        check: Check,
        /// Name of the material.
        material: &'static str,
        /// What was compared.
        quantity: String,
        /// Rows of the deformation gradient at which it was.
        deformation: Vec<Vec<f64>>,
        /// What the model gives.
        value: f64,
        /// What it should give.
        expected: f64,
        /// Largest allowed difference, in the unit of the value.
        tolerance: f64,
    },
    /// The bar for the travelling pulse could not be built or moved.
    #[error("the bar for the travelling pulse: {0}")]
    Bar(#[from] SolidError),
    /// A setting of the examination is out of range.
    #[error("{name} must be {must}, got {value}")]
    Setting {
        /// Which one.
        name: &'static str,
        /// What it must be.
        must: &'static str,
        /// What it was.
        value: f64,
    },
}

impl ConformanceError {
    /// The check that failed, if the material is to blame.
    pub fn check(&self) -> Option<Check> {
        match self {
            Self::Violated { check, .. } => Some(*check),
            Self::Bar(_) | Self::Setting { .. } => None,
        }
    }
}
