//! On irregular bodies, whatever the material: the patch test, and forces without sum and without torque.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::{Noise, deform, rotation};
use mps_kernel::{Tensor, Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::materials::{CorotationalHooke, NearlyIncompressible, NeoHookean, SaintVenantKirchhoff};
use mps_solid::{ConstitutiveModel, Solid, SolidConfig, SolidParticles};
use proptest::prelude::*;

/// A lattice with unequal spacings whose particles are shaken and have unequal volumes.
fn irregular<M: ConstitutiveModel<f64, 2>>(
    counts: [usize; 2],
    ratio: f64,
    noise: &mut Noise,
    material: M,
) -> Solid<f64, 2, M> {
    let spacing = Vector::<f64, 2>::new(0.01 * ratio, 0.01);
    let mut particles = SolidParticles::new();
    for k in 0..counts[0] * counts[1] {
        let place = Vector::<f64, 2>::new((k / counts[1]) as f64, (k % counts[1]) as f64);
        let place = (place + noise.vector::<f64, 2>() * 0.2).component_mul(&spacing);
        particles.push(place, 1e-4 * (1.0 + 0.5 * noise.next()), false);
    }
    let (config, parallel) = (SolidConfig::default(), Parallel::serial());
    Solid::new(particles, spacing, 1000.0, material, WendlandC2, config, &parallel).unwrap()
}

fn check<M: ConstitutiveModel<f64, 2>>(
    counts: [usize; 2],
    ratio: f64,
    seed: u64,
    material: M,
) -> Result<(), TestCaseError> {
    let mut noise = Noise::new(seed);
    let mut solid = irregular(counts, ratio, &mut noise, material);
    let gradient =
        rotation::<f64, 2>(6.0 * noise.next()) * (Tensor::identity() + noise.tensor::<f64, 2>() * 0.4);
    deform(&mut solid, |x| gradient * x);
    for f in solid.particles().deformations() {
        prop_assert!((f - gradient).norm() < 1e-11);
    }

    deform(&mut solid, |x| gradient * x + noise.vector::<f64, 2>() * 5e-4);
    let force = solid.particles().internal_forces();
    let scale: f64 = force.iter().map(|f| f.norm()).sum();
    let sum: Vector<f64, 2> = force.iter().sum();
    let torque: f64 = solid.positions().iter().zip(force).map(|(x, f)| x.x * f.y - x.y * f.x).sum();
    prop_assert!(sum.norm() < 1e-12 * scale, "sum of forces {} of {}", sum.norm(), scale);
    prop_assert!(torque.abs() < 1e-12 * scale * 0.2, "torque {} of {}", torque, scale);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn patch_test_and_momenta_on_irregular_bodies(
        columns in 2_usize..9,
        rows in 2_usize..9,
        ratio in 0.95_f64..1.05,
        nu in -0.4_f64..0.49,
        seed in 0_u64..1_000_000,
    ) {
        check([columns, rows], ratio, seed, CorotationalHooke::new(1e6, nu).unwrap())?;
        check([columns, rows], ratio, seed, SaintVenantKirchhoff::new(1e6, nu).unwrap())?;
        check([columns, rows], ratio, seed, NeoHookean::new(1e6, nu).unwrap())?;
        check([columns, rows], ratio, seed, NearlyIncompressible::new(1e6, nu).unwrap())?;
    }
}
