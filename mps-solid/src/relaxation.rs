//! Static answers by dynamic relaxation.
//!
//! The body is moved in its own time with a damping that is made from what it does, so that its slowest mode is
//! damped critically and nothing has to be chosen (Underwood 1983, Dynamic relaxation, eqs. 5.31-5.33):
//!
//! ```text
//! c = 2 sqrt( sum_i d_i . k_i d_i / sum_i m_i |d_i|^2 ),    k_i d_i = f_i(before) - f_i(now)
//! ```
//!
//! with the displacement `d_i` of the last step and the forces `f_i` on the particles before and after it: the
//! Rayleigh quotient of the motion. Masses are those of the body and the step is its stable one, so that a thin
//! body needs about as many steps as a few periods of its slowest mode.

use crate::sweeps::displaced;
use crate::{ConstitutiveModel, Solid, SolidError, SolidParticles};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::Parallel;

/// When a body counts as being at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relaxation<T> {
    /// Largest allowed norm of the forces that do not balance, over that of the load, or without a load over that
    /// of the forces at the supports \[-\]. Default 1e-5, which leaves 0.005 % in the deflection
    /// of a beam 17 times as long as thick.
    ///
    /// In `f64` such a beam with 8 particles across (CSM1 of `docs/flag-structure.md`) comes to 1e-7 in 214 000 steps, as fast as
    /// its slowest mode dies out. Below that the forces are rounded by as much as they miss each other, and what
    /// is left falls slowly: 3e-8 takes 1 580 000 steps, 1e-8 was not reached in 1 260 000.
    pub tolerance: T,
    /// Most steps. Default 1,000,000.
    pub max_steps: usize,
}

impl<T: Real> Default for Relaxation<T> {
    fn default() -> Self {
        Self { tolerance: T::of(1e-5), max_steps: 1_000_000 }
    }
}

/// How a static answer was reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settled<T> {
    /// Steps taken.
    pub steps: usize,
    /// Forces that do not balance over the load \[-\].
    pub residual: T,
}

impl<T, const D: usize, M, K> Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    /// Moves the body to its equilibrium under gravity \[m/s^2\] and the loads that `load` adds to the forces on the
    /// particles \[N\] (all zero when it is called, which is once in every step). The velocities are zero at the end and the material
    /// has settled ([`ConstitutiveModel::settle`]); [`time`](Self::time) stands still, and so do supports.
    ///
    /// # Errors
    /// If the equilibrium is not reached in the allowed number of steps: the body is left at rest where it has come to. If a particle is
    /// turned inside out on the way: it is left at rest where it was.
    pub fn relax(
        &mut self,
        parallel: &Parallel,
        gravity: &Vector<T, D>,
        load: impl FnMut(&SolidParticles<T, D>, &mut [Vector<T, D>]),
        relaxation: &Relaxation<T>,
    ) -> Result<Settled<T>, SolidError> {
        let value = relaxation.tolerance.to_double();
        if !(value > 0.0 && value < 1.0) {
            return Err(SolidError::Parameter { name: "tolerance", must: "between 0 and 1", value });
        }
        self.rest();
        self.refresh(parallel)?;
        self.settle_material(parallel)?;
        self.keep();
        match self.search(parallel, gravity, load, relaxation) {
            Err(error @ (SolidError::Inverted { .. } | SolidError::NotFinite { .. })) => {
                Err(self.take_back(parallel, error))
            }
            found => {
                self.rest();
                self.settle_material(parallel)?;
                found
            }
        }
    }

    /// Takes all motion away.
    pub(crate) fn rest(&mut self) {
        self.particles.velocity.fill(Vector::zeros());
        self.mean_velocity.fill(Vector::zeros());
    }

    /// Lets the material settle where the body is, whose deformations are up to date.
    pub(crate) fn settle_material(&mut self, parallel: &Parallel) -> Result<(), SolidError> {
        let (material, deformation) = (&self.material, &self.particles.deformation);
        parallel.update(self.history.as_mut_slice(), |i, history| material.settle(&deformation[i], history));
        self.refresh(parallel)
    }

    /// The way to the equilibrium.
    fn search(
        &mut self,
        parallel: &Parallel,
        gravity: &Vector<T, D>,
        mut load: impl FnMut(&SolidParticles<T, D>, &mut [Vector<T, D>]),
        relaxation: &Relaxation<T>,
    ) -> Result<Settled<T>, SolidError> {
        let len = self.len();
        let mut external = vec![Vector::zeros(); len];
        let mut before: Vec<Vector<T, D>> = vec![Vector::zeros(); len];
        let mut total = before.clone();
        let mut residual = T::zero();
        for step in 0..relaxation.max_steps {
            external.fill(Vector::zeros());
            load(&self.particles, &mut external);
            let particles = &self.particles;
            parallel.update(total.as_mut_slice(), |i, total| {
                let pull = particles.force[i] + external[i] + gravity * particles.mass[i];
                *total = particles.only_free(i, pull);
            });
            residual = self.unbalanced(parallel, &total, &external, gravity);
            if residual <= relaxation.tolerance {
                return Ok(Settled { steps: step, residual });
            }
            let dt = self.max_step(parallel);
            let damping =
                if step == 0 { T::zero() } else { self.critical_damping(parallel, &before, &total, dt) };
            let keep = (T::of(2.0) - damping * dt) / (T::of(2.0) + damping * dt);
            let kick = T::of(2.0) * dt / (T::of(2.0) + damping * dt);
            let SolidParticles { position, velocity, mass, .. } = &mut self.particles;
            let mass = &*mass;
            let moved = (position.as_mut_slice(), velocity.as_mut_slice(), self.remainder.as_mut_slice());
            parallel.update(moved, |i, (x, u, remainder)| {
                *u = *u * keep + total[i] * (kick / mass[i]);
                *x = displaced(x, *u * dt, remainder);
            });
            core::mem::swap(&mut before, &mut total);
            self.refresh(parallel)?;
        }
        Err(SolidError::NotSettled {
            steps: relaxation.max_steps,
            residual: residual.to_double(),
            tolerance: relaxation.tolerance.to_double(),
        })
    }

    /// Norm of the forces on what is free, over that of the load or else of the forces at what is held.
    fn unbalanced(
        &self,
        parallel: &Parallel,
        total: &[Vector<T, D>],
        external: &[Vector<T, D>],
        gravity: &Vector<T, D>,
    ) -> T {
        let particles = &self.particles;
        let squares = parallel.fold(
            total.len(),
            [T::zero(); 3],
            &|i: usize| {
                let given = external[i] + gravity * particles.mass[i];
                let held = particles.force[i] - particles.only_free(i, particles.force[i]);
                [total[i].norm_squared(), given.norm_squared(), held.norm_squared()]
            },
            &|a: [T; 3], b: [T; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]],
        );
        let [left, given, held] = squares;
        if left == T::zero() {
            T::zero()
        } else {
            (left / if given > T::zero() { given } else { held }).sqrt()
        }
    }

    /// `c` of the module's formula \[1/s\]; `u dt` is the displacement between the two forces.
    fn critical_damping(
        &self,
        parallel: &Parallel,
        before: &[Vector<T, D>],
        now: &[Vector<T, D>],
        dt: T,
    ) -> T {
        let SolidParticles { velocity, mass, .. } = &self.particles;
        let [stiffness, inertia] = parallel.fold(
            now.len(),
            [T::zero(); 2],
            &|i: usize| {
                let u = &velocity[i];
                [u.dot(&(before[i] - now[i])) * dt, u.norm_squared() * mass[i] * dt * dt]
            },
            &|a: [T; 2], b: [T; 2]| [a[0] + b[0], a[1] + b[1]],
        );
        // Along a direction in which the body softens nothing is known about its period.
        if stiffness > T::zero() && inertia > T::zero() {
            T::of(2.0) * (stiffness / inertia).sqrt().min(T::one() / dt)
        } else {
            T::zero()
        }
    }
}
