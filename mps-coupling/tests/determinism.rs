//! A coupled scene has the same bits for any number of threads.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{Noise, gate, solid_of};
use mps_fluid::Slip;
use mps_neighbors::{Parallel, state_hash};

fn hashes(threads: usize) -> [u64; 2] {
    let parallel = Parallel::new(threads).unwrap();
    // 4,000 fluid particles, several blocks of the parallel loops; the 4 x 100 of the gate stay on one thread.
    let mut scene = gate([40, 100], Slip::None);
    let mut noise = Noise::new(11);
    scene.fluid_mut().particles_mut().velocity.iter_mut().for_each(|u| *u = noise.vector(0.5));
    for _ in 0..30 {
        scene.step(&parallel, f64::INFINITY).unwrap();
    }
    assert!(scene.fluid().rebuilds() > 1);
    let gate = state_hash(&mut solid_of(&scene).particles().clone());
    [state_hash(scene.fluid_mut().particles_mut()), gate]
}

#[test]
fn a_gate_has_the_same_bits_for_any_number_of_threads() {
    let expected = hashes(1);
    for threads in [2, 3, 8] {
        assert_eq!(hashes(threads), expected, "{threads} threads");
    }
}
