//! Whether what a run writes finds room on its disk.

use super::Layout;
use super::field_files::particle_bytes;
use crate::Common;
use mps_io::scene_file::SceneFile;
use std::path::{Path, PathBuf};

/// Frames of fields that a run writes.
pub(super) fn field_frames(scene: &SceneFile) -> f64 {
    let [_, _, interval, _] = scene.output.intervals(scene.end_time);
    if interval > 0.0 { (scene.end_time / interval).floor() + 1.0 } else { 0.0 }
}

/// The most that the fields of a run can take, not compressed \[bytes\].
pub(super) fn field_bytes<const D: usize>(scene: &SceneFile, layout: &Layout<D>) -> f64 {
    let [fluid, body, wall] = particle_bytes(&scene.output).map(|bytes| bytes as f64);
    let moving = scene.walls.iter().zip(&layout.walls).filter(|(wall, _)| wall.motion.is_some());
    let moving: usize = moving.flat_map(|(_, parts)| parts).map(|part| part.places.len()).sum();
    let (fluid, body) = (layout.fluid_len() as f64 * fluid, layout.solids_len() as f64 * body);
    field_frames(scene) * (fluid + body + moving as f64 * wall)
}

/// What to say of a run called `name` whose fields may not find room where it writes.
pub(super) fn short_of_disk<const D: usize>(
    scene: &SceneFile,
    layout: &Layout<D>,
    common: &Common,
    name: &str,
) -> Option<String> {
    let chosen = common.out.clone().or_else(|| scene.output.directory.as_ref().map(Into::into));
    let dir = chosen.unwrap_or_else(|| PathBuf::from("out").join(name));
    let needed = if common.no_fields { 0.0 } else { field_bytes(scene, layout) };
    // Without an answer of the system there is nothing to be said.
    let free = fs4::available_space(existing(&std::path::absolute(dir).ok()?)?).ok()?;
    shortage(needed, free as f64)
}

fn shortage(needed: f64, free: f64) -> Option<String> {
    (needed > free).then(|| {
        format!(
            "the fields may take up to {:.1} GB before compression, and there are {:.1} GB free: lengthen output.field_interval, \
             choose output.fields or output.field_region, or give another --out; a run whose disk is full keeps its last checkpoint",
            needed * 1e-9,
            free * 1e-9
        )
    })
}

/// The directory itself, or the nearest one above it that is there.
fn existing(dir: &Path) -> Option<&Path> {
    dir.ancestors().find(|above| above.is_dir())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shortage_is_told_with_both_sizes_and_a_remedy() {
        assert_eq!(shortage(2e9, 2e9), None);
        let said = shortage(2.04e9, 1e9).unwrap();
        assert!(
            said.starts_with(
                "the fields may take up to 2.0 GB before compression, and there are 1.0 GB free"
            ),
            "{said}"
        );
    }

    #[test]
    fn the_disk_is_that_of_the_nearest_directory_that_is_there() {
        let here = std::env::temp_dir();
        assert_eq!(existing(&here.join("not/there/yet-4711")), Some(here.as_path()));
    }
}
