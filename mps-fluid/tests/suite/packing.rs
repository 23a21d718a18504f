//! A packing that has been measured stays that of its particle.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{Noise, tank, water};
use mps_neighbors::Parallel;

#[test]
fn the_packing_follows_its_particle_into_another_order() {
    let parallel = Parallel::serial();
    let mut fluid = tank([15, 12], water::<f64, 2>(0.01, 0.12), |_| ());
    let mut noise = Noise::new(3);
    fluid.particles_mut().velocity.iter_mut().for_each(|u| *u = noise.vector(1.0));
    fluid.step(&parallel).unwrap();
    fluid.measure_packing(&parallel).unwrap();
    let ids = fluid.particles().id.clone();
    let mut measured = vec![0.0; ids.len()];
    ids.iter().zip(fluid.packing()).for_each(|(id, packing)| measured[*id as usize] = *packing);
    assert!(measured.iter().any(|packing| (packing - measured[0]).abs() > 0.1), "they differ");
    let rebuilds = fluid.rebuilds();
    while fluid.particles().id == ids {
        fluid.step(&parallel).unwrap();
    }
    assert!(fluid.rebuilds() > rebuilds);
    for (id, packing) in fluid.particles().id.iter().zip(fluid.packing()) {
        assert_eq!(*packing, measured[*id as usize], "particle {id}");
    }
}
