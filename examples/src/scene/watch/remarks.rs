//! What is to be said about a run that goes on.

use super::alarm::Alarm;
use mps_kernel::Transfer;

/// Remarks for the summary.
#[derive(Clone, Debug, Default)]
pub(super) struct Remarks {
    /// A line each.
    pub(super) lines: String,
    /// Whether it has been said that the fluid is too fast for its speed of sound: once is enough.
    pub(super) too_fast: bool,
}

impl Remarks {
    /// Says in log and summary that the fluid is too fast.
    pub(super) fn warn(&mut self, warning: &Alarm) {
        tracing::warn!("{warning}");
        self.lines += &format!("{warning}\n");
        self.too_fast = true;
    }

    pub(super) fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { lines, too_fast } = self;
        let mut bytes = core::mem::take(lines).into_bytes();
        transfer.list("passed", &mut bytes);
        *lines = String::from_utf8_lossy(&bytes).into_owned();
        transfer.flag("too fast", too_fast);
    }
}
