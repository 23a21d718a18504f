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
    /// One bit an axis: that axis is held.
    pub(crate) held: Vec<u8>,
    /// Number of the motion that moves the held axes, 0 for none.
    pub(crate) group: Vec<u8>,
    pub(crate) id: Vec<u32>,
}

impl<T: Real, const D: usize> SolidParticles<T, D> {
    /// No particles.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a particle at rest at `reference` \[m\] that stands for `volume` \[m^D\] of the undeformed
    /// body. A `clamped` one is held along every axis, see [`supports`](crate::supports). Its identity is the number of particles before it.
    pub fn push(&mut self, reference: Vector<T, D>, volume: T, clamped: bool) {
        self.id.push(self.id.len() as u32);
        self.reference.push(reference);
        self.position.push(reference);
        self.velocity.push(Vector::zeros());
        self.volume.push(volume);
        self.mass.push(T::zero());
        self.deformation.push(Tensor::identity());
        self.force.push(Vector::zeros());
        self.held.push(if clamped { (1 << D) - 1 } else { 0 });
        self.group.push(0);
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

    /// Holds particle `i` along `axis`, or lets it go.
    pub fn hold(&mut self, i: usize, axis: usize, held: bool) {
        let bit = 1 << axis;
        self.held[i] = if held { self.held[i] | bit } else { self.held[i] & !bit };
    }

    /// Whether particle `i` is held along every axis.
    pub fn is_clamped(&self, i: usize) -> bool {
        (0..D).all(|axis| self.is_held(i, axis))
    }

    /// Whether particle `i` is held along `axis`.
    pub fn is_held(&self, i: usize, axis: usize) -> bool {
        self.held[i] & (1 << axis) != 0
    }

    /// `vector` without its components along the held axes of particle `i`.
    #[inline]
    pub(crate) fn only_free(&self, i: usize, vector: Vector<T, D>) -> Vector<T, D> {
        if self.held[i] == 0 {
            return vector;
        }
        Vector::from_fn(|axis, _| if self.is_held(i, axis) { T::zero() } else { vector[axis] })
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
        visitor.visit("held", &mut self.held);
        visitor.visit("support", &mut self.group);
        visitor.visit("id", &mut self.id);
    }
}
