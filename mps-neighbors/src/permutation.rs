//! Moving particles in memory, so that neighbours in space are neighbours in the cache.

use crate::NeighborError;
use crate::halves::in_pool;
use bytemuck::Pod;
use mps_kernel::{FieldVisitor, ParticleStore};

/// Puts every field of a store into a new order; keeps its scratch memory for the next time.
///
/// Called inside [`Parallel::install`](crate::Parallel::install) it uses the threads of that pool.
///
/// ```
/// use mps_neighbors::Permutation;
///
/// let mut names = vec![b'a', b'b', b'c'];
/// Permutation::default().apply_to(&mut names, &[2, 0, 1])?;
/// assert_eq!(names, [b'c', b'a', b'b']);
/// # Ok::<(), mps_neighbors::NeighborError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Permutation {
    /// Wide integers, so that any field type of up to their alignment can be laid over them.
    scratch: Vec<u128>,
    seen: Vec<u64>,
}

impl Permutation {
    /// Entry `k` of every field becomes what entry `order[k]` was.
    ///
    /// # Errors
    /// If `order` is no permutation of the particles or a field has another length. Nothing has
    /// been moved then.
    pub fn apply(&mut self, store: &mut impl ParticleStore, order: &[u32]) -> Result<(), NeighborError> {
        self.check(order)?;
        let mut lengths = Lengths { expected: order.len(), result: Ok(()) };
        store.for_each_field(&mut lengths);
        lengths.result?;
        store.for_each_field(&mut Mover { scratch: &mut self.scratch, order });
        Ok(())
    }

    /// Entry `k` of `field` becomes what entry `order[k]` was.
    ///
    /// # Errors
    /// If `order` is no permutation of the entries. Nothing has been moved then.
    pub fn apply_to<F: Pod + Send + Sync>(
        &mut self,
        field: &mut Vec<F>,
        order: &[u32],
    ) -> Result<(), NeighborError> {
        self.check(order)?;
        let mut lengths = Lengths { expected: order.len(), result: Ok(()) };
        lengths.visit("field", field);
        lengths.result?;
        Mover { scratch: &mut self.scratch, order }.visit("field", field);
        Ok(())
    }

    /// Bytes of scratch memory.
    pub fn bytes(&self) -> usize {
        self.scratch.capacity() * size_of::<u128>() + self.seen.capacity() * size_of::<u64>()
    }

    /// A particle named twice would silently replace another one.
    fn check(&mut self, order: &[u32]) -> Result<(), NeighborError> {
        self.seen.clear();
        self.seen.resize(order.len().div_ceil(64), 0);
        for (entry, &particle) in order.iter().enumerate() {
            let bit = 1 << (particle % 64);
            match self.seen.get_mut(particle as usize / 64) {
                Some(word) if *word & bit == 0 && (particle as usize) < order.len() => *word |= bit,
                _ => return Err(NeighborError::NoPermutation { entry, particle }),
            }
        }
        Ok(())
    }
}

struct Lengths {
    expected: usize,
    result: Result<(), NeighborError>,
}

impl FieldVisitor for Lengths {
    fn visit<F: Pod + Send + Sync>(&mut self, name: &'static str, field: &mut Vec<F>) {
        let (expected, found) = (self.expected, field.len());
        if found != expected && self.result.is_ok() {
            self.result = Err(NeighborError::Length { field: name, expected, found });
        }
    }
}

struct Mover<'a> {
    scratch: &'a mut Vec<u128>,
    order: &'a [u32],
}

impl FieldVisitor for Mover<'_> {
    fn visit<F: Pod + Send + Sync>(&mut self, _name: &'static str, field: &mut Vec<F>) {
        let bytes = size_of_val(field.as_slice());
        let words = bytes.div_ceil(size_of::<u128>());
        if self.scratch.len() < words {
            self.scratch.resize(words, 0);
        }
        let raw = &mut bytemuck::cast_slice_mut::<u128, u8>(&mut self.scratch[..words])[..bytes];
        match bytemuck::try_cast_slice_mut::<u8, F>(raw) {
            Ok(moved) => permute(field, moved, self.order),
            // Aligned more strictly than the scratch, or without size: not worth a second buffer.
            Err(_) => {
                let mut moved = field.clone();
                permute(field, &mut moved, self.order);
            }
        }
    }
}

/// Gathers `field` into `moved` and copies it back.
fn permute<F: Pod + Send + Sync>(field: &mut [F], moved: &mut [F], order: &[u32]) {
    in_pool(&mut *moved, &|k, to: &mut F| *to = field[order[k] as usize]);
    let moved = &*moved;
    in_pool(field, &|k, to: &mut F| *to = moved[k]);
}
