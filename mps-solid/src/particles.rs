//! The particles of a solid, a structure of arrays.

use mps_kernel::{FieldVisitor, ParticleStore, Real, Tensor, Vector};

/// Everything a solid particle carries from one step to the next.
///
/// Filled by [`push`](Self::push) or by [`body::block`](crate::body::block), then handed to
/// [`Solid::new`](crate::Solid::new), which sets the masses.
#[derive(Clone, Debug, Default)]
pub struct SolidParticles<T: Real, const D: usize> {
    pub(crate) reference: Vec<Vector<T, D>>,
    pub(crate) position: Vec<Vector<T, D>>,
    pub(crate) velocity: Vec<Vector<T, D>>,
    pub(crate) volume: Vec<T>,
    pub(crate) mass: Vec<T>,
    pub(crate) deformation: Vec<Tensor<T, D>>,
    pub(crate) force: Vec<Vector<T, D>>,
    pub(crate) clamped: Vec<u8>,
    pub(crate) id: Vec<u32>,
}

impl<T: Real, const D: usize> SolidParticles<T, D> {
    /// No particles.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a particle at rest at `reference` \[m\] that stands for `volume` \[m^D\] of the undeformed
    /// body. A `clamped` one never moves. Its identity is the number of particles before it.
    pub fn push(&mut self, reference: Vector<T, D>, volume: T, clamped: bool) {
        self.id.push(self.id.len() as u32);
        self.reference.push(reference);
        self.position.push(reference);
        self.velocity.push(Vector::zeros());
        self.volume.push(volume);
        self.mass.push(T::zero());
        self.deformation.push(Tensor::identity());
        self.force.push(Vector::zeros());
        self.clamped.push(u8::from(clamped));
    }

    /// Positions in the undeformed body \[m\].
    pub fn reference_positions(&self) -> &[Vector<T, D>] {
        &self.reference
    }

    /// Positions \[m\].
    pub fn positions(&self) -> &[Vector<T, D>] {
        &self.position
    }

    /// Velocities \[m/s\].
    pub fn velocities(&self) -> &[Vector<T, D>] {
        &self.velocity
    }

    /// Reference volumes \[m^D\].
    pub fn volumes(&self) -> &[T] {
        &self.volume
    }

    /// Masses \[kg, per metre of depth in 2D\].
    pub fn masses(&self) -> &[T] {
        &self.mass
    }

    /// Deformation gradients at the current positions.
    pub fn deformations(&self) -> &[Tensor<T, D>] {
        &self.deformation
    }

    /// Internal forces at the current positions \[N\]. On a clamped particle: what the body pulls at the
    /// support with.
    pub fn internal_forces(&self) -> &[Vector<T, D>] {
        &self.force
    }

    /// Whether particle `i` never moves.
    pub fn is_clamped(&self, i: usize) -> bool {
        self.clamped[i] != 0
    }

    /// Identities: unique, unchanged for the life of the particle.
    pub fn ids(&self) -> &[u32] {
        &self.id
    }
}

impl<T: Real, const D: usize> ParticleStore for SolidParticles<T, D> {
    fn len(&self) -> usize {
        self.id.len()
    }

    fn for_each_field(&mut self, visitor: &mut impl FieldVisitor) {
        visitor.visit("reference_position", &mut self.reference);
        visitor.visit("position", &mut self.position);
        visitor.visit("velocity", &mut self.velocity);
        visitor.visit("volume", &mut self.volume);
        visitor.visit("mass", &mut self.mass);
        visitor.visit("deformation", &mut self.deformation);
        visitor.visit("internal_force", &mut self.force);
        visitor.visit("clamped", &mut self.clamped);
        visitor.visit("id", &mut self.id);
    }
}
