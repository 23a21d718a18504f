//! The mathematics of one particle pair in the moving particle semi-implicit (MPS) method.
//!
//! This crate knows what two particles do to each other and nothing else: it holds no loop over
//! particles, allocates nothing and starts no thread. Neighbour search and parallel sweeps live in
//! `mps-neighbors`, the physics in `mps-fluid` and `mps-solid`.
//!
//! - [`Real`], [`Vector`], [`Tensor`]: the scalar (`f32` or `f64`) and the `D`-dimensional values.
//! - [`Number`], [`Lanes`]: what pair formulas are written for, one scalar or several side by side.
//! - [`Kernel`]: the weight `W(r, re)`; one file for each formula in [`weights`].
//! - [`ReferenceDensity`]: `n0` and `lambda0` of the full lattice; [`LatticeWaves`]: what operators make of its waves.
//! - [`operators`]: gradient, divergence, Laplacian and the corrected matrix, written as what one
//!   pair adds ([`PairOperator`]).
//! - [`Neighborhood`]: how an operator asks for the neighbours of a particle.
//! - [`ParticleStore`]: how reordering, hashing and checkpoints reach every field of a phase.
//!
//! # Example: a gradient on a small lattice
//!
//! Any type that can list neighbours will do; this one looks at every particle. The plain gradient is
//! exact where the neighbourhood is full, the corrected one at the corner too.
//!
//! ```
//! use mps_kernel::operators::{Corrected, Gradient, MomentMatrix, invert_moment};
//! use mps_kernel::weights::Rational;
//! use mps_kernel::{Neighborhood, Pair, ReferenceDensity, Vector, apply};
//!
//! struct AllPairs {
//!     position: Vec<Vector<f64, 2>>,
//!     radius: f64,
//! }
//!
//! impl Neighborhood<f64, 2> for AllPairs {
//!     fn len(&self) -> usize {
//!         self.position.len()
//!     }
//!     fn for_each(&self, i: usize, mut visit: impl FnMut(&Pair<f64, 2>)) {
//!         for j in (0..self.len()).filter(|&j| j != i) {
//!             let r_ij = self.position[j] - self.position[i];
//!             if r_ij.norm() < self.radius {
//!                 visit(&Pair::new(j, r_ij, &Rational, self.radius));
//!             }
//!         }
//!     }
//! }
//!
//! // 7 x 7 particles, 0.1 m apart, and a field that is linear in the place.
//! let (spacing, radius) = (0.1, 0.3);
//! let position: Vec<_> =
//!     (0..49).map(|k| Vector::from([f64::from(k % 7), f64::from(k / 7)]) * spacing).collect();
//! let pressure: Vec<f64> = position.iter().map(|x| 2.0 * x[0] - 5.0 * x[1]).collect();
//! let particles = AllPairs { position, radius };
//! let reference = ReferenceDensity::lattice::<_, 2>(&Rational, spacing, radius)?;
//! let factor = reference.gradient_factor::<2>();
//!
//! let middle = apply(&Gradient { factor }, &particles, 24, &pressure);
//! assert!((middle - Vector::from([2.0, -5.0])).norm() < 1e-12);
//!
//! let corner = apply(&Gradient { factor }, &particles, 0, &pressure);
//! assert!((corner - Vector::from([2.0, -5.0])).norm() > 1.0);
//! let moment = apply(&MomentMatrix { factor }, &particles, 0, &pressure);
//! let correction: Corrected<f64, 2> = invert_moment(&moment, 0.05);
//! assert!((correction * corner - Vector::from([2.0, -5.0])).norm() < 1e-12);
//! # Ok::<(), mps_kernel::ReferenceDensityError>(())
//! ```

mod clock;
mod lanes;
mod lattice_waves;
mod neighborhood;
mod number;
pub mod operators;
mod pair;
mod real;
mod reference_density;
pub mod small;
mod state;
mod store;
pub mod tensor;
pub mod weights;

pub use clock::{Clock, add_carrying};
pub use lanes::{F32Lanes, F64Lanes, Lanes};
pub use lattice_waves::{LatticeNeighbor, LatticeWaves, WaveSymbols};
pub use neighborhood::{Neighborhood, PairOperator, apply};
pub use number::Number;
pub use pair::Pair;
pub use real::{Real, Tensor, Vector};
pub use reference_density::{ReferenceDensity, ReferenceDensityError};
pub use state::{Section, State, StateError, Transfer};
pub use store::{FieldVisitor, ParticleStore, Pod};
pub use weights::Kernel;
