//! The longest stable time step.

use crate::terms::Viscosity;
use crate::{Fluid, FluidError};
use mps_kernel::{Kernel, Real};
use mps_neighbors::{Domain, Parallel};

/// Speed over sound speed beyond which the run is given up: nothing physical gets there.
const ESCAPED: f64 = 20.0;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// `dt = C min(l0/(v_max + c), l0^2/nu)` (eq. 46), `rho0 l0^2/(2 zeta)` for the bulk viscosity, and `sqrt(l0/a_max)` for sudden forces.
    pub(crate) fn stable_step(&self, parallel: &Parallel) -> Result<T, FluidError> {
        let (u, a) = (&self.particles.velocity, &self.rates.acceleration);
        // Keeps a NaN once it has met one, so that it cannot hide behind a comparison.
        let largest = |x: T, y: T| if x > y || x.partial_cmp(&x).is_none() { x } else { y };
        let (v2, a2) = parallel.fold(
            u.len(),
            (T::zero(), T::zero()),
            &|i| (u[i].norm_squared(), a[i].norm_squared()),
            &|x, y| (largest(x.0, y.0), largest(x.1, y.1)),
        );
        if !(v2.is_finite() && a2.is_finite()) {
            return Err(self.find_not_finite());
        }
        let (l0, c) = (self.config.spacing, self.config.sound_speed);
        let v = v2.sqrt();
        let mut limit = l0 / (v + c);
        let nu = self.viscosity.kinematic();
        if nu > T::zero() {
            // 1/8 keeps explicit diffusion on this stencil inside its stability limit.
            limit = limit.min(l0 * l0 * T::of(0.125) / nu);
        }
        if self.config.sound_damping > T::zero() {
            limit = limit.min(l0 / (T::of(2.0) * self.config.sound_damping * c));
        }
        if a2 > T::zero() {
            limit = limit.min((l0 / a2.sqrt()).sqrt());
        }
        let dt = limit * self.config.cfl;
        if v > c * T::of(ESCAPED) {
            return Err(self.find_fastest(dt));
        }
        Ok(dt)
    }

    fn find_not_finite(&self) -> FluidError {
        let particles = &self.particles;
        let len = particles.position.len();
        // The state first: accelerations are spoilt by the state of a neighbour.
        let state = (0..len).flat_map(|i| {
            let speed = particles.velocity[i].norm();
            [("density", particles.density[i]), ("pressure", particles.pressure[i]), ("speed", speed)]
                .map(|(quantity, value)| (i, quantity, value))
        });
        let acceleration = (0..len).map(|i| (i, "acceleration", self.rates.acceleration[i].norm()));
        if let Some((i, quantity, value)) = state.chain(acceleration).find(|(.., x)| !x.is_finite()) {
            return FluidError::NotFinite {
                id: particles.id[i],
                quantity,
                value: value.to_double(),
                position: particles.position[i].iter().map(|x| x.to_double()).collect(),
                time: self.time.to_double(),
                step: self.steps,
            };
        }
        self.find_fastest(T::zero())
    }

    fn find_fastest(&self, dt: T) -> FluidError {
        let particles = &self.particles;
        let mut fastest = (T::zero(), 0);
        for (u, id) in particles.velocity.iter().zip(&particles.id) {
            if u.norm() > fastest.0 {
                fastest = (u.norm(), *id);
            }
        }
        FluidError::TimeStep {
            dt: dt.to_double(),
            time: self.time.to_double(),
            id: fastest.1,
            speed: fastest.0.to_double(),
        }
    }
}
