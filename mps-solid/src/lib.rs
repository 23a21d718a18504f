//! The rotation-aware total/updated Lagrangian elastic solid.
//!
//! A body is a set of particles that remember where they were. Its whole mechanics is one number, the
//! energy
//!
//! ```text
//! E = sum_i V_i [ w(F_i) + kappa sum_j (W_ij/|r0_ij|^2) |r_ij - F_i r0_ij|^2 ]
//! ```
//!
//! with the corrected deformation gradient `F_i` of the reference pairs ([`kinematics`]), the strain
//! energy `w` of a material ([`materials`]) and a coefficient `kappa` that is derived, not chosen
//! ([`stabilization`]). The forces are the exact gradient of `E` ([`momentum`]), so that linear and
//! angular momentum are kept to round-off, and the sub-steps are symplectic ([`Solid::advance`]), so that
//! the energy only oscillates.
//!
//! With the cargo feature `matrix` the second derivative of `E` is there as a sparse matrix, for frequencies,
//! modes and static equilibria without time steps (module `matrix`).
//!
//! ```
//! use mps_kernel::{Vector, weights::WendlandC2};
//! use mps_neighbors::Parallel;
//! use mps_solid::{Solid, SolidConfig, body::{self, Face}, materials::CorotationalHooke};
//!
//! // A rubber strip, 20 mm by 5 mm, clamped at its left end, under its own weight.
//! let (lower, upper) = (Vector::<f64, 2>::zeros(), Vector::<f64, 2>::new(0.02, 0.005));
//! let strip = body::block(lower, upper, [16, 4], &[Face::lower(0)])?;
//! let rubber = CorotationalHooke::new(7.8e6, 0.47)?;
//! let parallel = Parallel::serial();
//! let mut solid = Solid::new(
//!     strip.particles, strip.spacing, 1100.0, rubber, WendlandC2, SolidConfig::default(), &parallel,
//! )?;
//! let no_load = vec![Vector::<f64, 2>::zeros(); solid.len()];
//! let gravity = Vector::<f64, 2>::new(0.0, -9.81);
//! let dt = solid.max_step(&parallel);
//! solid.advance(&parallel, &no_load, &gravity, 10.0 * dt, 10)?;
//! assert!(solid.velocities().iter().all(|u| u.y <= 0.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod body;
mod config;
pub mod conformance;
pub mod contact;
mod energy;
mod error;
pub mod explain;
pub mod kinematics;
pub mod loads;
pub mod materials;
#[cfg(feature = "matrix")]
pub mod matrix;
pub mod momentum;
mod particles;
pub mod point;
mod preparation;
pub mod relaxation;
mod saved;
mod solid;
pub mod spin;
pub mod stabilization;
pub mod supports;
mod sweeps;
mod time_step;
mod undo;
mod view;

pub use config::SolidConfig;
pub use energy::SolidEnergy;
pub use error::SolidError;
pub use loads::Surface;
pub use materials::ConstitutiveModel;
pub use particles::SolidParticles;
pub use point::MaterialPoint;
pub use relaxation::{Relaxation, Settled};
pub use solid::Solid;
pub use supports::Placement;
