//! One number for the whole state: equal runs have equal numbers.

use bytemuck::Pod;
use mps_kernel::{FieldVisitor, ParticleStore};
use xxhash_rust::xxh3::Xxh3;

/// 64-bit XXH3 of the names, lengths and bytes of all fields, in the order of the store.
///
/// Two runs with equal hashes have, for all practical purposes, equal bits in every field: this is
/// how reproducibility over thread counts and restarts is tested. It is a check, not a signature;
/// it depends on the byte order of the machine.
pub fn state_hash(store: &mut impl ParticleStore) -> u64 {
    let mut hasher = Hasher(Xxh3::new());
    store.for_each_field(&mut hasher);
    hasher.0.digest()
}

struct Hasher(Xxh3);

impl FieldVisitor for Hasher {
    fn visit<F: Pod + Send + Sync>(&mut self, name: &'static str, field: &mut Vec<F>) {
        let bytes: &[u8] = bytemuck::cast_slice(field);
        self.0.update(name.as_bytes());
        // Lengths keep neighbouring fields apart: an entry that changes sides changes the hash.
        self.0.update(&(bytes.len() as u64).to_le_bytes());
        self.0.update(bytes);
    }
}
