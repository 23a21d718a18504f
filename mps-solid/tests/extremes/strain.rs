//! Compression and stretch up to the limits of the laws.

use crate::common::Noise;
use crate::scene::{SIDES, V, block, moduli, stays};
use mps_neighbors::Parallel;
use mps_solid::materials::{CorotationalHooke, NearlyIncompressible, NeoHookean, SaintVenantKirchhoff};
use mps_solid::{ConstitutiveModel, Placement, SolidError};

/// Stretched by supports that move slowly and come back: energy at the end over that under the largest strain.
fn left_after<M: ConstitutiveModel<f64, 2>>(material: M, stretch: f64, cfl: f64) -> Result<f64, SolidError> {
    let (length, serial) = (11.0, Parallel::serial());
    let mut solid = block::<f64, 2, _>([12, 6], &SIDES, material, 1.0, cfl);
    let way = 100.0 * length;
    let shift =
        move |t: f64| 0.5 * (stretch - 1.0) * length * (1.0 - (core::f64::consts::PI * t / way).cos());
    solid.move_supports(|x| x.x > 0.0, move |t| Placement::shifted(V::new(shift(t), 0.0)))?;
    // A lattice that is exactly even would stay on the ridge.
    let mut noise = Noise::new(2);
    solid.velocities_mut().iter_mut().for_each(|u| *u = noise.vector::<f64, 2>() * 1e-3);
    let (rest, zero) = (vec![V::zeros(); solid.len()], V::zeros());
    let mut most = 0.0_f64;
    for _ in 0..100 {
        let interval = 0.02 * way;
        let substeps = (interval / solid.max_step(&serial)).ceil() as usize;
        solid.advance(&serial, &rest, &zero, interval, substeps)?;
        most = most.max(solid.energy(&serial, &zero).total());
    }
    Ok(solid.energy(&serial, &zero).total() / most)
}

fn is_inverted(outcome: Result<f64, SolidError>) -> bool {
    matches!(outcome, Err(SolidError::Inverted { determinant, .. }) if determinant <= 0.0)
}

/// Hooke's law loses its resistance to shear under compression to `nu/(1 - nu)` between rollers; Saint Venant-Kirchhoff's
/// before its stress has its maximum at `sqrt(1/3)`. What is above comes back without a loss.
#[test]
fn laws_for_small_strain_carry_compression_to_their_limit_and_collapse_beyond() {
    let (hooke, venant) = (CorotationalHooke::from(moduli(0.3)), SaintVenantKirchhoff::from(moduli(0.3)));
    // nu/(1 - nu) = 0.429; just beyond it the body shears sideways and does not find back without a loss.
    assert!(left_after(hooke, 0.44, 0.8).unwrap() < 1e-5);
    assert!(left_after(hooke, 0.40, 0.8).unwrap() > 1e-3);
    assert!(is_inverted(left_after(hooke, 0.36, 0.8)));
    // 0.706 for the material, 0.685 for a body as coarse as this.
    assert!(left_after(venant, 0.71, 0.8).unwrap() < 1e-5);
    assert!(is_inverted(left_after(venant, 0.65, 0.8)));
}

#[test]
fn laws_for_large_strain_carry_compression_to_three_tenths_and_fourfold_stretch() {
    let (neo, rubber) = (NeoHookean::from(moduli(0.3)), NearlyIncompressible::from(moduli(0.3)));
    for stretch in [0.3, 4.0] {
        assert!(left_after(neo, stretch, 0.35).unwrap() < 1e-6, "{stretch}");
        assert!(left_after(rubber, stretch, 0.35).unwrap() < 1e-6, "{stretch}");
    }
    // The step of the undeformed body is too long for the flattened one.
    assert!(left_after(neo, 0.3, 0.8).is_err());
}

#[test]
fn the_limit_measured_again_is_the_border_of_the_stretched_body() {
    let serial = Parallel::serial();
    let mut solid = block::<f64, 2, _>([12, 6], &SIDES, NeoHookean::from(moduli(0.3)), 1.0, 0.8);
    let at_rest = solid.stability_limit();
    solid.positions_mut().iter_mut().for_each(|x| x.x *= 0.3);
    let there = solid.positions().to_vec();
    let limit = solid.remeasure_stability(&serial).unwrap();
    assert_eq!(solid.positions(), there);
    assert_eq!(solid.stability_limit(), limit);
    assert!((0.35..0.45).contains(&(limit / at_rest)), "{limit} of {at_rest}");
    assert!(stays(&solid, 0.97 * limit, 1e-6));
    assert!(!stays(&solid, 1.03 * limit, 1e-6));
}
