//! The largest stable sub-step.
//!
//! Velocity Verlet is stable for `dt < 2/omega_max`, with the largest eigenfrequency of the body at rest.
//! A formula `C l0/c_p` (eq. 47 of Tavakoli et al. 2026 with its units put right) must guess how that
//! frequency depends on dimension, Poisson's ratio, radius and thickness; measured, the border `C` lies
//! between 0.63 and 1.01 (table in `docs/solid.md`). A power iteration at set-up finds it instead, for the
//! price of at most two hundred force evaluations, and again where a body has changed its shape
//! ([`Solid::remeasure_stability`]). Under motion
//!
//! ```text
//! dt = cfl * (2/omega_max) * c_p/(c_p + v),    v = max |u_i|
//! ```
//!
//! which is the usual `C l0/(c_p + v)` with the `C` of this body.

use crate::{ConstitutiveModel, Solid, SolidError};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::Parallel;

/// Most power iterations, and the relative change of `omega^2` that counts as none. The estimate
/// approaches from below; stopped like this it is within 1 % on the bodies of the table.
const ITERATIONS: usize = 100;
const CONVERGED: f64 = 2e-4;
/// Size of the trial displacements in spacings: small strain, but well above the round-off of `f32`.
const TRIAL: f64 = 0.01;

impl<T, const D: usize, M, K> Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    /// Largest stable sub-step at the current state \[s\], with the safety factor
    /// [`cfl`](crate::SolidConfig::cfl).
    pub fn max_step(&self, parallel: &Parallel) -> T {
        let velocity = &self.particles.velocity;
        let fastest = parallel.max(velocity.len(), T::zero(), |i| velocity[i].norm_squared()).sqrt();
        self.config.cfl * self.stability_limit * self.wave_speed / (self.wave_speed + fastest)
    }

    /// Measures [`stability_limit`](Self::stability_limit), `2/omega_max` \[s\], about the present positions instead of
    /// the undeformed ones, and returns it; [`max_step`](Self::max_step) rests on it from now on.
    ///
    /// For a body that is brought far from its shape: the limit falls where a material stiffens (rubber that is
    /// stretched to four times its length, or flattened) and rises where it softens. Costs as much as a few hundred
    /// sub-steps at most, so it is not done by itself. Positions, velocities and the memory of the material are untouched.
    ///
    /// # Errors
    /// If a particle is turned inside out or so close to it that a hundredth of a spacing brings it there.
    pub fn remeasure_stability(&mut self, parallel: &Parallel) -> Result<T, SolidError> {
        let (there, history) = (self.particles.position.clone(), self.history.clone());
        let limit = self.measure_about(parallel, &there);
        (self.particles.position, self.history) = (there, history);
        self.refresh(parallel)?;
        self.stability_limit = limit?;
        Ok(self.stability_limit)
    }

    /// `2/omega_max` \[s\] about `there`. Leaves the positions of the last trial behind.
    fn measure_about(&mut self, parallel: &Parallel, there: &[Vector<T, D>]) -> Result<T, SolidError> {
        let smallest = self.spacing.iter().fold(self.spacing[0], |least, l| least.min(*l));
        let mut trial = self.noise();
        let mut square = T::zero();
        for _ in 0..ITERATIONS {
            let largest = parallel.max(trial.len(), T::zero(), |i| trial[i].norm_squared()).sqrt();
            if largest == T::zero() {
                break;
            }
            let scale = smallest * T::of(TRIAL) / largest;
            trial.iter_mut().for_each(|d| *d *= scale);
            let forward = self.forces_at(parallel, there, &trial, T::one())?;
            let backward = self.forces_at(parallel, there, &trial, -T::one())?;

            // Rayleigh quotient and next vector of M^-1 K, with the mass as the inner product.
            let (mut potential, mut inertia) = (T::zero(), T::zero());
            for i in 0..trial.len() {
                let pull = self.particles.only_free(i, (backward[i] - forward[i]) * T::of(0.5));
                potential += pull.dot(&trial[i]);
                inertia += trial[i].norm_squared() * self.particles.mass[i];
                trial[i] = pull / self.particles.mass[i];
            }
            let before = square;
            square = potential / inertia;
            if (square - before).abs() <= square * T::of(CONVERGED) {
                break;
            }
        }
        // A body that cannot move (all clamped) is stable for any step: give it that of a wave.
        let limit = T::of(2.0) / square.sqrt();
        Ok(if limit.is_finite() { limit } else { smallest / self.wave_speed })
    }

    fn forces_at(
        &mut self,
        parallel: &Parallel,
        there: &[Vector<T, D>],
        trial: &[Vector<T, D>],
        sign: T,
    ) -> Result<Vec<Vector<T, D>>, SolidError> {
        let particles = &mut self.particles;
        for (x, (x0, d)) in particles.position.iter_mut().zip(there.iter().zip(trial)) {
            *x = x0 + d * sign;
        }
        self.refresh(parallel)?;
        Ok(self.particles.force.clone())
    }

    /// Reproducible noise on the particles that move.
    fn noise(&self) -> Vec<Vector<T, D>> {
        let mut state = 1_u64;
        let mut next = || {
            // Knuth's linear congruential generator, upper bits.
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            T::of((state >> 40) as f64 / (1_u64 << 24) as f64 - 0.5)
        };
        let mut on = |i| self.particles.only_free(i, Vector::from_fn(|_, _| next()));
        (0..self.len()).map(&mut on).collect()
    }
}
