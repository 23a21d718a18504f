//! A free body has exactly its rigid motions at frequency zero, and nothing spurious near them, on
//! regular and on disturbed particles, from auxetic to almost incompressible.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::Noise;
use mps_kernel::{Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::materials::CorotationalHooke;
use mps_solid::matrix::Stiffness;
use mps_solid::{Solid, SolidConfig, SolidParticles, body};

/// A block of unit spacing whose particles are displaced at random by up to `size` in every direction
/// before the body is built. Volumes stay those of the lattice.
fn disturbed<const D: usize>(
    counts: [usize; D],
    nu: f64,
    size: f64,
    seed: u64,
) -> Solid<f64, D, CorotationalHooke<f64>> {
    let upper = Vector::<f64, D>::from_fn(|axis, _| counts[axis] as f64);
    let lattice = body::block(Vector::zeros(), upper, counts, &[]).unwrap();
    let mut noise = Noise::new(seed);
    let mut particles = SolidParticles::new();
    for x in lattice.particles.reference_positions() {
        particles.push(x + noise.vector::<f64, D>() * (2.0 * size), 1.0, false);
    }
    let material = CorotationalHooke::new(1.0, nu).unwrap();
    let config = SolidConfig::default();
    Solid::new(particles, lattice.spacing, 1.0, material, WendlandC2, config, &Parallel::serial()).unwrap()
}

/// The lowest `omega^2` beside zero of the regular body with `nu = 0`: no locking, nothing disturbed.
fn slowest_of_the_lattice<const D: usize>(counts: [usize; D]) -> f64 {
    Stiffness::new(&disturbed(counts, 0.0, 0.0, 0)).unwrap().spectrum().unwrap()[D * (D + 1) / 2]
}

/// Zero is what is below `1e-12` of the largest. The slowest frequency may fall with the disturbance (the
/// table in `docs/solid.md`), but a mode that is held by nothing would be slower by orders of magnitude.
fn has_only_rigid_zero_modes<const D: usize>(counts: [usize; D], nu: f64, size: f64) {
    let rigid = D * (D + 1) / 2;
    let expected = slowest_of_the_lattice(counts);
    let (seeds, least, most) = if size == 0.0 { (1, 0.6, 1.02) } else { (3, 0.2, 1.05) };
    for seed in 0..seeds {
        let solid = disturbed(counts, nu, size, seed);
        let squares = Stiffness::new(&solid).unwrap().spectrum().unwrap();
        let largest = squares[squares.len() - 1];
        for square in &squares[..rigid] {
            assert!(
                square.abs() < 1e-12 * largest,
                "{counts:?}, nu {nu}: rigid mode {square:e} of {largest:e}"
            );
        }
        let slowest = squares[rigid] / expected;
        assert!(slowest > least, "{counts:?}, nu {nu}, {size}: slowest elastic mode at {slowest}");
        // The estimate made at set-up approaches the largest frequency from below.
        let limit = solid.stability_limit() * largest.sqrt() / 2.0;
        assert!(
            (0.9999..most).contains(&limit),
            "{counts:?}, nu {nu}, {size}: stability limit off by {limit}"
        );
    }
}

#[test]
fn plane_bodies_have_three() {
    for counts in [[2, 2], [6, 6], [12, 2], [12, 3], [13, 4], [9, 8]] {
        for nu in [-0.4, 0.0, 0.3, 0.47, 0.4999] {
            for size in [0.0, 0.1, 0.2] {
                has_only_rigid_zero_modes(counts, nu, size);
            }
        }
    }
}

#[test]
fn bodies_in_space_have_six() {
    for counts in [[2, 2, 2], [4, 4, 4], [6, 2, 2], [5, 4, 2], [7, 3, 3]] {
        for nu in [-0.4, 0.0, 0.4, 0.4999] {
            for size in [0.0, 0.15] {
                has_only_rigid_zero_modes(counts, nu, size);
            }
        }
    }
}
