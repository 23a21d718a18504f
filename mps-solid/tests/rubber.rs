//! The nearly incompressible rubber: in tension as the books say, and not to be squeezed to nothing.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use approx::assert_relative_eq;
use mps_kernel::{Tensor, Vector};
use mps_neighbors::Parallel;
use mps_solid::ConstitutiveModel;
use mps_solid::materials::{MaterialError, NearlyIncompressible};

/// Shear modulus \[Pa\].
const MU: f64 = 4.0e5;

/// `J` and the tension `P_11` of a bar stretched by `s` whose sides are free, in principal stretches.
/// `free` directions are free to become thinner (2 in a bar, 1 in plane strain). Kirchhoff's stress along
/// a principal stretch `t` is `mu J^(-2/3) (t^2 - I1/3) + K/2 (J^2 - 1)`; that of the sides is zero.
fn tension(bulk: f64, s: f64, free: u8) -> (f64, f64) {
    let lateral = |t: f64| {
        let (t2, n) = (t * t, f64::from(free));
        let j = s * t.powi(i32::from(free));
        let i1 = s * s + n * t2 + (2.0 - n);
        let (shape, pressure) = (MU * j.powf(-2.0 / 3.0), bulk / 2.0 * (j * j - 1.0));
        (shape * (t2 - i1 / 3.0) + pressure, j, (shape * (s * s - i1 / 3.0) + pressure) / s)
    };
    let (mut low, mut high) = (0.05, 5.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if lateral(middle).0 < 0.0 { low = middle } else { high = middle }
    }
    let (rest, j, p) = lateral(low);
    assert!(rest.abs() < 1e-8 * bulk, "{rest}");
    (j, p)
}

/// The stress of the model in the state that `tension` finds.
fn model<const D: usize>(bulk: f64, s: f64, free: u8) -> Tensor<f64, D> {
    let rubber = NearlyIncompressible::from_shear_and_bulk(MU, bulk).unwrap();
    let (j, _) = tension(bulk, s, free);
    let thin = (j / s).powf(1.0 / f64::from(free));
    let f = Tensor::from_fn(|a, b| match (a == b, a) {
        (true, 0) => s,
        (true, _) => thin,
        _ => 0.0,
    });
    rubber.first_piola(&f, &mut (), 0.0)
}

#[test]
fn tension_with_free_sides() {
    for bulk in [MU, 10.0 * MU, 1000.0 * MU] {
        for s in [0.3, 0.7, 0.999, 1.3, 2.0, 4.0] {
            let (_, bar) = tension(bulk, s, 2);
            let (_, plane) = tension(bulk, s, 1);
            let space = model::<3>(bulk, s, 2);
            let strip = model::<2>(bulk, s, 1);
            assert_relative_eq!(space[(0, 0)], bar, max_relative = 1e-8, epsilon = 1e-6 * MU);
            assert_relative_eq!(strip[(0, 0)], plane, max_relative = 1e-8, epsilon = 1e-6 * MU);
            assert!(space[(1, 1)].abs() + space[(2, 2)].abs() + strip[(1, 1)].abs() < 1e-7 * bulk);
        }
    }
}

/// `P = mu (s - s^-2)` and, in plane strain, `mu (s - s^-3)`: Treloar, The Physics of Rubber Elasticity.
#[test]
fn a_stiff_volume_leads_to_incompressible_rubber() {
    let bulk = 1e5 * MU;
    for s in [0.5_f64, 0.9, 1.1, 1.5, 3.0] {
        let space = model::<3>(bulk, s, 2)[(0, 0)];
        let strip = model::<2>(bulk, s, 1)[(0, 0)];
        assert_relative_eq!(space, MU * (s - s.powi(-2)), max_relative = 1e-3);
        assert_relative_eq!(strip, MU * (s - s.powi(-3)), max_relative = 1e-3);
    }
}

/// Young's modulus of the undeformed state is the slope of the bar's tension.
#[test]
fn both_ways_in_agree() {
    let (young, nu) = (1.2e6, 0.46);
    let rubber = NearlyIncompressible::new(young, nu).unwrap();
    assert_relative_eq!(rubber.bulk, young / (3.0 * (1.0 - 2.0 * nu)), max_relative = 1e-12);
    assert_relative_eq!(rubber.shear, young / (2.0 * (1.0 + nu)), max_relative = 1e-12);
    let ratio = rubber.bulk / rubber.shear;
    let slope = (tension(ratio * MU, 1.0 + 1e-4, 2).1 - tension(ratio * MU, 1.0 - 1e-4, 2).1) / 2e-4;
    assert_relative_eq!(slope / MU, young / rubber.shear, max_relative = 1e-5);
    assert!(matches!(NearlyIncompressible::new(1e6, 0.5), Err(MaterialError::PoissonRatio(_))));
    assert!(NearlyIncompressible::from_shear_and_bulk(0.0, 1.0).is_err());
    assert!(NearlyIncompressible::from_shear_and_bulk(1.0, f64::NAN).is_err());
}

fn grows_without_bound<const D: usize>(squeeze: impl Fn(f64) -> Tensor<f64, D>) {
    let rubber = NearlyIncompressible::new(1e6, 0.49).unwrap();
    let (mut pressure, mut energy) = (0.0, 0.0);
    for k in 1..12 {
        let f = squeeze(0.2_f64.powi(k));
        let p = -rubber.first_piola(&f, &mut (), 0.0)[(0, 0)];
        let w = rubber.energy(&f, &());
        assert!(p > 1.5 * pressure && w > energy, "{k}: {p} after {pressure}, {w} after {energy}");
        (pressure, energy) = (p, w);
    }
    assert!(pressure > 1e3 * rubber.bulk && energy > 10.0 * rubber.bulk);
}

#[test]
fn compression_to_nothing_is_resisted() {
    grows_without_bound(|s| Tensor::<f64, 2>::identity() * s);
    grows_without_bound(|s| Tensor::<f64, 3>::identity() * s);
    // Flattened along one axis only.
    let flat = |s: f64| {
        move |a, b| {
            if a != b {
                0.0
            } else if a == 0 {
                s
            } else {
                1.0
            }
        }
    };
    grows_without_bound(|s| Tensor::<f64, 2>::from_fn(flat(s)));
    grows_without_bound(|s| Tensor::<f64, 3>::from_fn(flat(s)));
}

/// Pressed to half of its area a block does not turn inside out; it keeps its energy on the way back.
#[test]
fn a_squeezed_block_springs_back() {
    let parallel = Parallel::serial();
    let mut solid = common::block([9, 9], &[], NearlyIncompressible::new(1e6, 0.45).unwrap());
    common::deform(&mut solid, |x| x * 0.7);
    let rest = vec![Vector::<f64, 2>::zeros(); solid.len()];
    let energy = |solid: &mps_solid::Solid<f64, 2, _>| solid.energy(&parallel, &Vector::zeros()).total();
    let before = energy(&solid);
    let dt = 0.2 * solid.stability_limit();
    for _ in 0..200 {
        solid.advance(&parallel, &rest, &Vector::zeros(), dt, 1).unwrap();
    }
    let after = energy(&solid);
    assert!((after / before - 1.0).abs() < 0.01, "{before} J, later {after} J");
}
