//! A guard against spray that passes between the points of a wall.

use crate::FluidConfig;
use mps_kernel::{Pair, Real};

/// Reach in spacings. A particle at rest at a wall is half a spacing from its surface, and the points lie behind that:
/// it never feels the guard.
const REACH: f64 = 0.5;

/// A repulsion between a fluid particle and a boundary point that are closer than they ever come in a body of water.
///
/// A particle that flies alone has no pressure until its density has grown, which the few pairs of a glancing or very
/// fast approach do not achieve in time. The acceleration
///
/// ```text
/// a = -(c^2/l0) (1 - r/R)^2 e_ia,   r < R = l0/2
/// ```
///
/// has the potential `c^2/6` at `r = 0` and stops a particle of up to `0.58 c`; its stiffness `4 c^2/l0^2` is
/// that of neighbouring particles, so that the time step needs no other limit. It is one more part of the pair force,
/// with its reaction. (Amaro et al. 2022 use a Lennard-Jones force between particles and walls for the same purpose.)
#[derive(Clone, Copy, Debug)]
pub(crate) struct Guard<T> {
    reach: T,
    /// `(c^2/l0) rho0/(D/n0)`, what the sum of eq. 24 has to contain.
    strength: T,
}

impl<T: Real> Guard<T> {
    /// For the sums that are multiplied by `factor`, `D/n0` \[-\].
    pub(crate) fn new<const D: usize>(config: &FluidConfig<T, D>, factor: T) -> Self {
        let strength = config.sound_speed * config.sound_speed / config.spacing * config.density / factor;
        Self { reach: config.spacing * T::of(REACH), strength }
    }

    /// The factor of `r_ia` in the sum of eq. 24.
    #[inline(always)]
    pub(crate) fn share<const D: usize>(&self, pair: &Pair<T, D>) -> T {
        if pair.r2 >= self.reach * self.reach {
            return T::zero();
        }
        let r = pair.distance();
        let depth = T::one() - r / self.reach;
        self.strength * depth * depth / r
    }
}
