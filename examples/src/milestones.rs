//! What the log says of a run that goes on.

use crate::Failure;
use crate::stop::Stopped;
use std::fmt::Display;
use std::time::Duration;

/// How far the log has got.
pub(crate) struct Milestones {
    end: f64,
    /// Hundredths of the run that are over.
    passed: u64,
    /// What measuring, drawing and writing have taken.
    looking: Duration,
}

impl Milestones {
    /// A run that goes from this time \[s\] to that.
    pub(crate) fn begin(from: f64, end: f64) -> Self {
        tracing::info!(from, end, version = env!("CARGO_PKG_VERSION"), "begins");
        Self { end, passed: hundredths(from, end), looking: Duration::ZERO }
    }

    /// What one look has taken.
    pub(crate) fn looked(&mut self, taken: Duration) {
        self.looking += taken;
    }

    /// Time \[s\] and length \[s\] of a step that was made.
    pub(crate) fn pass(&mut self, time: f64, steps: u64, dt: f64, remark: impl Display) {
        tracing::trace!(time, steps, dt, "step");
        let now = hundredths(time, self.end);
        if now / 10 > self.passed / 10 {
            tracing::info!(percent = now, time, steps, dt, %remark, "on its way");
        } else if now > self.passed {
            tracing::debug!(percent = now, time, steps, dt, %remark, "on its way");
        }
        self.passed = now;
    }

    /// How it ended, after `stepping` \[s\] of steps.
    pub(crate) fn end(&self, time: f64, steps: u64, stepping: f64, failure: Option<&Failure>) {
        let looking = self.looking.as_secs_f64();
        match failure {
            None => tracing::info!(time, steps, stepping, looking, "completed"),
            Some(stopped) if is_stopped(stopped) => {
                tracing::warn!(time, steps, stepping, looking, "{stopped}")
            }
            Some(failure) => tracing::error!(time, steps, stepping, looking, "{failure}"),
        }
    }
}

/// Whether it ended because somebody wanted it to.
fn is_stopped(failure: &Failure) -> bool {
    failure.is::<Stopped>() || crate::scene::is_stopped(failure)
}

fn hundredths(time: f64, end: f64) -> u64 {
    (100.0 * time / end).clamp(0.0, 100.0) as u64
}
