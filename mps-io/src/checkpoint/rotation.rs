//! The checkpoints of a run: the last and the one before.

use super::{Checkpoint, CheckpointError, decode, format};
use crate::OutputError;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The last two checkpoints of a run, `last.mps` and `before.mps` in a directory of their own.
///
/// A new one is written under a third name, forced to the disk, and takes the place of the last, which becomes the one before. So
/// at any moment, also when the program or the machine is stopped, at least one whole checkpoint is there once one has been.
#[derive(Clone, Debug)]
pub struct Rotation {
    dir: PathBuf,
    /// The last one could not be used: it must not take the place of the one before.
    spoilt: bool,
}

impl Rotation {
    /// Those in `dir`, which is created with the first checkpoint.
    pub fn new(dir: impl Into<PathBuf>) -> Self {
        Self { dir: dir.into(), spoilt: false }
    }

    /// The file of the last checkpoint.
    pub fn last(&self) -> PathBuf {
        self.dir.join("last.mps")
    }

    /// The file of the one before.
    pub fn before(&self) -> PathBuf {
        self.dir.join("before.mps")
    }

    /// Whether there is a checkpoint.
    pub fn exists(&self) -> bool {
        self.last().exists() || self.before().exists()
    }

    /// Removes the checkpoints of an earlier run.
    ///
    /// # Errors
    /// If the operating system refuses.
    pub fn clear(&self) -> Result<(), OutputError> {
        for path in [self.last(), self.before(), self.part()] {
            match fs::remove_file(&path) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    return Err(OutputError::file("remove", &path)(error));
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// Writes the last checkpoint. On a full disk the one before makes room for it.
    ///
    /// # Errors
    /// If it cannot be written. The checkpoints there are stay as they are; of two, the last one does.
    pub fn write(&mut self, checkpoint: &Checkpoint) -> Result<(), OutputError> {
        fs::create_dir_all(&self.dir).map_err(OutputError::file("create the directory", &self.dir))?;
        let part = self.part();
        let written = self.write_part(checkpoint).or_else(|error| {
            let full = matches!(error.kind(), io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded);
            // Never the last one, nor the only one.
            if full && self.last().exists() && fs::remove_file(self.before()).is_ok() {
                self.write_part(checkpoint)
            } else {
                Err(error)
            }
        });
        written.map_err(|error| {
            // Half a checkpoint is of no use to anyone; the first error is the one to report.
            let _ = fs::remove_file(&part);
            OutputError::file("write", &part)(error)
        })?;
        self.rotate().map_err(OutputError::file("put a checkpoint into", &self.dir))
    }

    fn write_part(&self, checkpoint: &Checkpoint) -> io::Result<()> {
        let mut file = File::create(self.part())?;
        file.write_all(&format::head(checkpoint))?;
        for section in checkpoint.state.sections() {
            file.write_all(&section.bytes)?;
        }
        file.sync_all()
    }

    fn rotate(&mut self) -> io::Result<()> {
        if self.last().exists() && !self.spoilt {
            fs::rename(self.last(), self.before())?;
        }
        fs::rename(self.part(), self.last())?;
        self.spoilt = false;
        // The names, too, have to survive a loss of power. Not every system can open a directory; there it is left to it.
        match File::open(&self.dir) {
            Ok(dir) => dir.sync_all(),
            Err(_) => Ok(()),
        }
    }

    /// The last checkpoint, or of the one before if that cannot be used, with its file.
    ///
    /// # Errors
    /// If there is none that can be used: what is wrong with each.
    pub fn read(&mut self) -> Result<(Checkpoint, PathBuf), CheckpointError> {
        let mut refused = Vec::new();
        for path in [self.last(), self.before()] {
            if !path.exists() {
                continue;
            }
            match read(&path) {
                Ok(found) => {
                    self.spoilt = !refused.is_empty();
                    return Ok((found, path));
                }
                Err(error) => refused.push(error),
            }
        }
        Err(match refused.len() {
            0 => CheckpointError::None { path: self.dir.clone() },
            _ => CheckpointError::AllRefused(refused),
        })
    }

    fn part(&self) -> PathBuf {
        self.dir.join(".next.mps.part")
    }
}

fn read(path: &Path) -> Result<Checkpoint, CheckpointError> {
    let file = fs::read(path).map_err(OutputError::file("read", path))?;
    decode(&file, path)
}
