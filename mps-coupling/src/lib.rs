//! Lets a fluid and structures touch: the partitioned coupling with sub-cycling (paper 1,
//! sections 2.2.4 to 2.2.8).

mod budget;
mod contact;
mod elastic;
mod error;
mod fixed;
mod guard;
mod overlap;
mod register;
mod saved;
mod scene;
mod stability;
mod structure;

pub use budget::{Budget, Closure, Handed};
pub use elastic::ElasticBody;
pub use error::CouplingError;
pub use fixed::Fixed;
pub use register::Interface;
pub use scene::Scene;
pub use structure::{Inertia, Momenta, Structure, StructureEnergy};
