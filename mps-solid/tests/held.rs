//! Supports hold a body or do not, however slender it is.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

use mps_kernel::{Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Body, Face};
use mps_solid::materials::CorotationalHooke;
use mps_solid::matrix::{MatrixError, Stiffness};
use mps_solid::{Solid, SolidConfig};

const YOUNG: f64 = 2.0e6;

/// The deflection of the end of a clamped strip of spacing 1 under a force there.
fn bent(counts: [usize; 2], nu: f64) -> Result<f64, MatrixError> {
    let upper = Vector::<f64, 2>::new(counts[0] as f64 - 0.5, counts[1] as f64);
    let strip = body::block(Vector::zeros(), upper, counts, &[Face::lower(0)]).unwrap();
    let material = CorotationalHooke::new(1.0, nu).unwrap();
    let config = SolidConfig::default();
    let solid =
        Solid::new(strip.particles, strip.spacing, 1.0, material, WendlandC2, config, &Parallel::serial())
            .unwrap();
    let mut force = vec![Vector::<f64, 2>::zeros(); solid.len()];
    for (f, x) in force.iter_mut().zip(solid.positions()) {
        if x.x > upper.x - 0.6 {
            f.y = 1.0;
        }
    }
    let u = Stiffness::new(&solid)?.solve(&force)?;
    Ok(u.iter().map(|u| u.y).fold(0.0, f64::max))
}

/// The third root of the deflection grows with the length. A body that is clamped is not taken for a free one because it is slender.
#[test]
fn slender_bodies_are_held_by_their_clamp() {
    for (nu, across, long) in [(0.4, 3, 1200), (0.499, 3, 400), (0.4999, 3, 200), (0.3, 4, 800)] {
        let root = |count: usize| match bent([count, across], nu) {
            Ok(deflection) => deflection.cbrt(),
            Err(error) => panic!("{count}x{across}, nu {nu}: {error}"),
        };
        let (quarter, half, whole) = (root(long / 4), root(long / 2), root(long));
        let ratio = (whole / (half + 2.0 * (half - quarter))).powi(3);
        eprintln!("{long}x{across}, nu {nu}: {ratio:.5} of the deflection that shorter ones let expect");
        assert!((ratio - 1.0).abs() < 0.01, "{long}x{across}, nu {nu}: {ratio}");
    }
    // So slender that nothing is left of its stiffness: said as it is.
    let result = bent([6000, 2], 0.4999);
    assert!(matches!(result, Err(MatrixError::IllConditioned { .. } | MatrixError::Unstable)), "{result:?}");
}

/// Rollers hold a square if they stand on two of its sides, a hinge does not.
#[test]
fn what_supports_leave_free_is_counted() {
    let square = |sides: &[Face], sliding: &[Face]| {
        let mut square = body::block(Vector::<f64, 2>::zeros(), Vector::repeat(1.0), [6, 6], sides).unwrap();
        sliding.iter().for_each(|&face| square.slide(face).unwrap());
        square
    };
    let solved = |body: Body<f64, 2>| {
        let hooke = CorotationalHooke::new(YOUNG, 0.3).unwrap();
        let config = SolidConfig::default();
        let serial = Parallel::serial();
        let solid =
            Solid::new(body.particles, body.spacing, 1.0, hooke, WendlandC2, config, &serial).unwrap();
        let stiffness = Stiffness::new(&solid).unwrap();
        let free = stiffness.lowest(4).unwrap();
        let largest = stiffness.largest_frequency().unwrap().powi(2);
        let zeros = free.iter().filter(|mode| mode.square < 1e-10 * largest).count();
        let force: Vec<_> = (0..solid.len()).map(|i| Vector::<f64, 2>::new(i as f64, 1.0)).collect();
        let solved = stiffness.solve(&force);
        if let Ok(u) = &solved {
            // What is held along one axis moves along the other.
            let back = stiffness.multiply(u).unwrap();
            for (i, (back, force)) in back.iter().zip(&force).enumerate() {
                for axis in (0..2).filter(|&axis| !solid.particles().is_held(i, axis)) {
                    assert!((back[axis] - force[axis]).abs() < 1e-8, "{i} along {axis}");
                }
            }
        }
        (zeros, solved.map(|_| ()))
    };
    let (below, left) = (Face::lower(1), Face::lower(0));
    assert_eq!(solved(square(&[below, left], &[below, left])), (0, Ok(())));
    assert_eq!(solved(square(&[below], &[below])), (1, Err(MatrixError::NotHeld { id: 0, motions: 1 })));
    let mut hinged = square(&[], &[]);
    (0..2).for_each(|axis| hinged.particles.hold(7, axis, true));
    assert_eq!(solved(hinged), (1, Err(MatrixError::NotHeld { id: 0, motions: 1 })));
}
