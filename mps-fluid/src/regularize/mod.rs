//! Particle regularisation: pairwise collisions (DPC) and iterative corrected shifting (icPS).

mod dpc;
mod icps;

pub use dpc::Dpc;
pub(crate) use dpc::collide;
pub use icps::Shifting;
pub(crate) use icps::{largest_shift, shift};
