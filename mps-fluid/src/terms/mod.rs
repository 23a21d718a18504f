//! The addends of the fluid's equations, each written for one pair.

mod viscosity;
mod wall;

pub use viscosity::{ArtificialViscosity, LaminarViscosity, Viscosity};
pub(crate) use wall::WallPair;
