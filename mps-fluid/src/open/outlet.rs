//! Where fluid leaves.

use super::Opening;
use mps_kernel::{Real, Vector};

/// An opening through which fluid leaves, at a prescribed pressure.
#[derive(Clone, Debug, PartialEq)]
pub struct Outlet<T: Real, const D: usize> {
    /// Where.
    pub opening: Opening<T, D>,
    /// Pressure beyond its plane \[Pa\], at the middle of the opening: under gravity it is hydrostatic from there.
    pub pressure: T,
    /// Whether sound goes out through it, or is reflected. The pressure is then `rho0 c` times the mean speed at the plane beyond the one
    /// that belongs to the inflow: what all inlets bring, shared by the outlets in proportion to their areas, zero without inlets. So the flow
    /// through it is the one of the inlets, and its pressure is what that takes; where the flow follows from pressures it has to be off.
    pub absorbing: bool,
}

/// What an outlet has to do with a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reach {
    /// Nothing.
    Outside,
    /// The place is in its zone, the box beyond its plane.
    Zone,
    /// It is less than a spacing beside its zone or behind it: who is there has come through it.
    Rim,
}

impl<T: Real, const D: usize> Outlet<T, D> {
    /// An outlet that absorbs sound, at pressure zero.
    pub fn absorbing(opening: Opening<T, D>) -> Self {
        Self { opening, pressure: T::zero(), absorbing: true }
    }

    /// Where a place is, for a zone of this `depth` \[m\] and a rim of a `spacing` \[m\].
    #[inline]
    pub(crate) fn reach(&self, place: &Vector<T, D>, depth: T, spacing: T) -> Reach {
        let beyond = self.opening.beyond(place);
        // Most particles are before the plane.
        if !(beyond > T::zero() && beyond <= depth + spacing) {
            return Reach::Outside;
        }
        let beside = self.opening.beside(place);
        if beside > spacing {
            Reach::Outside
        } else if beyond <= depth && beside <= T::zero() {
            Reach::Zone
        } else {
            Reach::Rim
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_zone_is_a_box_with_a_rim() {
        let opening = Opening {
            axis: 0,
            at: 1.0,
            forward: true,
            lower: Vector::from([0.0, 0.0]),
            upper: Vector::from([0.0, 0.5]),
        };
        let outlet = Outlet::absorbing(opening);
        let at = |x: f64, y: f64| outlet.reach(&Vector::from([x, y]), 0.3, 0.1);
        assert_eq!([at(1.1, 0.2), at(1.29, 0.5)], [Reach::Zone; 2]);
        assert_eq!([at(1.35, 0.2), at(1.1, 0.55), at(1.1, -0.05)], [Reach::Rim; 3]);
        // Before the plane, and whatever else there is behind it.
        assert_eq!([at(0.9, 0.2), at(1.5, 0.2), at(1.1, 0.7), at(1.1, -0.2)], [Reach::Outside; 4]);
    }
}
