//! Time that many small steps add up to.

use crate::{Real, Transfer};
use core::ops::{Add, Sub};

/// `sum + part`, and in `remainder` what rounding takes off it, which comes along with the next part (Kahan 1965, Commun. ACM 8:40). All in the unit of
/// the sum.
#[inline]
pub fn add_carrying<V: Copy + Add<Output = V> + Sub<Output = V>>(sum: V, part: V, remainder: &mut V) -> V {
    let part = part + *remainder;
    let next = sum + part;
    *remainder = part - (next - sum);
    next
}

/// A time \[s\], and what rounding has taken off the steps that led to it ([`add_carrying`]): in single precision a thousand seconds of steps of a
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
    pub fn after(mut self, dt: T) -> Self {
        self.now = add_carrying(self.now, dt, &mut self.owed);
        self
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
