//! What outlets do in a step: they prescribe the pressure, and take the forces off what is leaving.

use super::outlet::Reach;
use super::{OpenBoundaries, Opening};
use crate::Fluid;
use crate::eos::EquationOfState;
use crate::terms::Viscosity;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Domain, Parallel};

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Finds the pressure beyond the outlets and what the speeds at their planes have changed by, and takes the forces off the particles
    /// there. `again`: in this step this has been done before.
    pub(crate) fn hold_outlets(&mut self, parallel: &Parallel, again: bool) {
        let (slab, zone) = (self.slab(), self.zone());
        let Some(open) = &mut self.open else { return };
        let (position, velocity) = (&self.particles.position, &self.particles.velocity);
        let area = open.outlets.iter().fold(T::zero(), |area, outlet| area + outlet.opening.area());
        let expected = open.inflow / area;
        let begun = self.last_dt > T::zero();
        for (k, outlet) in open.outlets.iter().enumerate() {
            let speed = speed_at_plane(parallel, &outlet.opening, slab, position, velocity);
            let excess = match speed {
                Some(speed) if outlet.absorbing => speed - expected,
                _ => T::zero(),
            };
            let impedance = self.config.density * self.config.sound_speed;
            open.beyond[k] = outlet.pressure + impedance * excess;
            // Where nothing is before the plane, what is behind it goes on as it was.
            let now = speed.unwrap_or(open.speed[k]);
            // At the start the particles beyond have the velocities that they were given.
            let change = if begun { now - open.speed[k] } else { T::zero() };
            open.change[k] = if again { open.change[k] + change } else { change };
            open.speed[k] = now;
        }
        let (depth, spacing) = (zone, self.config.spacing);
        let mut leaving = core::mem::take(&mut open.leaving);
        leaving.clear();
        // One after the other: it is little more than a comparison a particle, and the list is in the order of the particles.
        let who = position.iter().enumerate();
        leaving.extend(who.filter_map(|(i, place)| Some((i, open.outlet_at(place, depth, spacing)?))));
        open.leaving = leaving;
        for (i, _) in &open.leaving {
            self.rates.acceleration[*i] = Vector::zeros();
        }
    }

    /// Lets the particles beyond the outlets go on with the speed at which they crossed the plane, and what the mean speed there has changed by
    /// since: an acceleration in a step of `dt` \[s\], in place of whatever else acts.
    pub(crate) fn follow_outlets(&mut self, dt: T) {
        let Some(open) = self.open.as_ref().filter(|_| dt > T::zero()) else { return };
        for (i, k) in &open.leaving {
            let opening = &open.outlets[*k].opening;
            let mut acceleration = Vector::zeros();
            acceleration[opening.axis] = opening.along(open.change[*k]) / dt;
            self.rates.acceleration[*i] = acceleration;
        }
    }

    /// Gives the particles beyond the outlets the density they are to have after `dt` \[s\].
    pub(crate) fn hold_densities(&mut self, dt: T) {
        let Some(open) = &self.open else { return };
        for (i, k) in &open.leaving {
            let n = self.density_beyond(open, *k, &self.particles.position[*i]);
            self.rates.density_rate[*i] = (n - self.particles.density[*i]) / dt;
        }
    }

    /// The density ratio that particle `i` is given, if it is beyond an outlet.
    pub(crate) fn held_density(&self, i: usize) -> Option<T> {
        let (open, place) = (self.open.as_ref()?, &self.particles.position[i]);
        let k = open.outlet_at(place, self.zone(), self.config.spacing)?;
        Some(self.density_beyond(open, k, place))
    }

    fn density_beyond(&self, open: &OpenBoundaries<T, D>, k: usize, place: &Vector<T, D>) -> T {
        self.eos.density(open.beyond[k] + self.hydrostatic(&open.outlets[k].opening, place))
    }

    /// Pressure at a place over that at the middle of an opening \[Pa\], of fluid at rest under gravity.
    pub(super) fn hydrostatic(&self, opening: &Opening<T, D>, place: &Vector<T, D>) -> T {
        let mut from_middle = place - opening.middle();
        from_middle[opening.axis] = T::zero();
        self.config.density * self.config.gravity.dot(&from_middle)
    }

    /// Whether particle `i` is beyond an outlet.
    pub(crate) fn is_leaving(&self, i: usize) -> bool {
        let place = &self.particles.position[i];
        self.open
            .as_ref()
            .is_some_and(|open| open.outlet_at(place, self.zone(), self.config.spacing).is_some())
    }
}

impl<T: Real, const D: usize> OpenBoundaries<T, D> {
    /// The outlet that a place is beyond: the one whose zone it is in before one whose rim.
    #[inline]
    fn outlet_at(&self, place: &Vector<T, D>, depth: T, spacing: T) -> Option<usize> {
        let mut rim = None;
        for (k, outlet) in self.outlets.iter().enumerate() {
            match outlet.reach(place, depth, spacing) {
                Reach::Zone => return Some(k),
                Reach::Rim => rim = rim.or(Some(k)),
                Reach::Outside => {}
            }
        }
        rim
    }
}

/// Mean speed through the plane of an opening \[m/s\]: the line of least squares through the particles up to `slab` \[m\] straight before it, at
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
        if x <= T::zero() && x > -slab && opening.beside(&position[i]) <= T::zero() {
            [T::one(), x, x * x, u, x * u]
        } else {
            [T::zero(); 5]
        }
    };
    let add = |a: [T; 5], b: [T; 5]| core::array::from_fn(|k| a[k] + b[k]);
    let [n, x, xx, u, xu] = parallel.fold(position.len(), [T::zero(); 5], &moments, &add);
    let spread = n * xx - x * x;
    (spread > T::zero()).then(|| (xx * u - x * xu) / spread)
}
