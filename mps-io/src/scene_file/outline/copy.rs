//! Writes a scene with its files to another directory.

use super::super::scene::SceneFile;
use super::super::source::SceneError;
use super::load::{checksum, outlines};
use std::fs;
use std::path::Path;

/// Where the files of a scene are, in the directory of a run.
const OUTLINES: &str = "outlines";

impl SceneFile {
    /// Writes the scene to `dir` as `scene.toml`, with the files it was read with beside it. Returns the scene as it is there: with
    /// the paths of those files, and their checksums.
    ///
    /// # Errors
    /// If the system refuses, or a number cannot be written.
    pub fn write_to(&self, dir: &Path) -> Result<Self, SceneError> {
        let mut scene = self.clone();
        for (_, outline) in outlines(&mut scene) {
            let Some(loaded) = outline.loaded.clone() else { continue };
            let sum = checksum(&loaded.bytes);
            let old = Path::new(&outline.file).file_name().map(|name| name.display().to_string());
            let old = old.unwrap_or_default();
            // Files of different directories may have one name; one that was copied before has its checksum already.
            let name = if old.starts_with(&sum) { old } else { format!("{sum}-{old}") };
            put(&dir.join(OUTLINES), &name, &loaded.bytes)?;
            (outline.file, outline.checksum) = (format!("{OUTLINES}/{name}"), Some(sum));
        }
        put(dir, "scene.toml", scene.to_toml()?.as_bytes())?;
        Ok(scene)
    }
}

fn put(dir: &Path, name: &str, bytes: &[u8]) -> Result<(), SceneError> {
    let path = dir.join(name);
    let written = fs::create_dir_all(dir).and_then(|()| fs::write(&path, bytes));
    written.map_err(|error| SceneError::NotWritten { path, reason: error.to_string() })
}
