//! The fields of the fluid particles.

use mps_kernel::{FieldVisitor, ParticleStore, Real, Vector};

/// The fluid phase as a structure of arrays.
///
/// All particles have the same mass `rho0 l0^D`. Particles are permuted into spatial order now and
/// then; [`id`](FluidParticles::id) follows them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FluidParticles<T: Real, const D: usize> {
    /// Position \[m\].
    pub position: Vec<Vector<T, D>>,
    /// Velocity \[m/s\].
    pub velocity: Vec<Vector<T, D>>,
    /// Particle number density over its reference value, `n/n0` \[-\].
    pub density: Vec<T>,
    /// Pressure \[Pa\], from the equation of state.
    pub pressure: Vec<T>,
    /// Number of the particle in the order it was created in.
    pub id: Vec<u32>,
}

impl<T: Real, const D: usize> FluidParticles<T, D> {
    /// Particles at rest at reference density.
    pub fn at_rest(positions: Vec<Vector<T, D>>) -> Self {
        let len = positions.len();
        Self {
            position: positions,
            velocity: vec![Vector::zeros(); len],
            density: vec![T::one(); len],
            pressure: vec![T::zero(); len],
            id: (0..len as u32).collect(),
        }
    }

    /// Adds a particle.
    pub(crate) fn push(
        &mut self,
        position: Vector<T, D>,
        velocity: Vector<T, D>,
        density: T,
        pressure: T,
        id: u32,
    ) {
        self.position.push(position);
        self.velocity.push(velocity);
        self.density.push(density);
        self.pressure.push(pressure);
        self.id.push(id);
    }
}

impl<T: Real, const D: usize> ParticleStore for FluidParticles<T, D> {
    fn len(&self) -> usize {
        self.position.len()
    }

    fn for_each_field(&mut self, visitor: &mut impl FieldVisitor) {
        visitor.visit("position", &mut self.position);
        visitor.visit("velocity", &mut self.velocity);
        visitor.visit("density", &mut self.density);
        visitor.visit("pressure", &mut self.pressure);
        visitor.visit("id", &mut self.id);
    }
}
