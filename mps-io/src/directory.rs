//! The output directory, and files that appear whole or not at all.

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::OutputError;

/// Creates `dir` with its parents and proves that a file can be written there.
///
/// Call it before the first step: a run of many hours should not fail at its first output. The
/// sentence of the error says what to change.
pub fn prepare_output(dir: impl AsRef<Path>) -> Result<(), OutputError> {
    let dir = dir.as_ref();
    // `metadata` rather than `create_dir_all` first: the latter reports a file in the way as
    // "File exists", which does not tell the user what to do.
    if fs::metadata(dir).is_ok_and(|found| !found.is_dir()) {
        return Err(OutputError::NotADirectory { path: dir.to_path_buf() });
    }
    fs::create_dir_all(dir).map_err(OutputError::file("create the directory", dir))?;
    let probe = dir.join(format!(".write-test-{}", std::process::id()));
    // Some bytes, not only a name: a full disk still accepts an empty file.
    fs::write(&probe, [b'.'; 4096]).map_err(OutputError::file("write into", dir))?;
    fs::remove_file(&probe).map_err(OutputError::file("remove a test file from", dir))
}

/// Writes `path` through a neighbour `.path.part` and renames it, so that a reader, ParaView or a
/// script watching a running job, sees the old file or the new one and never half of either.
pub(crate) fn write_atomically(
    path: &Path,
    fill: impl FnOnce(&mut BufWriter<File>) -> std::io::Result<()>,
) -> Result<(), OutputError> {
    let part = part_of(path);
    let write = || {
        let mut file = BufWriter::with_capacity(1 << 16, File::create(&part)?);
        fill(&mut file)?;
        file.flush()
    };
    let renamed = write().and_then(|()| fs::rename(&part, path));
    renamed.map_err(|source| {
        // The half-written neighbour is of no use to anyone; the first error is the one to report.
        let _ = fs::remove_file(&part);
        OutputError::file("write", path)(source)
    })
}

fn part_of(path: &Path) -> PathBuf {
    let mut name = std::ffi::OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(".part");
    path.with_file_name(name)
}
