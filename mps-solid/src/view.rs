//! Reading and writing the state of a solid.

use crate::{ConstitutiveModel, Solid, SolidConfig, SolidParticles};
use mps_kernel::{FieldVisitor, ParticleStore, Real, Vector};
use mps_neighbors::FrozenPairs;

/// Reading the state.
impl<T, const D: usize, M, K> Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
{
    /// The particles.
    pub fn particles(&self) -> &SolidParticles<T, D> {
        &self.particles
    }

    /// Positions \[m\].
    pub fn positions(&self) -> &[Vector<T, D>] {
        &self.particles.position
    }

    /// Velocities at the end of the last step \[m/s\].
    pub fn velocities(&self) -> &[Vector<T, D>] {
        &self.particles.velocity
    }

    /// Velocities to start from \[m/s\]. A clamped particle's is set back to zero by the next step.
    pub fn velocities_mut(&mut self) -> &mut [Vector<T, D>] {
        &mut self.particles.velocity
    }

    /// Positions to start from \[m\]; stresses follow at the next step.
    pub fn positions_mut(&mut self) -> &mut [Vector<T, D>] {
        self.stale = true;
        &mut self.particles.position
    }

    /// Time moved through so far \[s\].
    pub fn time(&self) -> T {
        self.time.now()
    }

    /// Displacement over the last [`advance`](Self::advance) divided by its `dt` \[m/s\].
    pub fn mean_velocities(&self) -> &[Vector<T, D>] {
        &self.mean_velocity
    }

    /// Reference volumes \[m^D\].
    pub fn volumes(&self) -> &[T] {
        &self.particles.volume
    }

    /// Masses \[kg, per metre of depth in 2D\].
    pub fn masses(&self) -> &[T] {
        &self.particles.mass
    }

    /// What the material remembers at every particle.
    pub fn history(&self) -> &[M::History] {
        &self.history
    }

    /// The reference pairs.
    pub fn pairs(&self) -> &FrozenPairs<T, D> {
        &self.pairs
    }

    /// The material.
    pub fn material(&self) -> &M {
        &self.material
    }

    /// The weight of the reference pairs.
    pub fn kernel(&self) -> &K {
        &self.kernel
    }

    /// The parameters.
    pub fn config(&self) -> &SolidConfig<T> {
        &self.config
    }

    /// Particle distance along each axis \[m\].
    pub fn spacing(&self) -> &Vector<T, D> {
        &self.spacing
    }

    /// Fastest small-strain wave \[m/s\].
    pub fn wave_speed(&self) -> T {
        self.wave_speed
    }

    /// Largest stable sub-step \[s\], `2/omega_max`, before the factor [`cfl`](SolidConfig::cfl): of the undeformed
    /// body, or of the state in which it was [measured last](Solid::remeasure_stability).
    pub fn stability_limit(&self) -> T {
        self.stability_limit
    }

    /// Coefficient of the non-affine energy \[Pa\], see [`stabilization`](crate::stabilization).
    pub fn bending_coefficient(&self) -> T {
        self.kappa
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.particles.len()
    }

    /// Whether there is no particle (never: such a solid cannot be built).
    pub fn is_empty(&self) -> bool {
        self.particles.is_empty()
    }
}

/// For hashing and checkpoints. Do not permute the fields: the reference pairs name particles by index.
impl<T, const D: usize, M, K> ParticleStore for Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
{
    fn len(&self) -> usize {
        self.particles.len()
    }

    fn for_each_field(&mut self, visitor: &mut impl FieldVisitor) {
        self.stale = true;
        self.particles.for_each_field(visitor);
        visitor.visit("mean_velocity", &mut self.mean_velocity);
        visitor.visit("history", &mut self.history);
    }
}
