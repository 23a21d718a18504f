//! The same bits for any number of threads and any vector instructions.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{Noise, everything, tank, vibrating_step, water};
use mps_fluid::{ArtificialViscosity, Shifting};
use mps_kernel::Real;
use mps_neighbors::{Parallel, state_hash};

/// Hashes after every tenth of 30 steps of a dam break of 12,600 particles: the plain form with filter, collisions and shifting.
fn hashes(parallel: &Parallel) -> Vec<u64> {
    let mut config = water::<f64, 2>(0.01, 1.05);
    config.shifting = Some(Shifting { strength: 2.0, iterations: 2 });
    let c = config.sound_speed;
    let mut fluid = tank([120, 105], config, |r| ArtificialViscosity::new::<2>(0.05, c, r));
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

/// Hashes of particles, forces and books after three and six steps of all that the dam break has not.
fn hashes_of_everything<T: Real, const D: usize>(parallel: &Parallel, counts: [usize; D]) -> Vec<String> {
    let mut fluid = everything::<T, D>(counts);
    assert!(fluid.particles().id.len() > 4 * 512, "several blocks of the parallel loops");
    (0..2)
        .map(|_| {
            for _ in 0..3 {
                vibrating_step(&mut fluid, parallel);
            }
            let block = fluid.boundary().reactive();
            let force = fluid.boundary().force[block.clone()].iter().sum::<mps_kernel::Vector<T, D>>();
            assert!(force.norm() > T::zero(), "the block is felt");
            let now = block.map(|a| fluid.force_on(a)).sum::<mps_kernel::Vector<T, D>>();
            let budget = fluid.budget().unwrap();
            // Every bit of a number is in its shortest name.
            format!("{} {force:?} {now:?} {budget:?}", state_hash(fluid.particles_mut()))
        })
        .collect()
}

fn same_for_any_threads<T: Real, const D: usize>(counts: [usize; D]) {
    let expected = hashes_of_everything::<T, D>(&Parallel::serial(), counts);
    for threads in [2, 3, 8] {
        let found = hashes_of_everything::<T, D>(&Parallel::new(threads).unwrap(), counts);
        assert_eq!(found, expected, "{threads} threads");
    }
    let portable = Parallel::new(2).unwrap().portable();
    assert_eq!(hashes_of_everything::<T, D>(&portable, counts), expected, "without vector instructions");
}

#[test]
fn and_so_has_everything_that_a_dam_break_has_not() {
    same_for_any_threads::<f64, 2>([60, 45]);
    same_for_any_threads::<f32, 2>([60, 45]);
}

#[test]
fn and_in_space() {
    same_for_any_threads::<f32, 3>([15, 14, 13]);
    same_for_any_threads::<f64, 3>([15, 14, 13]);
}
