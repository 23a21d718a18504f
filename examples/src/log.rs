//! The log of a run: `run.log` beside its results, one event a line, with time, level, place and `key=value` pairs.
//!
//! The libraries print and log nothing; what is logged is what programs do and see.

use crate::Failure;
use clap::ValueEnum;
use std::fs::OpenOptions;
use std::path::Path;
use std::sync::Mutex;
use tracing::level_filters::LevelFilter;

/// How much is logged; each level has what the ones before it have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum LogLevel {
    /// No log
    Off,
    /// What broke the run off
    Error,
    /// What ended it early
    Warn,
    /// Beginning, every tenth of the run, checkpoints, end
    #[default]
    Info,
    /// Every hundredth of the run, and what was written
    Debug,
    /// Every step
    Trace,
}

impl From<LogLevel> for LevelFilter {
    fn from(level: LogLevel) -> Self {
        match level {
            LogLevel::Off => Self::OFF,
            LogLevel::Error => Self::ERROR,
            LogLevel::Warn => Self::WARN,
            LogLevel::Info => Self::INFO,
            LogLevel::Debug => Self::DEBUG,
            LogLevel::Trace => Self::TRACE,
        }
    }
}

/// Lets events go to `run.log` in `dir` from now on; behind what is there if the run `resumes`.
///
/// A process has one log: of several runs in one process, as of a comparison of resolutions, all go to the first.
pub(crate) fn begin(dir: &Path, level: LogLevel, resumes: bool) -> Result<(), Failure> {
    if level == LogLevel::Off || tracing::dispatcher::has_been_set() {
        return Ok(());
    }
    let path = dir.join("run.log");
    let open = OpenOptions::new().create(true).write(true).append(resumes).truncate(!resumes).open(&path);
    let file =
        open.map_err(|error| format!("cannot write the log {}: {error}. Use --log off", path.display()))?;
    let subscriber = tracing_subscriber::fmt()
        .with_max_level(LevelFilter::from(level))
        .with_ansi(false)
        .with_writer(Mutex::new(file))
        .finish();
    // Lost only if another thread was faster.
    let _ = tracing::subscriber::set_global_default(subscriber);
    Ok(())
}
