//! Only ratios of densities and stiffnesses count.

use crate::scene::{V, block};
use mps_neighbors::Parallel;
use mps_solid::materials::SaintVenantKirchhoff;

/// Places of a swinging strip after 1000 steps of a fixed part of its limit, for a density and a Young's modulus.
fn swung(density: f64, modulus: f64) -> (f64, Vec<V>) {
    let serial = Parallel::serial();
    let material = SaintVenantKirchhoff::new(modulus, 0.3).unwrap();
    let mut solid = block::<f64, 2, _>([12, 3], &[], material, density, 0.8);
    let speed = 0.05 * (modulus / density).sqrt();
    let start: Vec<V> = solid.positions().iter().map(|x| V::new(0.0, speed * (0.3 * x.x).sin())).collect();
    solid.velocities_mut().copy_from_slice(&start);
    let rest = vec![V::zeros(); solid.len()];
    let dt = 0.6 * (density / modulus).sqrt();
    solid.advance(&serial, &rest, &V::zeros(), 1000.0 * dt, 1000).unwrap();
    (solid.stability_limit() * (modulus / density).sqrt(), solid.positions().to_vec())
}

/// Only ratios count: density from 0.05 to 50 times that of water, stiffness over six decades.
#[test]
fn density_and_stiffness_change_nothing_but_the_time() {
    let (limit0, places0) = swung(1000.0, 1e6);
    for (density, modulus) in [(50.0, 1e6), (50_000.0, 1e6), (1000.0, 1e4), (1000.0, 1e10), (777.0, 3.3e7)] {
        let (limit, places) = swung(density, modulus);
        assert!((limit / limit0 - 1.0).abs() < 1e-10, "limit {limit} of {limit0} at {density}, {modulus}");
        let apart = places.iter().zip(&places0).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
        assert!(apart < 1e-9, "{apart:e} spacings at {density}, {modulus}");
    }
}
