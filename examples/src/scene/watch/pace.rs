//! Shorter steps after a failure, and when they end.

use mps_io::scene_file::{OnFailure, Retry};
use mps_kernel::Transfer;

/// How a run goes at present.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Pace {
    /// How often the Courant number is halved.
    pub(super) halvings: u32,
    /// Sub-steps of bodies at least.
    pub(super) substeps: u64,
    /// Steps done when this ends.
    pub(super) until: u64,
    /// Failures so far from which the run has gone back.
    pub(super) tries: u32,
}

/// A failure as it concerns the pace.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setback {
    /// Steps done when the step failed.
    pub(super) failed: u64,
    /// Steps done where the run begins again.
    pub(super) from: u64,
    /// Sub-steps of bodies in the step that failed.
    pub(super) substeps: u64,
    /// Steps that take the place of one when they are halved: 2; 1 for bodies alone, where a step is a row of the table whatever its sub-steps.
    pub(super) steps_for_one: u64,
}

impl Pace {
    /// The pace after one more failure; `None` if the run is to stop.
    pub(super) fn after(self, setback: Setback, on_failure: OnFailure) -> Option<Self> {
        let OnFailure::Retry(Retry { steps, times }) = on_failure else { return None };
        if self.tries >= times {
            return None;
        }
        let halvings = self.halvings + 1;
        // In half the step a fluid takes twice as many to where it failed.
        let way = setback.steps_for_one * (setback.failed + 1 - setback.from);
        Some(Self {
            halvings,
            // The first failure says how many there were at full length.
            substeps: if self.halvings == 0 { setback.substeps.max(1) } else { self.substeps },
            until: setback.from + way + u64::from(steps),
            tries: self.tries + 1,
        })
    }

    /// Whether steps are shorter than usual.
    pub(super) fn is_slow(&self) -> bool {
        self.halvings > 0
    }

    /// Back to the usual length of steps; tries count for the whole run.
    pub(super) fn recovered(self) -> Self {
        Self { tries: self.tries, ..Self::default() }
    }

    pub(super) fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { halvings, substeps, until, tries } = self;
        transfer.value("halvings", halvings);
        transfer.value("least sub-steps", substeps);
        transfer.value("slow until", until);
        transfer.value("tries", tries);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWICE: OnFailure = OnFailure::Retry(Retry { steps: 200, times: 2 });

    #[test]
    fn a_run_slows_down_twice_and_then_stops() {
        let failure = Setback { failed: 119, from: 50, substeps: 7, steps_for_one: 2 };
        assert_eq!(Pace::default().after(failure, OnFailure::Stop), None);
        let first = Pace::default().after(failure, TWICE).unwrap_or_default();
        assert_eq!(first, Pace { halvings: 1, substeps: 7, until: 50 + 140 + 200, tries: 1 });
        // It comes as far in twice as many steps, and fails there again.
        let again = Setback { failed: 189, from: 50, substeps: 9, steps_for_one: 2 };
        let second = first.after(again, TWICE).unwrap_or_default();
        assert_eq!(second, Pace { halvings: 2, substeps: 7, until: 50 + 280 + 200, tries: 2 });
        assert_eq!(second.after(again, TWICE), None);
        // For bodies alone it is as many rows as before.
        let rows = Pace::default().after(Setback { steps_for_one: 1, ..failure }, TWICE).unwrap_or_default();
        assert_eq!(rows.until, 50 + 70 + 200);
        assert_eq!(second.recovered(), Pace { tries: 2, ..Pace::default() });
    }
}
