//! The addends of the fluid's equations, each written for one pair.

mod compact;
mod completed;
mod guard;
mod viscosity;
mod wall;

pub use compact::CompactViscosity;
pub use completed::CompletedViscosity;
pub(crate) use guard::Guard;
pub use viscosity::{ArtificialViscosity, LaminarViscosity, Viscosity};
pub(crate) use wall::WallPair;
