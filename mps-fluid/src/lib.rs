//! The weakly compressible MPS fluid (paper 1, sections 2.2.2 and 2.2.7).
//!
//! Number density by the continuity equation, density diffusion (DMPS), conservative pressure
//! gradient, Tait's equation of state, symplectic stepping, boundary points with free slip or no
//! slip, free-surface detection, pairwise collisions (DPC) and iterative corrected shifting (icPS).

mod boundary;
mod budget;
mod checks;
mod compressibility;
mod config;
mod continuity;
mod correction;
mod energy;
mod eos;
mod error;
mod exchange;
pub mod explain;
mod fluid;
mod gather;
mod gradient;
mod momentum;
mod open;
mod packing;
mod particles;
mod push;
mod rates;
mod regularize;
mod saved;
mod search;
mod shear;
mod stability;
pub mod surface;
mod terms;
mod time_step;
mod turn;

pub use boundary::{Boundary, Shear, Slip};
pub use budget::EnergyBudget;
pub use compressibility::Compressibility;
pub use config::{Diffusion, FluidConfig, PressureForm, Tension};
pub use energy::FluidEnergy;
pub use eos::{EquationOfState, Tait};
pub use error::FluidError;
pub use fluid::Fluid;
pub use open::{Inlet, Opening, Outlet};
pub use particles::FluidParticles;
pub use push::Push;
pub use regularize::{Dpc, Shifting};
pub use shear::WallLaw;
pub use terms::{ArtificialViscosity, CompactViscosity, LaminarViscosity, Viscosity};
pub use time_step::{Limit, StepLimits};
