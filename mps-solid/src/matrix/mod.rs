//! The stiffness matrix of a body, and what follows from it: frequencies, modes, static equilibria.
//!
//! Everything else in this crate moves particles in time. Here the energy of the body is looked at as a
//! function of all positions, and its second derivative, the sparse matrix `K`, is factorised:
//!
//! - [`Stiffness`]: `K` and the lumped masses `M` of the degrees of freedom that move;
//! - [`Stiffness::lowest`]: the lowest frequencies and shapes of `K phi = omega^2 M phi`;
//! - [`Stiffness::solve`]: the small displacement under a load, `K u = f`;
//! - [`Newton`]: the equilibrium of a body under dead loads and gravity, displacements of any size.
//!
//! So a frequency is known to many digits without a time step, and a body may start at rest under its
//! own weight. Double precision only. The linear algebra is that of `faer`, on one thread.
//!
//! ```
//! use mps_kernel::{Vector, weights::WendlandC2};
//! use mps_neighbors::Parallel;
//! use mps_solid::{Solid, SolidConfig, body::{self, Face}, materials::CorotationalHooke};
//! use mps_solid::matrix::{Newton, Stiffness};
//!
//! let (lower, upper) = (Vector::<f64, 2>::zeros(), Vector::<f64, 2>::new(0.1, 0.005));
//! let strip = body::block(lower, upper, [60, 3], &[Face::lower(0)])?;
//! let rubber = CorotationalHooke::new(7.8e6, 0.4)?;
//! let parallel = Parallel::serial();
//! let mut solid = Solid::new(
//!     strip.particles, strip.spacing, 1100.0, rubber, WendlandC2, SolidConfig::default(), &parallel,
//! )?;
//! let modes = Stiffness::new(&solid)?.lowest(2)?;
//! // A clamped beam: the second frequency is 6.27 times the first.
//! assert!((modes[1].omega() / modes[0].omega() - 6.2).abs() < 0.1);
//!
//! let no_load = vec![Vector::zeros(); solid.len()];
//! let gravity = Vector::<f64, 2>::new(0.0, -9.81);
//! Newton::default().equilibrium(&mut solid, &parallel, &no_load, &gravity)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assembly;
mod eigen;
mod error;
mod factor;
mod freedoms;
mod held;
mod modes;
mod newton;
mod stiffness;
mod tangent;

pub use error::MatrixError;
pub use modes::Mode;
pub use newton::{Equilibrium, Newton};
pub use stiffness::Stiffness;
