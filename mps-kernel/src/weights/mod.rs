//! Weights `W(r, re)` of the moving particle semi-implicit method, one formula a file.
//!
//! | weight | formula (q = r/re) | at r = 0 | used by |
//! |---|---|---|---|
//! | [`Rational`] | 1/q - 1 | singular | paper's fluid (eq. 12), Koshizuka and Oka 1996 |
//! | [`WendlandC2`] | (1-q)^4 (1+4q) | 1 | solid, Riemann SPH relatives |
//! | [`WendlandGradient`] | q^2 (1-q)^3 | 0 | smooth flows; as smoothed particles with the C2 function |
//! | [`Spiky`] | (1-q)^3 | 1 | Jandaghian and Shakibaeinia 2020 |
//! | [`Gaussian`] | exp(-9 q^2), cut at q = 1 | 1 | nonlocal (peridynamic) relatives |
//!
//! Every weight is zero for `r >= re` and positive in between, and `W/r^2` decreases: pinned, with the
//! bounded value at `r = 0`, by `tests/properties/weights.rs`.

mod gaussian;
mod rational;
mod spiky;
mod wendland;
mod wendland_gradient;

pub use gaussian::Gaussian;
pub use rational::Rational;
pub use spiky::Spiky;
pub use wendland::WendlandC2;
pub use wendland_gradient::WendlandGradient;

use crate::{Number, Real};

/// A weight `W(r, re)` with the effective radius `re` as its support.
///
/// The formula is written for any [`Number`], so that a sweep can evaluate several pairs at once.
pub trait Kernel<T: Real>: Copy + Send + Sync {
    /// Weight of a pair at distance `r` \[m\] for the effective radius `re` \[m\].
    ///
    /// Zero for `r >= re`. `r` must be positive; callers bound it by [`closest`].
    fn weight<N: Number<T>>(&self, r: N, re: T) -> N;

    /// The weight `W` and `W / r^2` from the squared distance `r2` \[m^2\].
    ///
    /// Both are exactly zero where `r2 >= re * re` as rounded, the test neighbour lists make.
    ///
    /// Sweeps call this form once per pair; a weight overrides it where its formula saves a
    /// division or a square root.
    #[inline(always)]
    fn weight_and_over_r2<N: Number<T>>(&self, r2: N, re: T) -> (N, N) {
        let weight = self.weight(r2.root(), re);
        (weight, weight / r2)
    }

    /// Name for summaries and plots.
    fn name(&self) -> &'static str;
}

/// Smallest distance \[m\] a weight is evaluated at: `re / 30`, a tenth of the spacing for `re = 3 l0`.
///
/// Below it the weights stay constant, so that the force between two particles that meet is bounded
/// instead of NaN. It even fades, in proportion to the distance, because a direction does not exist at
/// zero: what parts them again is a collision model. Regular flows never come near it.
#[inline(always)]
pub fn closest<T: Real>(re: T) -> T {
    re * T::of(1.0 / 30.0)
}
