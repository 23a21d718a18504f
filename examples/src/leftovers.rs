//! What an earlier run has left in the directory of a new one.

use crate::Failure;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

/// Removes the results of an earlier run that might be taken for those of the one that begins in `dir`, which may end early or write fewer.
/// `written` are the names of what the program writes, relative to `dir`; `#` stands for the number in a name. Everything else stays.
///
/// Call it when everything is built, before the first file is written: a run that is refused leaves what is there.
///
/// # Errors
/// If the operating system refuses.
pub fn remove_leftovers(dir: &Path, written: &[impl AsRef<str>]) -> Result<(), Failure> {
    for pattern in written.iter().map(AsRef::as_ref) {
        match pattern.rsplit_once('/') {
            Some((below, pattern)) => remove(&dir.join(below), |name| fits(pattern, name))?,
            None => remove(dir, |name| fits(pattern, name))?,
        }
    }
    Ok(())
}

/// Removes the files in `dir` whose names are wanted; nothing if there is no such directory.
pub(crate) fn remove(dir: &Path, wanted: impl Fn(&str) -> bool) -> Result<(), Failure> {
    let refused =
        |error| format!("cannot remove the results of an earlier run from {}: {error}", dir.display());
    let entries = match fs::read_dir(dir) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(()),
        entries => entries.map_err(refused)?,
    };
    for entry in entries {
        let entry = entry.map_err(refused)?;
        if entry.file_name().to_str().is_some_and(&wanted) && entry.path().is_file() {
            fs::remove_file(entry.path()).map_err(refused)?;
        }
    }
    Ok(())
}

/// Whether a name is that of a pattern, with a number in the place of its `#`.
fn fits(pattern: &str, name: &str) -> bool {
    let Some((head, tail)) = pattern.split_once('#') else { return pattern == name };
    let number = name.strip_prefix(head).and_then(|rest| rest.strip_suffix(tail));
    number.is_some_and(|number| !number.is_empty() && number.chars().all(|c| c.is_ascii_digit() || c == '.'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_a_program_writes_is_removed() {
        let dir = std::env::temp_dir().join(format!("mps-leftovers-{}", std::process::id()));
        let fields = dir.join("fields");
        fs::create_dir_all(&fields).unwrap();
        let mine = ["summary.json", "snapshot_t2.5.png", "snapshot_t0.0.png", "fields/water.pvd"];
        let others = ["probes.csv", "snapshot_tank.png", "snapshot_t.png", "photo.png", "fields/mine.pvd"];
        for name in mine.iter().chain(&others) {
            fs::write(dir.join(name), "earlier").unwrap();
        }
        let written = ["summary.json", "snapshot_t#.png", "film.png", "fields/water.pvd", "none/water.pvd"];
        remove_leftovers(&dir, &written).unwrap();
        assert!(mine.iter().all(|name| !dir.join(name).exists()));
        assert!(others.iter().all(|name| dir.join(name).exists()));
        fs::remove_dir_all(&dir).unwrap();
    }
}
