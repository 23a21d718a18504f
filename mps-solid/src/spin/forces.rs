use super::{Normalization, SpinEnergy, SpinSolid};
use crate::SolidParticles;
use mps_kernel::{Real, Vector};
use mps_neighbors::{FrozenPair, Parallel};

/// Dimensions, as a factor of the sums.
const D: f64 = 2.0;

fn turned<T: Real>(angle: T, r: &Vector<T, 2>) -> Vector<T, 2> {
    let (sin, cos) = (angle.sin(), angle.cos());
    Vector::<T, 2>::new(cos * r.x - sin * r.y, sin * r.x + cos * r.y)
}

impl<T: Real> SpinSolid<T> {
    /// `r_ij`, and `R_ij r0_ij`.
    fn vectors(&self, i: usize, pair: &FrozenPair<T, 2>) -> (Vector<T, 2>, Vector<T, 2>) {
        let j = pair.j as usize;
        let r_ij = self.particles.position[j] - self.particles.position[i];
        let angle = (self.angle[i] + self.angle[j]) * T::of(0.5);
        (r_ij, turned(angle, &pair.r0_ij))
    }

    /// The trace of the strain: eq. 35 with its sign, or the stretch of which the energy is made.
    fn trace_of(&self, i: usize) -> T {
        let sum = self.pairs.row(i).iter().fold(T::zero(), |sum, pair| {
            let (r_ij, r0_ij) = self.vectors(i, pair);
            let (r, r0) = (r_ij.norm(), pair.r0_ij.norm());
            let longer = match self.config.normalization {
                Normalization::Own => (r_ij - r0_ij).dot(&r_ij) / r,
                Normalization::Shared => r - r0,
            };
            sum + longer * r0 * pair.over_r2
        });
        sum * T::of(D) * self.inverse_density[i]
    }

    /// Traces, then forces and torques of the current state.
    pub(super) fn rates(&mut self, parallel: &Parallel) {
        let mut trace = core::mem::take(&mut self.trace);
        parallel.update(trace.as_mut_slice(), |i, trace| *trace = self.trace_of(i));
        self.trace = trace;

        let mut force = core::mem::take(&mut self.particles.force);
        let mut torque = core::mem::take(&mut self.torque);
        parallel.update((force.as_mut_slice(), torque.as_mut_slice()), |i, (force, torque)| {
            (*force, *torque) = self.pull(i);
        });
        (self.particles.force, self.torque) = (force, torque);
    }

    /// Force \[N\] and torque \[N m\] on particle `i`: eqs. 37 to 39 times its mass.
    fn pull(&self, i: usize) -> (Vector<T, 2>, T) {
        let volume = &self.particles.volume;
        let own = volume[i] * self.inverse_density[i];
        let (lambda, mu) = (self.moduli.lambda, self.moduli.mu);
        let (mut force, mut torque) = (Vector::zeros(), T::zero());
        for pair in self.pairs.row(i) {
            let j = pair.j as usize;
            let other = match self.config.normalization {
                Normalization::Own => own,
                Normalization::Shared => volume[j] * self.inverse_density[j],
            };
            let (r_ij, r0_ij) = self.vectors(i, pair);
            let pressure = lambda * (self.trace[i] * own + self.trace[j] * other);
            let shear = mu * (own + other);
            let stretch = r_ij * (pressure * pair.r0_ij.norm() / r_ij.norm());
            force += (stretch + (r_ij - r0_ij) * (shear * T::of(2.0))) * pair.over_r2;
            torque -= (r_ij.x * r0_ij.y - r_ij.y * r0_ij.x) * (shear * pair.over_r2);
        }
        (force * T::of(D), torque * T::of(D))
    }

    /// `I_i` \[kg m^2\], that of a square.
    fn inertia(&self, i: usize) -> T {
        self.particles.mass[i] * self.spacing * self.spacing / T::of(6.0)
    }

    pub(super) fn kick(
        &mut self,
        parallel: &Parallel,
        external: &[Vector<T, 2>],
        gravity: &Vector<T, 2>,
        step: T,
    ) {
        let mut velocity = core::mem::take(&mut self.particles.velocity);
        let mut spin = core::mem::take(&mut self.spin);
        parallel.update((velocity.as_mut_slice(), spin.as_mut_slice()), |i, (u, spin)| {
            let SolidParticles { force, mass, .. } = &self.particles;
            if self.particles.is_clamped(i) {
                (*u, *spin) = (Vector::zeros(), T::zero());
            } else {
                let moved = *u + ((force[i] + external[i]) / mass[i] + gravity) * step;
                *u = self.particles.only_free(i, moved);
                *spin += self.torque[i] / self.inertia(i) * step;
            }
        });
        (self.particles.velocity, self.spin) = (velocity, spin);
    }

    pub(super) fn drift(&mut self, parallel: &Parallel, step: T) {
        let SolidParticles { position, velocity, .. } = &mut self.particles;
        let (velocity, spin) = (&*velocity, &self.spin);
        parallel.update((position.as_mut_slice(), self.angle.as_mut_slice()), |i, (x, angle)| {
            *x += velocity[i] * step;
            *angle += spin[i] * step;
        });
    }

    /// The energy, conserved with [`Normalization::Shared`] only.
    pub fn energy(&self, parallel: &Parallel) -> SpinEnergy<T> {
        let half = T::of(0.5);
        let of = |i: usize| {
            let particles = &self.particles;
            let trace = self.trace_of(i);
            let shear = self.pairs.row(i).iter().fold(T::zero(), |sum, pair| {
                let (r_ij, r0_ij) = self.vectors(i, pair);
                sum + (r_ij - r0_ij).norm_squared() * pair.over_r2
            });
            let density = self.moduli.lambda * half * trace * trace
                + self.moduli.mu * T::of(D) * self.inverse_density[i] * shear;
            let moving = particles.mass[i] * particles.velocity[i].norm_squared()
                + self.inertia(i) * self.spin[i] * self.spin[i];
            [moving * half, particles.volume[i] * density]
        };
        let add = |a: [T; 2], b: [T; 2]| [a[0] + b[0], a[1] + b[1]];
        let [kinetic, strain] = parallel.fold(self.particles.id.len(), [T::zero(); 2], &of, &add);
        SpinEnergy { kinetic, strain }
    }

    /// Angular momentum about the origin, that of the spins included \[kg m^2/s\].
    pub fn angular_momentum(&self, parallel: &Parallel) -> T {
        let of = |i: usize| {
            let (x, u) = (&self.particles.position[i], &self.particles.velocity[i]);
            self.particles.mass[i] * (x.x * u.y - x.y * u.x) + self.inertia(i) * self.spin[i]
        };
        parallel.fold(self.particles.id.len(), T::zero(), &of, &|a, b| a + b)
    }
}
