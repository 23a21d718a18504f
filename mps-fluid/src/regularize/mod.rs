//! Particle regularisation: pairwise collisions (DPC), iterative corrected shifting (icPS), and a density that follows the packing.

mod dpc;
mod icps;
mod relaxation;

pub use dpc::Dpc;
pub(crate) use dpc::collide;
pub use icps::Shifting;
pub(crate) use icps::{largest_shift, shift};
pub(crate) use relaxation::relax_densities;
