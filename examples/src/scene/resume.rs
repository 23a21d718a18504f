//! A run that goes on from its last checkpoint.

use super::dimension::AnyLayout;
use super::run::{PROGRAM, Plan};
use crate::{Common, Failure, Precision, Refused};
use mps_io::checkpoint::{Identity, Rotation};
use mps_io::scene_file;
use std::path::Path;

/// Goes on with the run in `dir` until `end` \[s\], or the end of its scene. Precision, name and what is written are those of the run; threads and
/// quiet are those of `common`. Every `interval` seconds of wall time there is a checkpoint, none for zero.
///
/// # Errors
/// If there is no checkpoint that can be used, the scene or the program is another one, or what breaks the run off.
pub fn resume(dir: &Path, end: Option<f64>, common: &Common, interval: f64) -> Result<(), Failure> {
    let mut rotation = Rotation::new(checkpoints(dir));
    let (checkpoint, path) = rotation.read()?;
    let (scene, source) = scene_file::read(dir.join("scene.toml"))?;
    let precision =
        if checkpoint.identity.precision == Precision::F32.name() { Precision::F32 } else { Precision::F64 };
    Identity::new(PROGRAM, precision.name(), &scene.to_toml()?).check(&checkpoint.identity, &path)?;
    let setting = |name: &str| checkpoint.settings.get(name).map(String::as_str).unwrap_or_default();
    let common = Common {
        threads: common.threads,
        precision,
        out: Some(dir.to_path_buf()),
        no_fields: setting("fields") == "no",
        quiet: common.quiet,
        log: common.log,
    };
    let end = end.unwrap_or(scene.end_time);
    Refused::unless(end.is_finite() && end > 0.0, "--end-time", end, "give the simulated time in seconds")?;
    let name = setting("name").to_owned();
    let from = Some((&checkpoint.state, path.as_path()));
    let layout = AnyLayout::new(&scene, &source)?;
    let plan = Plan { scene: &scene, name: &name, common: &common, end, interval, rotation };
    layout.run_plan(plan, from)
}

/// The directory of the checkpoints of a run in `dir`.
pub(super) fn checkpoints(dir: &Path) -> std::path::PathBuf {
    dir.join("checkpoint")
}
