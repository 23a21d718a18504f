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
/// with its reaction; what it stores shows in the books as work of the walls. (Amaro et al. 2022 use a Lennard-Jones force between particles and walls for the same purpose.)
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

#[cfg(test)]
mod tests {
    use super::*;
    use mps_kernel::Vector;

    /// What a particle has to bring to reach a point: `c^2/6`, however fine the water.
    #[test]
    fn the_guard_stops_what_is_slower_than_its_potential() {
        let factor = 3.7;
        for l0 in [0.01, 0.5] {
            let config = FluidConfig::<f64, 2>::water(l0, 12.0);
            let guard = Guard::new(&config, factor);
            let acceleration = |r: f64| {
                let r_ij = Vector::from([r, 0.0]);
                let pair = Pair { j: 0, r_ij, r2: r * r, weight: 1.0, over_r2: 1.0 };
                guard.share(&pair) * r * factor / config.density
            };
            let steps = 10_000;
            let dr = l0 / f64::from(steps);
            let work: f64 = (0..steps).map(|k| acceleration((f64::from(k) + 0.5) * dr) * dr).sum();
            approx::assert_relative_eq!(work, 12.0 * 12.0 / 6.0, max_relative = 1e-6);
            assert_eq!(acceleration(0.5 * l0), 0.0);
        }
    }
}
