//! Fields for ParaView and other readers of VTK's XML formats.
//!
//! [`FieldWriter`] writes one `name_00012.vtu` for each time and a collection `name.pvd` that lists
//! them with their times. Every particle is one vertex cell, so that thresholds and selections work
//! on single particles. Values are appended binary, exact to the bit unless single precision is
//! asked for.

mod appended;
mod cloud;
mod writer;

pub use cloud::PointCloud;
pub use writer::{FieldOptions, FieldWriter};
