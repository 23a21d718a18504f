//! Where fluid leaves.

use super::Opening;
use mps_kernel::{Real, Vector};

/// An opening through which fluid leaves, at a prescribed pressure.
#[derive(Clone, Debug, PartialEq)]
pub struct Outlet<T: Real, const D: usize> {
    /// Where.
    pub opening: Opening<T, D>,
    /// Pressure beyond its plane \[Pa\].
    pub pressure: T,
    /// Whether sound goes out through it, or is reflected. The pressure is then `rho0 c` times the mean speed at the plane beyond the one
    /// that belongs to the inflow: what all inlets bring, shared by the outlets in proportion to their areas, zero without inlets.
    pub absorbing: bool,
}

impl<T: Real, const D: usize> Outlet<T, D> {
    /// An outlet that absorbs sound, at pressure zero.
    pub fn absorbing(opening: Opening<T, D>) -> Self {
        Self { opening, pressure: T::zero(), absorbing: true }
    }

    /// Whether a particle is beyond the plane.
    #[inline]
    pub(crate) fn holds(&self, place: &Vector<T, D>) -> bool {
        self.opening.beyond(place) > T::zero()
    }

    /// Whether a particle is to be taken out: `depth` \[m\] beyond the plane, or beyond it and beside the opening.
    pub(crate) fn drops(&self, place: &Vector<T, D>, depth: T) -> bool {
        let beyond = self.opening.beyond(place);
        let beside =
            |side: usize| place[side] < self.opening.lower[side] || place[side] > self.opening.upper[side];
        beyond > depth || beyond > T::zero() && self.opening.sides().any(beside)
    }
}
