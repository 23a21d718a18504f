//! That a directory is written to by one run.

use crate::Failure;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read, Write};
use std::path::Path;

/// Name of the file that a run holds.
const NAME: &str = ".lock";

/// A directory that no other run writes to, as long as this is there.
#[derive(Debug)]
pub(super) struct Lock {
    /// The system lets go of it whatever becomes of the program.
    _held: Option<File>,
}

impl Lock {
    /// Of `dir`, which has to be there. Where the file system knows no locks, or does not let the file be, the run goes on without.
    ///
    /// # Errors
    /// If another run holds it: which one.
    pub(super) fn take(dir: &Path) -> Result<Self, Failure> {
        let path = dir.join(NAME);
        let opened = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path);
        let Ok(mut file) = opened else { return Ok(Self { _held: None }) };
        match file.try_lock() {
            Ok(()) => {
                // Only for those who are turned away.
                let _ = file.set_len(0).and_then(|()| write!(file, "{}", std::process::id()));
                Ok(Self { _held: Some(file) })
            }
            Err(TryLockError::Error(_)) => Ok(Self { _held: None }),
            Err(TryLockError::WouldBlock) => {
                let mut holder = String::new();
                let _ = file.read_to_string(&mut holder);
                let holder = if holder.is_empty() { String::new() } else { format!(" (process {holder})") };
                Err(format!(
                    "another run{holder} is writing to {}: wait for its end, stop it, or give another --out",
                    dir.display()
                )
                .into())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    #[test]
    fn a_directory_is_of_one_run_at_a_time() {
        let dir = std::env::temp_dir().join(format!("mps-lock-{}", std::process::id()));
        std::fs::create_dir_all(&dir).unwrap();
        let first = Lock::take(&dir).unwrap();
        let said = Lock::take(&dir).unwrap_err().to_string();
        assert!(
            said.contains(&format!("another run (process {}) is writing to", std::process::id())),
            "{said}"
        );
        drop(first);
        assert!(Lock::take(&dir).is_ok());
        std::fs::remove_dir_all(&dir).unwrap();
    }
}
