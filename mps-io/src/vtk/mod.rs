//! Fields for ParaView and other readers of VTK's formats.
//!
//! [`FieldWriter`] writes one `name_00012.vtu` for each time and a collection `name.pvd` that lists
//! them with their times. Every particle is one vertex cell, so that thresholds and selections work
//! on single particles. Values are appended binary, exact to the bit unless single precision is
//! asked for. The same frames can be [polygonal data](FieldFormat::Vtp) or [HDF5 files](FieldFormat::VtkHdf).
//!
//! | file | part |
//! |---|---|
//! | `cloud` | what is written |
//! | `encode` | as arrays of numbers, the same for every form |
//! | `form` | what a form of files has to do |
//! | `xml`, `appended` | VTK's XML |
//! | `vtkhdf` | HDF5 |
//! | `writer` | a series of frames |

mod appended;
mod cloud;
mod encode;
mod form;
mod vtkhdf;
mod writer;
mod xml;

pub use cloud::PointCloud;
pub use writer::{FieldFormat, FieldOptions, FieldWriter};
