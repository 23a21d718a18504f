//! How a run is asked to end early.

use crate::Failure;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use thiserror::Error;

/// Listens for a signal, and for a file named `stop` in the directory of the run: for those who cannot send signals to the
/// machine it is on.
#[derive(Debug)]
pub struct Stop {
    signal: Arc<AtomicBool>,
    file: PathBuf,
}

/// Who has asked for the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum Asked {
    /// Ctrl-C or TERM.
    #[error("a signal")]
    Signal,
    /// The file.
    #[error("the file `stop`")]
    File,
}

/// A run of a program without checkpoints that was asked to end.
#[derive(Debug, Error)]
#[error("stopped by {by} at t = {time:e} s. What was computed until then is in {}", dir.display())]
pub struct Stopped {
    by: Asked,
    time: f64,
    dir: PathBuf,
}

impl Stop {
    /// Listens from now on, for a run in `dir`. A file that an earlier run has left there is removed.
    ///
    /// # Errors
    /// If the system refuses.
    pub fn listen(dir: &Path) -> Result<Self, Failure> {
        let signal = Arc::new(AtomicBool::new(false));
        for number in [SIGINT, SIGTERM] {
            // In this order: the first signal sets the mark, the second, which finds it set, ends the program.
            flag::register_conditional_shutdown(number, 1, Arc::clone(&signal))?;
            flag::register(number, Arc::clone(&signal))?;
        }
        let stop = Self { signal, file: dir.join("stop") };
        let _ = stop.take_file();
        Ok(stop)
    }

    /// Whether the end has been asked for since. The file is removed: it has been heard.
    pub fn asked(&self) -> Option<Asked> {
        if self.signal.load(Ordering::Relaxed) {
            return Some(Asked::Signal);
        }
        self.take_file().then_some(Asked::File)
    }

    /// What a run says that ends at this time \[s\].
    pub fn stopped(&self, by: Asked, time: f64) -> Stopped {
        Stopped { by, time, dir: self.file.parent().unwrap_or(Path::new(".")).to_path_buf() }
    }

    /// One call to the system: asked before every step, it must cost nothing.
    fn take_file(&self) -> bool {
        std::fs::remove_file(&self.file).is_ok()
    }
}
