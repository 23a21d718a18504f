//! Why a matrix could not be made or used.

use crate::SolidError;
use thiserror::Error;

/// What can go wrong with the stiffness matrix of a body, and what to do about it.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MatrixError {
    /// The body, its state or what was handed over with it is unusable.
    #[error(transparent)]
    Solid(#[from] SolidError),
    /// Every particle is fixed.
    #[error("nothing of the body can move: fewer particles must be clamped")]
    NothingMoves,
    /// The stress of the material does not derive from an energy.
    #[error(
        "the stress of {material} at particle {id} is not the derivative of an energy: its tangent misses symmetry by {asymmetry}; check ConstitutiveModel::first_piola"
    )]
    NotSymmetric {
        /// Name of the material.
        material: &'static str,
        /// Identity of the particle.
        id: u32,
        /// `|A - A^T| / |A|`.
        asymmetry: f64,
    },
    /// More modes were asked for than there are.
    #[error("{asked} modes were asked for: a body with {freedoms} degrees of freedom has 1 to {freedoms}")]
    Count {
        /// Modes asked for.
        asked: usize,
        /// Degrees of freedom that move.
        freedoms: usize,
    },
    /// The search for modes did not converge.
    #[error(
        "mode {mode} (counted from 0) did not converge in {rounds} rounds: its residual is {residual} of its size; ask for a few more modes, so that a group of near frequencies is not cut"
    )]
    Modes {
        /// Which mode, ascending from 0.
        mode: usize,
        /// Rounds that were made.
        rounds: usize,
        /// Relative residual that was left.
        residual: f64,
    },
    /// The supports leave the body, or a part of it, free to move or turn as a whole.
    #[error(
        "the supports leave {motions} rigid motions of the part with particle {id} free: hold it so that it can neither move nor turn"
    )]
    NotHeld {
        /// Identity of a particle of that part.
        id: u32,
        /// How many of its motions are free.
        motions: usize,
    },
    /// A displacement costs so little energy that it is lost in rounding.
    #[error(
        "the body is held, but its smallest stiffness is {ratio:e} of the largest, too near to the rounding of the matrix (1e-16) for a displacement to be right: take fewer particles along a slender body, a smaller Poisson's ratio, or look for parts that hang together by a hinge"
    )]
    IllConditioned {
        /// Smallest over largest eigenvalue of `M^-1 K`, estimated.
        ratio: f64,
    },
    /// A displacement gains energy.
    #[error(
        "the matrix is not positive definite although the body is held: its state is not stable (reduce the load), or it is so slender that its softest bending is lost in rounding (take fewer particles along it)"
    )]
    Unstable,
    /// No equilibrium was found.
    #[error(
        "equilibrium found up to {factor} of the load, not beyond (residual {residual} of the load there; {reason}): the body buckles or collapses under more, or is too coarse for its deformation"
    )]
    NoEquilibrium {
        /// Part of the load that the body was left in equilibrium with.
        factor: f64,
        /// Residual over load of the last attempt.
        residual: f64,
        /// What stopped the last attempt.
        reason: String,
    },
    /// The library for linear algebra gave up.
    #[error("linear algebra of a body with {freedoms} degrees of freedom: {reason}")]
    Algebra {
        /// Degrees of freedom that move.
        freedoms: usize,
        /// The words of the library.
        reason: String,
    },
}
