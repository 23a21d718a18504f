//! Who looks after a run while it goes: the terminal, the log, and whoever wants it to end.

use crate::log;
use crate::stop::{Asked, Stop};
use crate::{Common, Failure};
use mps_io::Progress;
use std::path::Path;

/// What `record` shows, logs and listens to.
#[derive(Debug)]
pub struct Watch {
    quiet: bool,
    stop: Option<Stop>,
}

impl Watch {
    /// Begins the log of a run in `dir`, and listens to whoever wants it to end.
    ///
    /// # Errors
    /// If the log cannot be written, or the system refuses.
    pub fn begin(dir: &Path, common: &Common) -> Result<Self, Failure> {
        Ok(Self { stop: Some(Stop::listen(dir)?), ..Self::kept(dir, common, false)? })
    }

    /// As [`begin`](Self::begin), for a run that stops by itself where it is kept, and whose log goes on if it `resumes`.
    pub(crate) fn kept(dir: &Path, common: &Common, resumes: bool) -> Result<Self, Failure> {
        log::begin(dir, common.log, resumes)?;
        tracing::info!(precision = common.precision.name(), threads = common.threads, directory = %dir.display(), "run");
        Ok(Self { quiet: common.quiet, stop: None })
    }

    /// Nobody: for a part of a program whose result is a number.
    pub fn nobody() -> Self {
        Self { quiet: true, stop: None }
    }

    /// The progress towards this simulated time \[s\].
    pub(crate) fn progress(&self, end: f64) -> Progress {
        Progress::new(self.quiet, end)
    }

    /// The error with which a run ends that is asked to, at this time \[s\].
    pub fn stopped(&self, time: f64) -> Option<Failure> {
        let stop = self.stop.as_ref()?;
        let by: Asked = stop.asked()?;
        Some(stop.stopped(by, time).into())
    }
}
