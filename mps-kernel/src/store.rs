//! How generic code reaches every field of a particle phase.

pub use bytemuck::Pod;

/// Receives the fields of a store one after the other, always in the same order.
pub trait FieldVisitor {
    /// Called once for each field; `name` is unique within the store.
    fn visit<F: Pod + Send + Sync>(&mut self, name: &'static str, field: &mut Vec<F>);
}

/// A structure of arrays: one `Vec` per field, all of the same length.
///
/// Whoever permutes particles into spatial order, hashes the state or writes a checkpoint goes
/// through [`for_each_field`](ParticleStore::for_each_field), so that a new field is moved, hashed
/// and saved from the day it exists.
///
/// ```
/// use mps_kernel::{FieldVisitor, ParticleStore, Pod};
///
/// struct Tracers {
///     position: Vec<[f64; 2]>,
///     id: Vec<u32>,
/// }
///
/// impl ParticleStore for Tracers {
///     fn len(&self) -> usize {
///         self.id.len()
///     }
///     fn for_each_field(&mut self, visitor: &mut impl FieldVisitor) {
///         visitor.visit("position", &mut self.position);
///         visitor.visit("id", &mut self.id);
///     }
/// }
///
/// struct Reverse;
/// impl FieldVisitor for Reverse {
///     fn visit<F: Pod + Send + Sync>(&mut self, _name: &'static str, field: &mut Vec<F>) {
///         field.reverse();
///     }
/// }
///
/// let mut tracers = Tracers { position: vec![[0.0, 0.0], [1.0, 0.0]], id: vec![7, 9] };
/// tracers.for_each_field(&mut Reverse);
/// assert_eq!(tracers.id, [9, 7]);
/// ```
pub trait ParticleStore {
    /// Number of particles.
    fn len(&self) -> usize;

    /// Whether the store holds no particle.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Shows every field that belongs to the particles to `visitor`.
    fn for_each_field(&mut self, visitor: &mut impl FieldVisitor);
}
