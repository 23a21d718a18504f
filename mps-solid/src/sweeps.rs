//! The loops over all particles that a sub-step is made of. Each writes only to its own particle.

use crate::kinematics::deformation_gradient;
use crate::momentum::{InnerStress, internal_force};
use crate::supports::Held;
use crate::{ConstitutiveModel, Solid, SolidError, SolidParticles};
use core::sync::atomic::{AtomicUsize, Ordering};
use mps_kernel::tensor::determinant;
use mps_kernel::{Kernel, Real, Vector, add_carrying};
use mps_neighbors::Parallel;

impl<T, const D: usize, M, K> Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    /// First sweep: `F_i`, then `A_i`, `elapsed` seconds after the last one.
    pub(crate) fn stress(&mut self, parallel: &Parallel, elapsed: T) -> Result<(), SolidError> {
        let nobody = usize::MAX;
        let first_bad = AtomicUsize::new(nobody);
        let SolidParticles { position, volume, deformation, .. } = &mut self.particles;
        let (position, volume) = (&*position, &*volume);
        let (pairs, correction, kappa, material) =
            (&self.pairs, &self.correction, self.kappa, &self.material);
        parallel.update(
            (deformation.as_mut_slice(), self.inner.as_mut_slice(), self.history.as_mut_slice()),
            |i, (deformation, inner, history)| {
                let f = deformation_gradient(pairs.row(i), &correction[i], i, position);
                *deformation = f;
                // NaN takes the other branch.
                if determinant(&f) > T::zero() {
                    let stress = material.first_piola(&f, history, elapsed);
                    *inner = InnerStress::new(&stress, &f, &correction[i], volume[i], kappa);
                    // Infinite or NaN if one of its components is, or if they are so large that their squares are.
                    if stress.norm_squared().is_finite() {
                        return;
                    }
                }
                first_bad.fetch_min(i, Ordering::Relaxed);
            },
        );
        match first_bad.into_inner() {
            i if i == nobody => Ok(()),
            i => Err(self.broken(i)),
        }
    }

    fn broken(&mut self, i: usize) -> SolidError {
        self.stale = true;
        let (id, determinant) =
            (self.particles.id[i], determinant(&self.particles.deformation[i]).to_double());
        let position = self.particles.position[i].iter().map(|x| x.to_double()).collect();
        if determinant <= 0.0 && determinant.is_finite() {
            SolidError::Inverted { id, position, determinant }
        } else {
            SolidError::NotFinite { id, position }
        }
    }

    /// Second sweep: the internal forces.
    pub(crate) fn forces(&mut self, parallel: &Parallel) {
        let SolidParticles { position, force, .. } = &mut self.particles;
        let (position, pairs, inner) = (&*position, &self.pairs, &self.inner);
        parallel.update(force.as_mut_slice(), |i, force| {
            *force = internal_force(pairs.row(i), i, position, inner);
        });
    }

    /// `u += kick a`, then `x += drift u`, with the stored internal forces. Supports go to where they are
    /// placed.
    pub(crate) fn kick_and_drift(
        &mut self,
        parallel: &Parallel,
        external: &[Vector<T, D>],
        gravity: &Vector<T, D>,
        kick: T,
        drift: T,
    ) {
        // What damping takes in the time of a kick lies between kick and drift, on either side of the step: so it is of second order.
        let damped = self.damped(kick);
        let (keep, push) = if drift > T::zero() { (damped, damped) } else { (damped, T::one()) };
        let push = push * kick;
        let SolidParticles { reference, position, velocity, force, mass, held, group, .. } =
            &mut self.particles;
        let (force, mass) = (&*force, &*mass);
        let supports = Held { reference, axes: held, group, placements: &self.placements };
        let moved = (position.as_mut_slice(), velocity.as_mut_slice(), self.remainder.as_mut_slice());
        parallel.update(moved, |i, (x, u, remainder)| {
            let before = *u;
            *u = *u * keep + ((force[i] + external[i]) / mass[i] + gravity) * push;
            let there = displaced(x, *u * drift, remainder);
            (*x, *u) = if supports.axes[i] == 0 {
                (there, *u)
            } else {
                *remainder = supports.of_free_axes(i, *remainder);
                supports.hold(i, (x, &before), (there, *u), drift)
            };
        });
    }

    /// Second sweep, the kick and the drift of an inner sub-step in one visit. Positions are written to
    /// a second array, because the neighbours still read the old ones.
    pub(crate) fn force_kick_and_drift(
        &mut self,
        parallel: &Parallel,
        external: &[Vector<T, D>],
        gravity: &Vector<T, D>,
        step: T,
    ) {
        let half = self.damped(step * T::of(0.5));
        let (keep, push) = (half * half, half * step);
        let SolidParticles { reference, position, velocity, mass, held, group, .. } = &mut self.particles;
        let (mass, pairs, inner) = (&*mass, &self.pairs, &self.inner);
        let supports = Held { reference, axes: held, group, placements: &self.placements };
        let here = &*position;
        let moved = (velocity.as_mut_slice(), self.next.as_mut_slice(), self.remainder.as_mut_slice());
        parallel.update(moved, |i, (u, next, remainder)| {
            let before = *u;
            let force = internal_force(pairs.row(i), i, here, inner);
            *u = *u * keep + ((force + external[i]) / mass[i] + gravity) * push;
            *next = displaced(&here[i], *u * step, remainder);
            if supports.axes[i] != 0 {
                *remainder = supports.of_free_axes(i, *remainder);
                (*next, *u) = supports.hold(i, (&here[i], &before), (*next, *u), step);
            }
        });
        core::mem::swap(position, &mut self.next);
    }

    /// What damping leaves of a velocity after `step` seconds.
    fn damped(&self, step: T) -> T {
        (-self.config.damping * step).exp()
    }
}

/// Changes of one that single precision cannot hold, and double can.
const SMALL: f64 = 1e-12;

/// Where a particle at `x` is after the `way` \[m\]. In single precision what the last place of a coordinate cannot hold, half a unit of it at most, is kept as the
/// `remainder`: a body would not move at all otherwise where its sub-steps are shorter than that.
pub(crate) fn displaced<T: Real, const D: usize>(
    x: &Vector<T, D>,
    way: Vector<T, D>,
    remainder: &mut Vector<T, D>,
) -> Vector<T, D> {
    // Known when this is compiled: double precision never misses its last place.
    if T::one() + T::of(SMALL) == T::one() { add_carrying(*x, way, remainder) } else { x + way }
}
