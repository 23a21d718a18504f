//! A body that is drawn into the water without cutting it out is refused, however its points lie among those of the water; one that is cut out
//! is not, however closely the water surrounds it.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{Driven, lattice};
use mps_coupling::{CouplingError, Scene};
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidParticles, Slip};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Open, Parallel};

const L0: f64 = 0.01;

/// Adds the points to water of `across` particles along each axis, without those that `cut` chooses.
fn added<const D: usize>(
    across: usize,
    points: Vec<Vector<f64, D>>,
    spacing: f64,
    cut: impl Fn(&Vector<f64, D>) -> bool,
) -> Result<usize, CouplingError> {
    let water = lattice([0.0; D], [across; D], L0).into_iter().filter(|r| !cut(r)).collect();
    let config = FluidConfig::water(L0, 10.0);
    let particles = FluidParticles::at_rest(water);
    let fluid = Fluid::new(config, Rational, |_| (), Open, particles, Boundary::default()).unwrap();
    let mut scene: Scene<f64, D> = Scene::new(fluid);
    let body = Driven::new(points, spacing, Vector::zeros());
    scene.add_structure(&Parallel::serial(), Box::new(body), Slip::Free)
}

/// In the middle of the water, shifted by these shares of the spacing of the water.
fn drawn_into<const D: usize>(shift: [f64; D], spacing: f64, layers: usize) {
    let (across, wide) = (12, (4.0 * L0 / spacing).round() as usize);
    let corner = shift.map(|share| (4.0 + share) * L0);
    let mut counts = [wide; D];
    counts[1] = layers;
    let refused = added(across, lattice(corner, counts, spacing), spacing, |_| false).unwrap_err();
    let words = refused.to_string();
    let CouplingError::InWater { index: 0, place, distance, .. } = refused else {
        unreachable!("{shift:?} {spacing}: {words}")
    };
    let inside = |x: &f64| (3.5 * L0..9.5 * L0).contains(x);
    assert!(place.iter().all(inside) && distance < 0.9 * L0, "{shift:?} {spacing}: {words}");
    assert!(words.contains("structure 0") && words.contains("cut the body out of the fluid"), "{words}");
}

#[test]
fn a_body_on_the_places_of_water_or_between_them_is_refused() {
    for spacing in [L0, 0.5 * L0] {
        for share in [0.0, 0.25, 0.5] {
            drawn_into([0.0, share], spacing, 4);
            drawn_into([share, 0.0], spacing, 4);
            drawn_into([share, share], spacing, 4);
            drawn_into([0.0, share, 0.0], spacing, 4);
            drawn_into([share, 0.0, share], spacing, 4);
            drawn_into([share, share, share], spacing, 4);
        }
    }
    // One layer on the places of water, and a plate of two with a row of water in it.
    drawn_into([0.0, 0.0], L0, 1);
    drawn_into([0.0, 0.5], L0, 2);
    drawn_into([0.0, 0.5, 0.0], L0, 2);
}

/// Also in a corner, in a slot and in a hole of the body.
#[test]
fn a_body_that_is_cut_out_of_the_water_is_accepted() {
    for spacing in [L0, 0.5 * L0] {
        let wide = (6.0 * L0 / spacing).round() as usize;
        let of_hole = |r: &Vector<f64, 2>| r.x > 5.0 * L0 && r.x < 6.0 * L0 && r.y > 5.0 * L0;
        let body = |r: &Vector<f64, 2>| r.iter().all(|x| (3.0 * L0..9.0 * L0).contains(x)) && !of_hole(r);
        let mut points = lattice([3.0 * L0; 2], [wide; 2], spacing);
        points.retain(|r| !of_hole(r));
        assert_eq!(added(12, points, spacing, body).unwrap(), 0);

        let of_hole = |r: &Vector<f64, 3>| r.iter().take(2).all(|x| *x > 5.0 * L0 && *x < 6.0 * L0);
        let body = |r: &Vector<f64, 3>| r.iter().all(|x| (3.0 * L0..9.0 * L0).contains(x)) && !of_hole(r);
        let mut points = lattice([3.0 * L0; 3], [wide; 3], spacing);
        points.retain(|r| !of_hole(r));
        assert_eq!(added(12, points, spacing, body).unwrap(), 0);
    }
}

/// A round body in square water, of which the cells that are mostly inside are left out.
#[test]
fn a_round_body_in_square_water_is_accepted() {
    let middle = Vector::from([0.0603, 0.0591]);
    let points = lattice([0.0; 2], [24, 24], 0.5 * L0).into_iter().filter(|r| (r - middle).norm() < 0.035);
    let cut = |r: &Vector<f64, 2>| (r - middle).norm() < 0.035 + 0.25 * L0;
    assert_eq!(added(12, points.collect(), 0.5 * L0, cut).unwrap(), 0);
}
