//! Where fluid enters.

use super::Opening;
use crate::{Boundary, FluidError, Shear, Slip};
use core::fmt;
use core::ops::Range;
use mps_kernel::{Real, Vector};

/// Speed \[m/s\] of the inflow, in its direction, at a place \[m\] and a time \[s\].
pub(crate) type Speed<T, const D: usize> = dyn Fn(&Vector<T, D>, T) -> T + Send + Sync;

/// An opening through which fluid enters with a prescribed speed, normal to its plane.
pub struct Inlet<T: Real, const D: usize> {
    pub(crate) opening: Opening<T, D>,
    speed: Box<Speed<T, D>>,
    /// Its points among those of the boundary.
    range: Range<usize>,
    /// Length of the stack of points \[m\].
    pub(crate) length: T,
}

impl<T: Real, const D: usize> fmt::Debug for Inlet<T, D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Inlet").field("opening", &self.opening).finish_non_exhaustive()
    }
}

impl<T: Real, const D: usize> Inlet<T, D> {
    /// For the opening and its speed \[m/s\], a function of place \[m\] and time \[s\]: not negative, and constant in time or
    /// changing slowly against the time step.
    pub fn new(
        opening: Opening<T, D>,
        speed: impl Fn(&Vector<T, D>, T) -> T + Send + Sync + 'static,
    ) -> Self {
        Self { opening, speed: Box::new(speed), range: 0..0, length: T::zero() }
    }

    /// Adds the stack of points, as deep as the effective radius and a spare spacing.
    pub(crate) fn install(
        &mut self,
        boundary: &mut Boundary<T, D>,
        spacing: T,
        radius: T,
    ) -> Result<(), FluidError> {
        self.opening.check(spacing)?;
        let layers = (radius / spacing).ceil().to_double() as usize + 1;
        let half = |layer: usize| T::of(layer as f64 + 0.5) * spacing;
        let points: Vec<_> =
            (0..layers).flat_map(|layer| self.opening.lattice(spacing, -half(layer))).collect();
        let Some(range) = boundary.add_wall(&points, Slip::None) else {
            return Err(FluidError::Opening { what: "inlets have to be added before structures".to_owned() });
        };
        // The flow goes on undisturbed behind the plane: nothing is mirrored.
        boundary.shear[range.clone()].fill(Shear::Fluid);
        self.range = range;
        self.length = T::of(layers as f64) * spacing;
        Ok(())
    }

    /// Gives the points the speed of `time` \[s\] and the acceleration until `dt` \[s\] later. Returns the flux \[m^D/s\].
    pub(crate) fn drive(&self, boundary: &mut Boundary<T, D>, time: T, dt: T) -> Result<T, FluidError> {
        let mut sum = T::zero();
        for a in self.range.clone() {
            let place = boundary.position[a];
            let (now, soon) = ((self.speed)(&place, time), (self.speed)(&place, time + dt));
            if !(now >= T::zero() && now.is_finite()) {
                return Err(FluidError::Inflow {
                    speed: now.to_double(),
                    time: time.to_double(),
                    place: place.iter().map(|x| x.to_double()).collect(),
                });
            }
            boundary.velocity[a][self.opening.axis] = self.opening.along(now);
            boundary.acceleration[a][self.opening.axis] = self.opening.along((soon - now) / dt);
            sum += now;
        }
        Ok(sum / T::of(self.range.len() as f64) * self.opening.area())
    }

    /// Moves the points by `dt` \[s\].
    pub(crate) fn advance(&self, boundary: &mut Boundary<T, D>, dt: T) {
        for a in self.range.clone() {
            let step = boundary.velocity[a] * dt;
            boundary.position[a] += step;
        }
    }

    /// Calls `born` with position and velocity of every point that has crossed the plane, and puts it to the rear.
    pub(crate) fn release(
        &self,
        boundary: &mut Boundary<T, D>,
        mut born: impl FnMut(Vector<T, D>, Vector<T, D>),
    ) {
        for a in self.range.clone() {
            if self.opening.beyond(&boundary.position[a]) > T::zero() {
                born(boundary.position[a], boundary.velocity[a]);
                boundary.position[a][self.opening.axis] -= self.opening.along(self.length);
            }
        }
    }
}
