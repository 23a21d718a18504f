//! What can go wrong with output: every message names the path and says what to change.

use std::io;
use std::path::{Path, PathBuf};

/// A failure to write (or read back) output.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OutputError {
    /// The operating system refused a file operation.
    #[error("cannot {action} {}: {source}. {}", path.display(), remedy(source))]
    File {
        /// What was tried, as a verb: `"write"`, `"create the directory"`.
        action: &'static str,
        /// The file or directory.
        path: PathBuf,
        /// The answer of the operating system.
        source: io::Error,
    },

    /// The output directory is a file.
    #[error(
        "the output directory {} is a file. Choose another output directory, or move the file away",
        path.display()
    )]
    NotADirectory {
        /// The file in the way.
        path: PathBuf,
    },

    /// A field has not one value for each particle.
    #[error(
        "field '{field}' has {found} values for {expected} particles. \
         Pass one value for each position, in the same order"
    )]
    FieldLength {
        /// Name of the field or layer.
        field: String,
        /// Number of positions.
        expected: usize,
        /// Number of values.
        found: usize,
    },

    /// A particle that is to be written and is not there.
    #[error(
        "particle {particle} is to be written, and there are {particles}. Number them from 0, as the positions are"
    )]
    NoParticle {
        /// Its number.
        particle: u32,
        /// Number of positions.
        particles: usize,
    },

    /// An HDF5 file that cannot be made.
    #[error("cannot make the HDF5 file {}: {reason}. The form vtu holds the same fields", path.display())]
    Hdf {
        /// The file.
        path: PathBuf,
        /// The answer of the HDF5 library.
        reason: String,
    },

    /// A name that occurs twice in one file, or cannot be part of a file name.
    #[error("the name '{name}' cannot be used in {}: {reason}", path.display())]
    Name {
        /// The file that would have held it.
        path: PathBuf,
        /// The name.
        name: String,
        /// Why not, and what to use instead.
        reason: &'static str,
    },

    /// A row of a table with too few or too many values.
    #[error(
        "{} has {expected} columns, and row {row} has {found} values. \
         Pass one number for each column named in the header", path.display()
    )]
    RowLength {
        /// The table.
        path: PathBuf,
        /// Number of columns in the header.
        expected: usize,
        /// Number of values in the row.
        found: usize,
        /// Row number, counted from 1 after the header.
        row: u64,
    },

    /// A table whose text is not what a table should hold.
    #[error("{} line {line}: {problem}", path.display())]
    Table {
        /// The table.
        path: PathBuf,
        /// Line number, counted from 1.
        line: usize,
        /// What is wrong and what was expected.
        problem: String,
    },

    /// A picture that cannot be drawn as asked.
    #[error("cannot draw {what}: {reason}")]
    Picture {
        /// Title of the plot or label of the layer.
        what: String,
        /// What is wrong and what to change.
        reason: String,
    },

    /// Two pictures of different size in one film.
    #[error(
        "{}: a frame of {found_width} x {found_height} pixels in a film of {width} x {height}. \
         Keep the view, the width and the colour bars the same in all frames", path.display()
    )]
    FrameSize {
        /// The film.
        path: PathBuf,
        /// Width of the film in pixels.
        width: u32,
        /// Height of the film in pixels.
        height: u32,
        /// Width of the frame in pixels.
        found_width: u32,
        /// Height of the frame in pixels.
        found_height: u32,
    },

    /// The PNG encoder refused.
    #[error("cannot encode {} as PNG: {reason}", path.display())]
    Encode {
        /// The picture or film.
        path: PathBuf,
        /// The answer of the encoder.
        reason: String,
    },

    /// A summary that cannot be turned into JSON or back.
    #[error("{} is not a summary: {reason}", path.display())]
    Summary {
        /// The file.
        path: PathBuf,
        /// The answer of the JSON library.
        reason: String,
    },
}

impl OutputError {
    /// For `map_err`: remembers what was tried and where.
    pub(crate) fn file(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_path_buf();
        move |source| Self::File { action, path, source }
    }
}

/// What the user can change, by the kind of failure.
fn remedy(error: &io::Error) -> &'static str {
    use io::ErrorKind as Kind;
    match error.kind() {
        Kind::NotFound => "Check the spelling, and create the directory before the run",
        Kind::PermissionDenied | Kind::ReadOnlyFilesystem => {
            "Choose a directory you may write to, or change its permissions"
        }
        Kind::AlreadyExists | Kind::NotADirectory => {
            "A file is where a directory should be: choose another path, or move that file away"
        }
        Kind::IsADirectory => "A directory has the name of the file: choose another path, or move it away",
        Kind::StorageFull | Kind::QuotaExceeded | Kind::FileTooLarge => {
            "Free some space, write fewer frames, or choose another disk"
        }
        _ => "Check that the disk is mounted, writable and not full",
    }
}
