//! Lets a fluid and structures touch: the partitioned coupling with sub-cycling (paper 1,
//! sections 2.2.4 to 2.2.8).

mod budget;
mod elastic;
mod error;
mod fixed;
mod iterated;
mod passage;
mod register;
mod scene;
mod scheme;
mod structure;

pub use budget::Budget;
pub use elastic::ElasticBody;
pub use error::CouplingError;
pub use fixed::Fixed;
pub use iterated::Iterated;
pub use register::Interface;
pub use scene::Scene;
pub use scheme::{Passage, Passed, Scheme, Sequential};
pub use structure::{Structure, StructureEnergy};
