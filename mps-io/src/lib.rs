//! Fields for ParaView, CSV probes, PNG plots, progress, run summaries and scene files.
//!
//! This crate watches a simulation, reads and writes; it never steers. It knows the vectors and
//! tensors of `mps-kernel` and nothing of fluids, solids or time steps.
//!
//! - [`prepare_output`]: proves before the first step that results can be written.
//! - [`FieldWriter`], [`PointCloud`]: one `.vtu`, `.vtp` or `.vtkhdf` a frame and a list that ParaView opens while the
//!   job runs.
//! - [`CsvWriter`], [`CsvTable`]: time series, complete after every row; reference curves.
//! - [`TableWriter`]: the same, as text or binary.
//! - [`CurvePlot`]: results as lines, experiments as markers, their scatter as bands.
//! - [`FieldPicture`], [`Film`]: particles coloured by pressure or strain, stills and animated PNG.
//! - [`Progress`]: how far a run is and when it will be done.
//! - [`Summary`], [`Metric`]: `summary.json`, the record of a run.
//! - [`checkpoint`]: the state of a run in a file from which it goes on with the same bits.
//! - [`scene_file`]: scenes as text, read, checked and written.
//!
//! Everything that replaces a file does so whole or not at all, so that a reader never meets half a
//! file; what grows (tables, films) is complete after every piece. A killed run keeps its results.

pub mod checkpoint;
mod csv;
mod directory;
mod error;
mod npy;
mod number;
pub mod picture;
mod plot;
mod progress;
mod raster;
pub mod scene_file;
mod summary;
mod table;
pub mod vtk;

pub use csv::{CsvTable, CsvWriter};
pub use directory::prepare_output;
pub use error::OutputError;
pub use number::number;
pub use picture::{ColorMap, FieldPicture, Film, Image, View, value_range};
pub use plot::CurvePlot;
pub use progress::Progress;
pub use summary::{Metric, Summary, Value, peak_memory_bytes};
pub use table::{TableForm, TableWriter, find_table};
pub use vtk::{FieldFormat, FieldOptions, FieldWriter, PointCloud};
