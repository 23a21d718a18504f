//! What a checkpoint belongs to.

use super::CheckpointError;
use std::path::Path;
use xxhash_rust::xxh3::xxh3_128;

/// The program, the precision and the scene that a state is of. A state of another is refused: it would not go on with the same bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Identity {
    /// Name and version of the program.
    pub program: String,
    /// Name of the scalar type, `f64` or `f32`.
    pub precision: String,
    /// Checksum of the scene.
    pub scene: u128,
}

impl Identity {
    /// Of the program, the precision and the text of the scene.
    pub fn new(program: impl Into<String>, precision: impl Into<String>, scene: &str) -> Self {
        Self { program: program.into(), precision: precision.into(), scene: xxh3_128(scene.as_bytes()) }
    }

    /// Refuses the state of something `other` than this, found in the file at `path`.
    ///
    /// # Errors
    /// If the program, the precision or the scene differs: which, and what to do.
    pub fn check(&self, other: &Self, path: &Path) -> Result<(), CheckpointError> {
        let refuse = |what, found: &str, expected: &str, remedy| {
            let (found, expected) = (found.to_owned(), expected.to_owned());
            Err(CheckpointError::Foreign { path: path.to_path_buf(), what, found, expected, remedy })
        };
        if other.program != self.program {
            return refuse("program", &other.program, &self.program, "resume with the program that wrote it");
        }
        if other.precision != self.precision {
            return refuse(
                "precision",
                &other.precision,
                &self.precision,
                "resume with the precision it was written with",
            );
        }
        if other.scene != self.scene {
            let [found, expected] = [other, self].map(|identity| format!("{:032x}", identity.scene));
            let remedy = "put the scene back as it was, or begin the changed one anew with `mps run`";
            return refuse("scene", &found, &expected, remedy);
        }
        Ok(())
    }
}
