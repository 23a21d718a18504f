//! The same bits for any number of threads, on a body of many blocks of the parallel loop.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::block;
use mps_kernel::{FieldVisitor, ParticleStore, Pod, Vector};
use mps_neighbors::Parallel;
use mps_solid::body::Face;
use mps_solid::materials::CorotationalHooke;

/// FNV-1a over the bytes of every field.
struct Hash(u64);

impl FieldVisitor for Hash {
    fn visit<F: Pod + Send + Sync>(&mut self, name: &'static str, field: &mut Vec<F>) {
        for byte in name.bytes().chain(bytemuck::cast_slice::<F, u8>(field).iter().copied()) {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3);
        }
    }
}

fn state_after<const D: usize>(counts: [usize; D], threads: usize, steps: usize) -> (u64, [u64; 4]) {
    let parallel = Parallel::new(threads).unwrap();
    let mut solid = block(counts, &[Face::lower(0)], CorotationalHooke::new(2.0e6, 0.4).unwrap());
    let load: Vec<_> = (0..solid.len())
        .map(|i| Vector::<f64, D>::from_fn(|a, _| 1e-4 * ((i + 3 * a) as f64).sin()))
        .collect();
    let gravity = Vector::<f64, D>::from_fn(|a, _| if a == 1 { -9.81 } else { 0.0 });
    for _ in 0..steps {
        let dt = solid.max_step(&parallel);
        solid.advance(&parallel, &load, &gravity, 5.0 * dt, 5).unwrap();
    }
    let energy = solid.energy(&parallel, &gravity);
    let energy = [energy.kinetic, energy.strain, energy.bending, energy.potential].map(f64::to_bits);
    let mut hash = Hash(0xCBF2_9CE4_8422_2325);
    solid.for_each_field(&mut hash);
    (hash.0, energy)
}

#[test]
fn same_bits_for_any_number_of_threads() {
    // 11 200 and 11 250 particles: 22 blocks of 512.
    let plane = state_after([400, 28], 1, 6);
    let space = state_after([50, 15, 15], 1, 3);
    for threads in [2, 3, 8] {
        assert_eq!(state_after([400, 28], threads, 6), plane, "{threads} threads in the plane");
        assert_eq!(state_after([50, 15, 15], threads, 3), space, "{threads} threads in space");
    }
}

/// Looking at the state (a hash, a checkpoint) must not change what happens next.
#[test]
fn hashing_in_between_changes_nothing() {
    let run = |look: bool| {
        let parallel = Parallel::serial();
        let mut solid = block([20, 4], &[Face::lower(0)], CorotationalHooke::new(2.0e6, 0.4).unwrap());
        let rest = vec![Vector::zeros(); solid.len()];
        for _ in 0..5 {
            let dt = solid.max_step(&parallel);
            solid.advance(&parallel, &rest, &Vector::<f64, 2>::new(0.0, -9.81), 3.0 * dt, 3).unwrap();
            if look {
                solid.for_each_field(&mut Hash(1));
            }
        }
        let mut hash = Hash(2);
        solid.for_each_field(&mut hash);
        hash.0
    };
    assert_eq!(run(true), run(false));
}
