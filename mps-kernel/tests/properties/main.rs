//! What the pair mathematics promises, checked on random particle sets in two and three dimensions.
//!
//! Every property holds to a tolerance derived from rounding, not tuned; where the source paper
//! misprints a formula, the printed form is run as well and has to fail.
//!
//! | file | promise |
//! |---|---|
//! | `weights` | support, sign, monotony and the two forms of every weight |
//! | `reference_density` | `n0`, `lambda0` and what is refused |
//! | `gradient` | corrected gradient exact for linear fields on any full neighbourhood |
//! | `polynomials` | what the plain operators reproduce on a full lattice |
//! | `conservation` | pressure and velocity operators are adjoint; momentum is kept pair by pair |
//! | `diffusion` | the density filter leaves quadratics alone, creates nothing, only damps |
//! | `von_neumann` | the same, wave by wave on the infinite lattice |
//! | `degenerate` | poor neighbourhoods and coincident particles are refused or bounded, never NaN |
//! | `far_from_origin` | nothing depends on where the origin is |
//! | `lanes` | several pairs at a time give the bits of one at a time |
//! | `strained_lattice` | which weights make a fluid of the plain sums, and which a soft solid |
//! | `tensor`, `polar` | the small tensors |

#![allow(clippy::unwrap_used, reason = "a test may fail")]

mod common;

mod conservation;
mod degenerate;
mod diffusion;
mod far_from_origin;
mod gradient;
mod lanes;
mod polar;
mod polynomials;
mod reference_density;
mod strained_lattice;
mod surface_strain;
mod tensor;
mod von_neumann;
mod weights;
