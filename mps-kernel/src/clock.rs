//! Time that many small steps add up to.

use crate::{Real, Transfer};

/// A time \[s\], and what rounding has taken off the steps that led to it (Kahan 1965, Commun. ACM 8:40): in single precision a thousand seconds of steps of a
/// microsecond would else stand still, and steps of the same length be all rounded to the same side.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Clock<T> {
    now: T,
    owed: T,
}

impl<T: Real> Clock<T> {
    /// The time \[s\].
    pub fn now(self) -> T {
        self.now
    }

    /// The clock `dt` \[s\] later.
    #[must_use]
    pub fn after(self, dt: T) -> Self {
        let step = dt + self.owed;
        let now = self.now + step;
        Self { now, owed: step - (now - self.now) }
    }

    /// Saves it or restores it.
    pub fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        transfer.value("now", &mut self.now);
        transfer.value("owed", &mut self.owed);
    }
}

#[cfg(test)]
mod tests {
    use super::Clock;

    #[test]
    fn many_small_steps_are_not_lost() {
        let (mut clock, mut plain) = (Clock::<f32>::default(), 0.0_f32);
        for _ in 0..2_000_000 {
            (clock, plain) = (clock.after(1e-5), plain + 1e-5);
        }
        assert!((clock.now() - 20.0).abs() < 4e-6, "{}", clock.now());
        assert!((plain - 20.0).abs() > 0.5, "which they are without: {plain}");
    }
}
