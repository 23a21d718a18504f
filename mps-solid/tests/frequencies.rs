//! Frequencies and modes against the dense spectrum, beam theory and converged elasticity.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::{block, deform};
use core::f64::consts::PI;
use mps_kernel::{Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::materials::{CorotationalHooke, Moduli, SaintVenantKirchhoff};
use mps_solid::matrix::{Mode, Stiffness};
use mps_solid::{ConstitutiveModel, Solid, SolidConfig};

/// A plane strip in whole particles, `across` of them over its height.
fn strip<M: ConstitutiveModel<f64, 2>>(
    size: [f64; 2],
    across: usize,
    density: f64,
    material: M,
) -> Solid<f64, 2, M> {
    let clamp = [Face::lower(0)];
    let (lower, upper) = (Vector::<f64, 2>::zeros(), Vector::<f64, 2>::new(size[0], size[1]));
    let counts = body::counts(&lower, &upper, size[1] / across as f64, &clamp);
    let strip = body::block(lower, upper, counts, &clamp).unwrap();
    let config = SolidConfig::default();
    let parallel = Parallel::serial();
    Solid::new(strip.particles, strip.spacing, density, material, WendlandC2, config, &parallel).unwrap()
}

/// `K phi = omega^2 M phi`, and the masses make the modes orthonormal.
fn are_modes<const D: usize, M: ConstitutiveModel<f64, D>>(solid: &Solid<f64, D, M>, modes: &[Mode<D>]) {
    let stiffness = Stiffness::new(solid).unwrap();
    let largest = stiffness.largest_frequency().unwrap().powi(2);
    for (k, mode) in modes.iter().enumerate() {
        let force = stiffness.multiply(&mode.shape).unwrap();
        let (mut residual, mut size) = (0.0, 0.0);
        for (i, (f, phi)) in force.iter().zip(&mode.shape).enumerate() {
            residual += (f - phi * (mode.square * solid.masses()[i])).norm_squared() / solid.masses()[i];
            size += phi.norm_squared() * solid.masses()[i];
        }
        assert!((size - 1.0).abs() < 1e-9, "mode {k}: modal mass {size}");
        assert!(residual.sqrt() < 1e-7 * mode.square + 1e-13 * largest, "mode {k}: residual^2 {residual:e}");
        for other in &modes[..k] {
            let product = |i: usize| mode.shape[i].dot(&other.shape[i]) * solid.masses()[i];
            let product: f64 = (0..solid.len()).map(product).sum();
            assert!(product.abs() < 1e-10, "mode {k} is not orthogonal to another: {product:e}");
        }
    }
}

fn are_those_of_the_dense_matrix<const D: usize>(counts: [usize; D], clamp: &[Face], count: usize) {
    let solid = block(counts, clamp, CorotationalHooke::new(2.0e6, 0.4).unwrap());
    let stiffness = Stiffness::new(&solid).unwrap();
    let all = stiffness.spectrum().unwrap();
    let largest = all[all.len() - 1];
    let modes = stiffness.lowest(count).unwrap();
    for (mode, square) in modes.iter().zip(&all) {
        let error = (mode.square - square).abs();
        assert!(error < 1e-9 * square.abs() + 1e-13 * largest, "{} is not {square}", mode.square);
    }
    are_modes(&solid, &modes);
    assert!((stiffness.largest_frequency().unwrap() / largest.sqrt() - 1.0).abs() < 1e-5);
    // The same bits again.
    assert_eq!(Stiffness::new(&solid).unwrap().lowest(count).unwrap(), modes);
}

#[test]
fn lowest_modes_are_those_of_the_dense_matrix() {
    are_those_of_the_dense_matrix([16, 4], &[Face::lower(0)], 6);
    are_those_of_the_dense_matrix([16, 4], &[], 10);
    // Six rigid motions and bendings that come in pairs.
    are_those_of_the_dense_matrix([9, 3, 3], &[], 12);
    are_those_of_the_dense_matrix([9, 3, 3], &[Face::lower(0), Face::upper(0)], 5);
    // All of them.
    are_those_of_the_dense_matrix([3, 2], &[], 12);
}

/// Euler-Bernoulli: a clamped strip of 40 to 1 swings at `(k L)^2/L^2 sqrt(E' h^2/(12 rho))`.
#[test]
fn slender_strip_swings_as_beam_theory_says() {
    for (across, nu, tolerance) in [(2, 0.0, 0.02), (3, 0.0, 0.01), (3, 0.45, 0.01), (8, 0.45, 0.004)] {
        let length = 40.0;
        let solid = strip([length, 1.0], across, 1.0, CorotationalHooke::new(1.0, nu).unwrap());
        let modes = Stiffness::new(&solid).unwrap().lowest(2).unwrap();
        for (mode, kl) in modes.iter().zip([1.875104_f64, 4.694091]) {
            let beam = (kl / length).powi(2) * (1.0 / (12.0 * (1.0 - nu * nu))).sqrt();
            let ratio = mode.omega() / beam;
            assert!((ratio - 1.0).abs() < tolerance, "{across} across, nu {nu}: {ratio}");
        }
    }
}

/// Errors of the first period of case 1 (or the same plate with another Poisson's ratio) against its truth in
/// units of `L sqrt(rho/mu)`, quadratic finite elements, see `docs/solid.md`.
fn period_errors(nu: f64, truth: f64) -> [f64; 3] {
    let (shear, density, length): (f64, f64, f64) = (0.715e6, 1000.0, 0.2);
    let moduli = Moduli::new(2.0 * shear * (1.0 + nu), nu).unwrap();
    [5, 10, 20].map(|across| {
        let plate = strip([length, 0.02], across, density, SaintVenantKirchhoff::from(moduli));
        let period = Stiffness::new(&plate).unwrap().lowest(1).unwrap()[0].period();
        period / (length * (density / shear).sqrt() * truth) - 1.0
    })
}

#[test]
fn period_of_the_clamped_plate_converges() {
    // The singularity at the corner of the clamp allows no more than an order of about 1.3.
    let errors = period_errors(0.397515, 34.1363);
    assert!(errors[0].abs() < 7e-3 && errors[2].abs() < 1.2e-3, "{errors:?}");
    for order in [(errors[0] / errors[1]).log2(), (errors[1] / errors[2]).log2()] {
        assert!((1.1..1.6).contains(&order), "order {order} of {errors:?}");
    }
    // Without it the method shows its own.
    let errors = period_errors(0.0, 44.0590);
    assert!(errors[0].abs() < 3e-3 && errors[2].abs() < 2.5e-4, "{errors:?}");
    for order in [(errors[0] / errors[1]).log2(), (errors[1] / errors[2]).log2()] {
        assert!((1.8..2.2).contains(&order), "order {order} of {errors:?}");
    }
}

/// Euler: a strip held at both ends buckles under the strain `4 pi^2 I/(A L^2) = pi^2/3 (h/L)^2`. Its lowest
/// `omega^2` falls to zero there and is negative beyond.
#[test]
fn compressed_strip_buckles() {
    let ends = [Face::lower(0), Face::upper(0)];
    let mut solid = block([60, 3], &ends, CorotationalHooke::new(2.0e6, 0.0).unwrap());
    let spacing = *solid.spacing();
    let slenderness: f64 = 3.0 * spacing.y / (59.0 * spacing.x);
    let critical = PI * PI / 3.0 * slenderness * slenderness;
    let mut lowest = |strain: f64| {
        deform(&mut solid, |x| Vector::<f64, 2>::new(x.x * (1.0 - strain), x.y));
        Stiffness::new(&solid).unwrap().lowest(1).unwrap()[0].square
    };
    let rest = lowest(0.0);
    assert!(lowest(0.9 * critical) > 0.0);
    assert!(lowest(1.1 * critical) < 0.0);
    assert!((lowest(0.5 * critical) / rest - 0.5).abs() < 0.05);
}
