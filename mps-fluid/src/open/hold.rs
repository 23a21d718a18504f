//! What outlets do in a step: they prescribe the pressure, and take the forces off what is leaving.

use super::{OpenBoundaries, Opening};
use crate::Fluid;
use crate::eos::EquationOfState;
use crate::terms::Viscosity;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Domain, Parallel};

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Finds the pressure beyond the outlets and takes the forces off the particles there: they go on with the speed at which they
    /// crossed the plane, and what the mean speed at the plane has changed by since.
    pub(crate) fn hold_outlets(&mut self, parallel: &Parallel) {
        let slab = self.slab();
        let Some(open) = &mut self.open else { return };
        let (position, velocity) = (&self.particles.position, &self.particles.velocity);
        let area = open.outlets.iter().fold(T::zero(), |area, outlet| area + outlet.opening.area());
        let expected = open.inflow / area;
        for (k, outlet) in open.outlets.iter().enumerate() {
            let speed = speed_at_plane(parallel, &outlet.opening, slab, position, velocity);
            let excess = match speed {
                Some(speed) if outlet.absorbing => speed - expected,
                _ => T::zero(),
            };
            let impedance = self.config.density * self.config.sound_speed;
            open.beyond[k] = self.eos.density(outlet.pressure + impedance * excess);
            let change = match (speed, open.speed[k]) {
                (Some(now), Some(before)) if self.last_dt > T::zero() => (now - before) / self.last_dt,
                _ => T::zero(),
            };
            open.speed[k] = speed;
            parallel.update(self.rates.acceleration.as_mut_slice(), |i, a| {
                if outlet.holds(&position[i]) {
                    *a = Vector::zeros();
                    a[outlet.opening.axis] = outlet.opening.along(change);
                }
            });
        }
    }

    /// Gives the particles beyond the outlets the density they are to have after `dt` \[s\].
    pub(crate) fn hold_densities(&mut self, parallel: &Parallel, dt: T) {
        let Some(open) = &self.open else { return };
        let (position, density) = (&self.particles.position, &self.particles.density);
        parallel.update(self.rates.density_rate.as_mut_slice(), |i, rate| {
            if let Some(n) = open.held(&position[i]) {
                *rate = (n - density[i]) / dt;
            }
        });
    }

    /// Whether particle `i` is beyond an outlet.
    pub(crate) fn is_leaving(&self, i: usize) -> bool {
        let place = &self.particles.position[i];
        self.open.as_ref().is_some_and(|open| open.outlets.iter().any(|outlet| outlet.holds(place)))
    }
}

impl<T: Real, const D: usize> OpenBoundaries<T, D> {
    /// The density ratio that a particle at `place` is given, if that is beyond an outlet.
    pub(crate) fn held(&self, place: &Vector<T, D>) -> Option<T> {
        let mut outlets = self.outlets.iter().zip(&self.beyond);
        outlets.find(|(outlet, _)| outlet.holds(place)).map(|(_, n)| *n)
    }
}

/// Mean speed through the plane of an opening \[m/s\]: the line of least squares through the particles up to `slab` \[m\] before it, at
/// the plane. (The mean over the slab is what it was when the sound was there; the delay would send a part of it back.)
pub(super) fn speed_at_plane<T: Real, const D: usize>(
    parallel: &Parallel,
    opening: &Opening<T, D>,
    slab: T,
    position: &[Vector<T, D>],
    velocity: &[Vector<T, D>],
) -> Option<T> {
    let moments = |i: usize| {
        let x = opening.beyond(&position[i]);
        let u = opening.along(velocity[i][opening.axis]);
        if x <= T::zero() && x > -slab { [T::one(), x, x * x, u, x * u] } else { [T::zero(); 5] }
    };
    let add = |a: [T; 5], b: [T; 5]| core::array::from_fn(|k| a[k] + b[k]);
    let [n, x, xx, u, xu] = parallel.fold(position.len(), [T::zero(); 5], &moments, &add);
    let spread = n * xx - x * x;
    (spread > T::zero()).then(|| (xx * u - x * xu) / spread)
}
