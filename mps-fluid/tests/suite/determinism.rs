//! The same bits for any number of threads and any vector instructions.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{Noise, tank, water};
use mps_fluid::{ArtificialViscosity, CompletedViscosity, Shifting};
use mps_neighbors::{Parallel, state_hash};

/// Hashes after every tenth of 30 steps of a dam break of 12,600 particles with all options on.
fn hashes(parallel: &Parallel) -> Vec<u64> {
    let mut config = water::<f64, 2>(0.01, 1.05);
    config.shifting = Some(Shifting { strength: 2.0, iterations: 2 });
    let c = config.sound_speed;
    let mut fluid =
        tank([120, 105], config, |r| CompletedViscosity(ArtificialViscosity::new::<2>(0.05, c, r)));
    // Fast enough for several rebuilds, and for collisions.
    let mut noise = Noise::new(3);
    fluid.particles_mut().velocity.iter_mut().for_each(|u| *u = noise.vector(2.0));
    assert!(fluid.particles().id.len() > 20 * 512, "many blocks of the parallel loops");
    let found = (0..3)
        .map(|_| {
            for _ in 0..10 {
                fluid.step(parallel).unwrap();
            }
            state_hash(fluid.particles_mut())
        })
        .collect();
    assert!(fluid.rebuilds() >= 4, "{} rebuilds", fluid.rebuilds());
    found
}

#[test]
fn a_dam_break_has_the_same_bits_for_any_threads_and_instructions() {
    let expected = hashes(&Parallel::serial());
    assert!(expected.windows(2).all(|w| w[0] != w[1]), "the hash sees the motion");
    for threads in [2, 3, 8] {
        assert_eq!(hashes(&Parallel::new(threads).unwrap()), expected, "{threads} threads");
    }
    assert_eq!(hashes(&Parallel::new(2).unwrap().portable()), expected, "without vector instructions");
}
