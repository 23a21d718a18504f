//! When something is to happen in a time loop whose steps have no fixed length.

use mps_kernel::Transfer;

/// What rounding may take from a time that is a whole number of intervals, over the interval.
const ROUNDING: f64 = 1e-9;

/// Something that is to happen at regular simulated times, from the start on.
#[derive(Clone, Copy, Debug)]
pub struct Due {
    interval: f64,
    next: f64,
}

impl Due {
    /// Every `interval` \[s\].
    pub fn every(interval: f64) -> Self {
        Self { interval, next: 0.0 }
    }

    /// At no time.
    pub fn never() -> Self {
        Self { interval: f64::INFINITY, next: f64::INFINITY }
    }

    /// Saves or restores when it happens next.
    pub fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { interval: _, next } = self;
        transfer.value("due", next);
    }

    /// Whether its time has come.
    pub fn has_come(&self, time: f64) -> bool {
        time >= self.next - self.slack()
    }

    /// Without an interval there is none, also of infinity.
    fn slack(&self) -> f64 {
        if self.interval.is_finite() { ROUNDING * self.interval } else { 0.0 }
    }

    /// Whether it is to happen now; if so, it will be due again an interval later.
    pub fn is_due(&mut self, time: f64) -> bool {
        let due = self.has_come(time);
        if due {
            self.next = ((time / self.interval + ROUNDING).floor() + 1.0) * self.interval;
        }
        due
    }
}

/// Single moments, in ascending order, at each of which something is to happen once.
#[derive(Clone, Debug)]
pub struct Moments {
    left: std::vec::IntoIter<f64>,
    next: Option<f64>,
}

impl Moments {
    /// At each of `times` \[s\].
    pub fn at(times: Vec<f64>) -> Self {
        let mut left = times.into_iter();
        Self { next: left.next(), left }
    }

    /// The moment that is due now, if any. Several within one step are due in one after the other.
    pub fn due(&mut self, time: f64) -> Option<f64> {
        let due = self.next.filter(|moment| time >= *moment)?;
        self.next = self.left.next();
        Some(due)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regular_events_keep_to_their_grid_whatever_the_steps() {
        let mut due = Due::every(0.1);
        let happened: Vec<f64> =
            [0.0, 0.03, 0.11, 0.19, 0.45, 0.46, 0.5].into_iter().filter(|time| due.is_due(*time)).collect();
        assert_eq!(happened, [0.0, 0.11, 0.45, 0.5]);
    }

    /// Rows of a run of 0.3 s: eight of them make a frame, however both times are rounded.
    #[test]
    fn what_is_rounded_is_due_neither_twice_nor_a_row_late() {
        for end in [0.1, 0.3, 0.8, 1.0, 1.7] {
            let (mut due, row) = (Due::every(end / 100.0), end / 800.0);
            let rows: Vec<u32> = (0..=800).filter(|k| due.is_due(f64::from(*k) * row)).collect();
            assert_eq!(rows, (0..=100).map(|k| 8 * k).collect::<Vec<_>>(), "{end}");
        }
        assert!(!Due::never().is_due(1e300));
    }

    #[test]
    fn every_moment_is_due_once() {
        let mut moments = Moments::at(vec![0.0, 0.2, 0.25]);
        let steps = [0.0, 0.1, 0.3, 0.35, 0.4];
        let happened: Vec<Option<f64>> = steps.into_iter().map(|time| moments.due(time)).collect();
        assert_eq!(happened, [Some(0.0), None, Some(0.2), Some(0.25), None]);
    }
}
