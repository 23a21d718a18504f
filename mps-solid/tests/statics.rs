//! Static equilibria against beam theory and finite elements.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::{Noise, block};
use mps_kernel::{Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::materials::{CorotationalHooke, NeoHookean, SaintVenantKirchhoff};
use mps_solid::matrix::{MatrixError, Newton, Stiffness};
use mps_solid::{ConstitutiveModel, Solid, SolidConfig, SolidError};

/// A beam of 0.35 m by 0.02 m, `E = 1.4` MPa, `nu = 0.4`, plane strain, held at one end.
const LENGTH: f64 = 0.35;
const HEIGHT: f64 = 0.02;
const DENSITY: f64 = 1250.0;
/// Its weight is 10 N/m.
const GRAVITY: f64 = -10.0 / (DENSITY * HEIGHT);
/// Deflection of its end \[m\] by finite elements, linear and Saint Venant-Kirchhoff.
const LINEAR: f64 = 0.01685205;
const FINITE: f64 = 0.0168213;

fn beam<M: ConstitutiveModel<f64, 2>>(across: usize, material: M) -> Solid<f64, 2, M> {
    let clamp = [Face::lower(0)];
    let (lower, upper) = (Vector::<f64, 2>::zeros(), Vector::<f64, 2>::new(LENGTH, HEIGHT));
    let counts = body::counts(&lower, &upper, HEIGHT / across as f64, &clamp);
    let beam = body::block(lower, upper, counts, &clamp).unwrap();
    let config = SolidConfig::default();
    let parallel = Parallel::serial();
    Solid::new(beam.particles, beam.spacing, DENSITY, material, WendlandC2, config, &parallel).unwrap()
}

/// Mean displacement of the last two columns, extrapolated to the end.
fn tip<M: ConstitutiveModel<f64, 2>>(solid: &Solid<f64, 2, M>, u: &[Vector<f64, 2>]) -> f64 {
    let column = |k: f64| {
        let x = LENGTH - k * solid.spacing().x;
        let all = solid.particles().reference_positions().iter().zip(u);
        let (mut sum, mut count) = (0.0, 0.0);
        for (_, u) in all.filter(|(place, _)| (place.x - x).abs() < 0.1 * solid.spacing().x) {
            (sum, count) = (sum - u.y, count + 1.0);
        }
        sum / count
    };
    1.5 * column(0.5) - 0.5 * column(1.5)
}

fn displacements<const D: usize, M: ConstitutiveModel<f64, D>>(
    solid: &Solid<f64, D, M>,
) -> Vec<Vector<f64, D>> {
    solid.positions().iter().zip(solid.particles().reference_positions()).map(|(x, x0)| x - x0).collect()
}

#[test]
fn beam_sags_under_its_own_weight() {
    let parallel = Parallel::serial();
    let gravity = Vector::<f64, 2>::new(0.0, GRAVITY);
    let mut errors = Vec::new();
    for across in [4, 8, 16] {
        let mut solid = beam(across, SaintVenantKirchhoff::new(1.4e6, 0.4).unwrap());
        let weight: Vec<_> = solid.masses().iter().map(|m| gravity * *m).collect();
        let u = Stiffness::new(&solid).unwrap().solve(&weight).unwrap();
        let linear = tip(&solid, &u) / LINEAR - 1.0;
        let no_load = vec![Vector::zeros(); solid.len()];
        Newton::default().equilibrium(&mut solid, &parallel, &no_load, &gravity).unwrap();
        let finite = tip(&solid, &displacements(&solid)) / FINITE - 1.0;
        // The body pulls at its support with what it weighs, less what the support carries itself.
        let (mut pull, mut weight) = (0.0, 0.0);
        for i in 0..solid.len() {
            if solid.particles().is_clamped(i) {
                pull += solid.particles().internal_forces()[i].y;
            } else {
                weight += solid.masses()[i] * GRAVITY;
            }
        }
        assert!((pull / weight - 1.0).abs() < 1e-7, "{pull} for {weight}");
        errors.push([linear, finite]);
    }
    for (errors, bound) in errors.iter().zip([0.016, 0.003, 0.0007]) {
        assert!(errors.iter().all(|error| error.abs() < bound), "{errors:?} above {bound}");
        // The geometry is nonlinear to the same accuracy: the errors are those of the resolution.
        assert!((errors[0] - errors[1]).abs() < 1e-4, "{errors:?}");
    }
}

/// The end of the beam hangs down by most of its length: reached in several parts.
#[test]
fn large_deflection_stays_and_goes_back() {
    let parallel = Parallel::serial();
    let mut solid = beam(3, NeoHookean::new(1.4e6, 0.4).unwrap());
    let gravity = Vector::<f64, 2>::new(0.0, 60.0 * GRAVITY);
    let no_load = vec![Vector::zeros(); solid.len()];
    Newton::default().equilibrium(&mut solid, &parallel, &no_load, &gravity).unwrap();
    let rest = solid.positions().to_vec();
    let deflection = tip(&solid, &displacements(&solid));
    assert!(deflection > 0.7 * LENGTH, "{deflection}");
    assert!(solid.velocities().iter().all(|u| u.norm() == 0.0));
    // It stays, and falls back to where it was when the load is gone.
    let dt = solid.max_step(&parallel);
    solid.advance(&parallel, &no_load, &gravity, 200.0 * dt, 200).unwrap();
    let moved = solid.positions().iter().zip(&rest).map(|(x, x0)| (x - x0).norm()).fold(0.0, f64::max);
    assert!(moved < 1e-7 * LENGTH, "{moved}");
    Newton::default().equilibrium(&mut solid, &parallel, &no_load, &Vector::zeros()).unwrap();
    let left = displacements(&solid).iter().map(|u| u.norm()).fold(0.0, f64::max);
    assert!(left < 1e-6 * LENGTH, "{left}");
}

#[test]
fn body_in_space_settles() {
    let parallel = Parallel::serial();
    let mut solid = block([12, 3, 4], &[Face::lower(0)], CorotationalHooke::new(2.0e6, 0.45).unwrap());
    let mut noise = Noise::new(4);
    let force: Vec<_> = (0..solid.len()).map(|_| noise.vector::<f64, 3>() * 0.1).collect();
    let gravity = Vector::<f64, 3>::new(0.0, -100.0, 40.0);
    Newton::default().equilibrium(&mut solid, &parallel, &force, &gravity).unwrap();
    for i in (0..solid.len()).filter(|&i| !solid.particles().is_clamped(i)) {
        let left = solid.particles().internal_forces()[i] + force[i] + gravity * solid.masses()[i];
        assert!(left.norm() < 1e-8, "{left}");
    }
}

#[test]
fn what_cannot_rest_is_told() {
    let parallel = Parallel::serial();
    let material = CorotationalHooke::new(1.4e6, 0.4).unwrap();
    let mut free = block([6, 4], &[], material);
    let no_load = vec![Vector::zeros(); free.len()];
    let gravity = Vector::<f64, 2>::new(0.0, -10.0);
    let newton = Newton::default();
    let error = newton.equilibrium(&mut free, &parallel, &no_load, &gravity).unwrap_err();
    assert!(matches!(error, MatrixError::NoEquilibrium { factor: 0.0, .. }), "{error}");
    assert_eq!(free.positions(), free.particles().reference_positions());

    // A column that stands on its clamp and buckles under its own weight.
    let mut column = beam(4, material);
    let no_load = vec![Vector::zeros(); column.len()];
    // Greenhill: 7.837 E' I/L^2 of weight.
    let critical = 7.837 * 1.4e6 / (1.0 - 0.16) * HEIGHT.powi(3) / 12.0 / LENGTH.powi(2);
    let weight = 1.5 * critical;
    let down = Vector::<f64, 2>::new(-weight / (DENSITY * HEIGHT * LENGTH), 0.0);
    let error = newton.equilibrium(&mut column, &parallel, &no_load, &down).unwrap_err();
    let MatrixError::NoEquilibrium { factor, .. } = error else { panic!("{error}") };
    assert!((factor * weight / critical - 1.0).abs() < 0.05, "{}", factor * weight / critical);

    let short = &no_load[1..];
    let length = newton.equilibrium(&mut column, &parallel, short, &down);
    assert!(matches!(length, Err(MatrixError::Solid(SolidError::Length { .. }))));
    for bad in [
        Newton { tolerance: f64::NAN, ..newton },
        Newton { iterations: 0, ..newton },
        Newton { smallest: 2.0, ..newton },
    ] {
        let error = bad.equilibrium(&mut column, &parallel, &no_load, &down).unwrap_err();
        assert!(matches!(error, MatrixError::Solid(SolidError::Parameter { .. })), "{error}");
    }
}

#[test]
fn a_load_that_is_no_number_is_refused_and_moves_nothing() {
    let parallel = Parallel::serial();
    let mut solid = beam(4, SaintVenantKirchhoff::new(1.4e6, 0.4).unwrap());
    let before = solid.positions().to_vec();
    for odd in [f64::NAN, f64::INFINITY] {
        let mut force = vec![Vector::<f64, 2>::zeros(); solid.len()];
        force[7].y = odd;
        let refused = Newton::default().equilibrium(&mut solid, &parallel, &force, &Vector::zeros());
        let named = matches!(refused, Err(MatrixError::Solid(SolidError::Parameter { name: "force", .. })));
        assert!(named, "{refused:?}");
        assert_eq!(solid.positions(), before);
    }
}
