//! What an earlier run has left in the directory of a new one.

use crate::{Failure, leftovers};
use std::path::Path;

/// Whether a run writes files of this name beside its table and its log, which it begins anew in any case.
fn is_result(name: &str) -> bool {
    let numbered = |rest: &str| rest.starts_with(|c: char| c.is_ascii_digit() || c == '-');
    match name.strip_suffix(".png") {
        Some("film" | "energies" | "columns") => true,
        Some(stem) => stem.starts_with("probe_") || stem.strip_prefix("picture_").is_some_and(numbered),
        None => name == "summary.json",
    }
}

/// Whether this is a list of frames, by which they are found: those of other runs are not in the new one.
fn is_list(name: &str) -> bool {
    name.ends_with(".pvd") || name.ends_with(".vtkhdf.series")
}

/// Removes the results of an earlier run that might be taken for those of a new one in `dir`, which may write fewer. Frames of fields
/// stay, and are written over.
///
/// # Errors
/// If the operating system refuses.
pub(super) fn remove(dir: &Path) -> Result<(), Failure> {
    leftovers::remove(dir, is_result)?;
    leftovers::remove(&dir.join("fields"), is_list)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_a_run_writes_is_removed() {
        for name in ["film.png", "picture_000300ms.png", "probe_tip_x.png", "energies.png", "summary.json"] {
            assert!(is_result(name), "{name}");
        }
        for name in
            ["probes.csv", "scene.toml", "picture_of_the_tank.png", "photo.png", "notes.json", "run.log"]
        {
            assert!(!is_result(name), "{name}");
        }
        assert!(is_list("water.pvd") && is_list("solid gate.vtkhdf.series") && !is_list("water_00001.vtu"));
    }
}
