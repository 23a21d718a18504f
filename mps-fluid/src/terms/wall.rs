//! The state a boundary point shows to one fluid particle.

use super::Guard;
use crate::Boundary;
use crate::rates::State;
use mps_kernel::operators::ConservativeGradient;
use mps_kernel::{Pair, Real, Vector};

/// The least density a point shows, over that of the particle.
const THINNEST: f64 = 0.5;

/// Everything the pair (fluid particle, boundary point) needs besides the two of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WallPair<T: Real, const D: usize> {
    /// Acceleration of gravity \[m/s^2\].
    pub(crate) gravity: Vector<T, D>,
    /// Reference density \[kg/m^3\].
    pub(crate) rho0: T,
    /// `1/(rho0 c^2)` \[1/Pa\].
    pub(crate) compressibility: T,
    /// Whether pressures below zero become zero.
    pub(crate) clip: bool,
    /// What keeps spray from passing between the points.
    pub(crate) guard: Guard<T>,
}

impl<T: Real, const D: usize> WallPair<T, D> {
    /// Pressure and density ratio the point shows: `p_a = p_i + rho0 (g - a_a) . r_ia` with the
    /// acceleration `a_a` of the point, and the density that belongs to it.
    ///
    /// Zhang et al. (eq. 17) drop the difference where it is negative; beside a vertical wall that
    /// adds half of `rho0 g re` that is not there, and for a vibrating structure it rectifies noise.
    ///
    /// Where pressures below zero become zero, the difference is held between `-p_i` and `p_i`:
    /// the lower side because the wall does not pull, the upper one because the points of a
    /// vertical wall above and below a falling particle must stay a balance. With the lower side
    /// alone a particle without pressure feels the points below it and not those above, and the
    /// wall carries its weight.
    ///
    /// The equation of state is linear over the small difference; the error is of fourth order in
    /// the Mach number. Under a wall that is torn away the difference is not small, and a straight line goes on below no density at all:
    /// the point shows half of the particle's density at least, whatever the pressure. Its force stays finite so, and grows with the
    /// acceleration of the wall.
    #[inline(always)]
    pub(crate) fn state(&self, pi: T, ni: T, acceleration: &Vector<T, D>, r_ia: &Vector<T, D>) -> (T, T) {
        let rise = self.rho0 * (self.gravity - acceleration).dot(r_ia);
        let rise = if self.clip { rise.max(-pi).min(pi) } else { rise };
        let pa = pi + rise;
        (pa, (ni + (pa - pi) * self.compressibility).max(ni * T::of(THINNEST)))
    }

    /// The pair's share of the sum of eq. 24, so that the force on the fluid particle is
    /// `-V (D/n0)` times it and the force on the point `pair.j` the exact opposite. The pair is seen
    /// from the fluid particle, whose pressure is `pi` and whose other fields are `own`.
    #[inline(always)]
    pub(crate) fn pressure_sum(
        &self,
        pi: T,
        own: &State<T, D>,
        boundary: &Boundary<T, D>,
        pair: &Pair<T, D>,
    ) -> Vector<T, D> {
        let a = pair.j;
        let (pa, na) = self.state(pi, own.density, &boundary.acceleration[a], &pair.r_ij);
        let pressure = ConservativeGradient::pair_pressure(own.share, own.density, pa / na, na);
        pair.r_ij * (pressure * pair.over_r2 * boundary.volume[a] + self.guard.share(pair))
    }
}
