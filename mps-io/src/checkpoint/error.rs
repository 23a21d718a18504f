//! Why there is nothing to go on from.

use crate::OutputError;
use std::path::PathBuf;

/// A checkpoint that cannot be written, read or used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CheckpointError {
    /// The operating system refused.
    #[error(transparent)]
    File(#[from] OutputError),

    /// Bytes are missing or not as they were written.
    #[error("the checkpoint {} is damaged: {part} {problem}. Resume from the other one of its directory, or begin anew", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// The part of it.
        part: String,
        /// What is wrong with the part.
        problem: String,
    },

    /// The layout of another version.
    #[error("the checkpoint {} has version {found} of its layout, and this program knows {expected}: resume with the program that wrote it", path.display())]
    Version {
        /// The file.
        path: PathBuf,
        /// Its version.
        found: u32,
        /// The version that can be read.
        expected: u32,
    },

    /// Of another program, precision or scene.
    #[error("the checkpoint {} belongs to another {what} ({found}, and not {expected}): {remedy}", path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
        /// What differs.
        what: &'static str,
        /// As in the file.
        found: String,
        /// As it has to be.
        expected: String,
        /// What to do.
        remedy: &'static str,
    },

    /// There is none.
    #[error("there is no checkpoint in {}: give the directory of a run that wrote one, or begin it with `mps run`", path.display())]
    None {
        /// The directory.
        path: PathBuf,
    },

    /// There are some, and none can be used.
    #[error("no checkpoint can be used:\n{}", .0.iter().map(|error| format!("  {error}")).collect::<Vec<_>>().join("\n"))]
    AllRefused(Vec<CheckpointError>),
}
