//! What a form of files has to be able to do.

use std::path::Path;

use super::encode::Frame;
use crate::OutputError;

/// VTK's number for a cell that is a single vertex: every particle is one.
pub(super) const VERTEX: u8 = 1;

/// A form of the files of a series: one a frame, and one that lists them.
pub(super) trait Form {
    /// How the name of a frame ends.
    fn ending(&self) -> &'static str;

    /// How the name of the list ends.
    fn list_ending(&self) -> &'static str;

    /// Writes a frame of this time \[s\], whole or not at all.
    fn write(&mut self, path: &Path, time: f64, frame: &Frame) -> Result<(), OutputError>;

    /// Writes the list of the frames with their times \[s\], whole or not at all.
    fn list(&self, path: &Path, frames: &[(f64, String)]) -> Result<(), OutputError>;
}
