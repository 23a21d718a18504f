//! The pair operators of the method: formula, source and factor of each in its own file.
//!
//! | operator | type | source (Tavakoli et al. 2026) | pinned by `tests/properties/` |
//! |---|---|---|---|
//! | gradient, difference form | [`Gradient`] | eqs. 14, 21 | `gradient.rs`, `polynomials.rs` |
//! | gradient, sum form with the ratio of n | [`ConservativeGradient`] | eq. 24, misprint corrected | `conservation.rs` |
//! | divergence, difference form | [`Divergence`] | eq. 15 | `polynomials.rs` |
//! | divergence with the ratio of n | [`ConservativeDivergence`] | eq. 23, misprint corrected | `conservation.rs`, `polynomials.rs` |
//! | Laplacian | [`Laplacian`] | eqs. 16, 25 | `polynomials.rs` |
//! | Laplacian of near neighbours | [`CompactLaplacian`] | Morris et al. 1997 | `polynomials.rs` |
//! | Laplacian along the line of each pair | [`CentralLaplacian`] | Monaghan and Gingold 1983 | `surface_strain.rs` |
//! | density-diffusion filter | [`DiffusionFilter`] | eq. 20 | `diffusion.rs`, `von_neumann.rs` |
//! | density diffusion with the hydrostatic part removed | [`HydrostaticDiffusion`] | Amaro et al. 2022, eq. 20 | `diffusion.rs` |
//! | corrected matrix and its inverse | [`MomentMatrix`], [`invert_moment`] | eq. 22 | `gradient.rs`, `degenerate.rs` |
//! | number density | [`NumberDensity`] | eq. 13 | `reference_density.rs`, `far_from_origin.rs` |
//!
//! All of them stay finite on coincident particles (`degenerate.rs`) and see nothing of where the origin
//! is (`far_from_origin.rs`).

mod central;
mod diffusion;
mod divergence;
mod gradient;
mod laplacian;
mod moment;
mod number_density;

pub use central::CentralLaplacian;
pub use diffusion::{DiffusionFilter, HydrostaticDiffusion};
pub use divergence::{ConservativeDivergence, Divergence};
pub use gradient::{ConservativeGradient, Gradient};
pub use laplacian::{CompactLaplacian, Laplacian};
pub use moment::{Corrected, MomentMatrix, invert_moment};
pub use number_density::NumberDensity;
