//! When the state of a run is kept, and where.

use super::resume::checkpoints;
use crate::{Asked, Failure, Stop};
use mps_io::checkpoint::{Checkpoint, Identity, Rotation};
use mps_kernel::State;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use thiserror::Error;

/// Writes the checkpoints of a run.
pub(super) struct Keeper {
    dir: PathBuf,
    rotation: Rotation,
    identity: Identity,
    settings: BTreeMap<String, String>,
    /// Wall time between two checkpoints; `None` for none at an interval.
    interval: Option<Duration>,
    written: Instant,
    /// Time of the last one \[s\].
    kept: Option<f64>,
    stop: Stop,
    /// Who has asked for the end.
    asked: Option<Asked>,
}

/// A run that has not come to its end.
#[derive(Debug, Error)]
pub(super) enum Stopped {
    /// On request.
    #[error("stopped by {by}. Its state at t = {time:e} s is in {}: go on with `mps resume {}`", path.display(), dir.display())]
    Interrupted { by: Asked, time: f64, path: PathBuf, dir: PathBuf },
    /// By a failure, with a checkpoint to go on from.
    #[error(
        "{source}\nThe last good checkpoint, of t = {time:e} s, is {}: `mps resume {}` goes on from there (what was wrong with the disk may be mended, \
         a failure of the simulation comes again)",
        path.display(),
        dir.display()
    )]
    Failed { source: Failure, time: f64, path: PathBuf, dir: PathBuf },
}

/// Whether a run ended because somebody wanted it to.
pub(crate) fn is_stopped(failure: &Failure) -> bool {
    failure.downcast_ref().is_some_and(|stopped| matches!(stopped, Stopped::Interrupted { .. }))
}

impl Keeper {
    /// For a run in `dir`, every `interval` seconds of wall time, zero for never, and listens from now on to whoever wants it to end.
    pub(super) fn new(
        dir: &Path,
        rotation: Rotation,
        identity: Identity,
        settings: BTreeMap<String, String>,
        interval: f64,
    ) -> Result<Self, Failure> {
        let stop = Stop::listen(dir)?;
        let interval = (interval > 0.0).then(|| Duration::try_from_secs_f64(interval)).transpose()?;
        let (dir, written) = (dir.to_path_buf(), Instant::now());
        Ok(Self { dir, rotation, identity, settings, interval, written, kept: None, stop, asked: None })
    }

    /// Goes on from a checkpoint of this time \[s\], which counts as kept.
    pub(super) fn went_on_from(&mut self, time: f64) {
        self.kept = Some(time);
    }

    /// Whether a checkpoint is due by the clock.
    pub(super) fn is_due(&self) -> bool {
        self.interval.is_some_and(|interval| self.written.elapsed() >= interval)
    }

    /// Whether somebody has asked for the end.
    pub(super) fn is_stopped(&mut self) -> bool {
        self.asked = self.asked.or_else(|| self.stop.asked());
        self.asked.is_some()
    }

    pub(super) fn write(&mut self, state: State, time: f64) -> Result<(), Failure> {
        let (identity, settings) = (self.identity.clone(), self.settings.clone());
        self.rotation.write(&Checkpoint { identity, settings, state })?;
        tracing::info!(time, "checkpoint");
        (self.kept, self.written) = (Some(time), Instant::now());
        Ok(())
    }

    /// The directory of the run.
    pub(super) fn directory(&self) -> &Path {
        &self.dir
    }

    /// Writes a checkpoint to another directory, from which a run without fields goes on.
    pub(super) fn write_apart(&self, dir: &Path, state: State) -> Result<(), Failure> {
        let mut settings = self.settings.clone();
        settings.insert("fields".to_owned(), "no".to_owned());
        let checkpoint = Checkpoint { identity: self.identity.clone(), settings, state };
        Ok(Rotation::new(checkpoints(dir)).write(&checkpoint)?)
    }

    /// What a run says that was stopped and has been kept.
    pub(super) fn interrupted(&self) -> Stopped {
        let (path, dir) = (self.rotation.last(), self.dir.clone());
        let by = self.asked.unwrap_or(Asked::Signal);
        Stopped::Interrupted { by, time: self.kept.unwrap_or(0.0), path, dir }
    }

    /// Adds to a failure from where one can go on.
    pub(super) fn failed(&self, source: Failure) -> Failure {
        let Some(time) = self.kept else { return source };
        let path = if self.rotation.last().exists() { self.rotation.last() } else { self.rotation.before() };
        Stopped::Failed { source, time, path, dir: self.dir.clone() }.into()
    }
}
