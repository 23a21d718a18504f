//! Where fluid passes.

use crate::FluidError;
use mps_kernel::{Real, Vector};

/// A flat opening across one axis, with the direction in which the fluid passes.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening<T: Real, const D: usize> {
    /// The axis across which it lies.
    pub axis: usize,
    /// Its place on that axis \[m\].
    pub at: T,
    /// Whether the fluid passes in the direction of the axis, or against it.
    pub forward: bool,
    /// Its lower corner \[m\]; the component along `axis` does not matter.
    pub lower: Vector<T, D>,
    /// Its upper corner \[m\].
    pub upper: Vector<T, D>,
}

impl<T: Real, const D: usize> Opening<T, D> {
    /// How far downstream of the plane a place is \[m\].
    pub fn beyond(&self, place: &Vector<T, D>) -> T {
        self.along(place[self.axis] - self.at)
    }

    /// How far a place is beside the opening \[m\], not more than zero if it is before or behind it.
    pub(crate) fn beside(&self, place: &Vector<T, D>) -> T {
        let past = |side: usize| (self.lower[side] - place[side]).max(place[side] - self.upper[side]);
        self.sides().map(past).fold(-T::of(f64::INFINITY), T::max)
    }

    /// Its middle \[m\].
    pub(crate) fn middle(&self) -> Vector<T, D> {
        let mut middle = (self.lower + self.upper) * T::of(0.5);
        middle[self.axis] = self.at;
        middle
    }

    /// A component along the axis, counted in the direction of the flow.
    pub(crate) fn along(&self, component: T) -> T {
        if self.forward { component } else { -component }
    }

    /// The other axes.
    pub(crate) fn sides(&self) -> impl Iterator<Item = usize> + use<T, D> {
        let axis = self.axis;
        (0..D).filter(move |side| *side != axis)
    }

    /// Its area \[m^(D-1)\].
    pub fn area(&self) -> T {
        self.sides().fold(T::one(), |area, side| area * (self.upper[side] - self.lower[side]))
    }

    /// Cell centres of a lattice over it, `depth` \[m\] downstream of the plane.
    pub(crate) fn lattice(&self, spacing: T, depth: T) -> Vec<Vector<T, D>> {
        let count =
            |side: usize| ((self.upper[side] - self.lower[side]) / spacing).round().to_double() as usize;
        let mut places = vec![Vector::<T, D>::zeros()];
        for axis in 0..D {
            let along: Vec<T> = if axis == self.axis {
                vec![self.at + self.along(depth)]
            } else {
                let half = |k: usize| T::of(k as f64 + 0.5);
                (0..count(axis)).map(|k| self.lower[axis] + half(k) * spacing).collect()
            };
            places = along
                .iter()
                .flat_map(|x| {
                    places.iter().map(move |place| {
                        let mut place = *place;
                        place[axis] = *x;
                        place
                    })
                })
                .collect();
        }
        places
    }

    /// Refuses what no lattice fits.
    pub(crate) fn check(&self, spacing: T) -> Result<(), FluidError> {
        let refuse = |what: String| Err(FluidError::Opening { what });
        if self.axis >= D {
            return refuse(format!("axis {} does not exist in {D} dimensions", self.axis));
        }
        if !self.at.is_finite() {
            return refuse(format!("its place {} is not a number", self.at.to_double()));
        }
        for side in self.sides() {
            let cells = ((self.upper[side] - self.lower[side]) / spacing).to_double();
            if !(cells.round() >= 1.0 && (cells - cells.round()).abs() < 0.01) {
                return refuse(format!(
                    "along axis {side} it is {cells} particle spacings wide: give a whole number of at least 1"
                ));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn window() -> Opening<f64, 3> {
        Opening {
            axis: 1,
            at: 2.0,
            forward: false,
            lower: Vector::from([0.0, 0.0, -0.1]),
            upper: Vector::from([0.4, 0.0, 0.1]),
        }
    }

    #[test]
    fn the_lattice_fills_the_opening_on_the_side_asked_for() {
        let places = window().lattice(0.1, -0.05);
        assert_eq!(places.len(), 8);
        assert!(
            places.iter().all(|p| (p[1] - 2.05).abs() < 1e-12 && (window().beyond(p) + 0.05).abs() < 1e-12)
        );
        assert!(places.iter().any(|p| (p - Vector::from([0.35, 2.05, 0.05])).norm() < 1e-12));
        assert!((window().area() - 0.08).abs() < 1e-12);
    }

    #[test]
    fn what_no_lattice_fits_is_refused() {
        assert!(window().check(0.1).is_ok());
        assert!(window().check(0.03).is_err());
        assert!(Opening { axis: 3, ..window() }.check(0.1).is_err());
        assert!(Opening { at: f64::NAN, ..window() }.check(0.1).is_err());
        assert!(Opening { upper: Vector::from([-0.4, 0.0, 0.1]), ..window() }.check(0.1).is_err());
    }
}
