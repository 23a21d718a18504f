//! A particle is explained by the pairs that the sweeps have summed up.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use mps_kernel::Vector;
use mps_kernel::weights::WendlandC2;
use mps_neighbors::Parallel;
use mps_solid::body::block;
use mps_solid::materials::{Moduli, SaintVenantKirchhoff};
use mps_solid::{Solid, SolidConfig, SolidError};

type Block<const D: usize> = Solid<f64, D, SaintVenantKirchhoff<f64>>;

const L0: f64 = 0.01;

fn body<const D: usize>() -> Block<D> {
    let corner = Vector::from_element(6.0 * L0);
    let body = block(Vector::zeros(), corner, [6; D], &[]).unwrap();
    let material = SaintVenantKirchhoff { moduli: Moduli::new(1e6, 0.3).unwrap() };
    let parallel = Parallel::serial();
    let config = SolidConfig::default();
    Solid::new(body.particles, body.spacing, 1000.0, material, WendlandC2, config, &parallel).unwrap()
}

fn adds_up<const D: usize>() {
    let parallel = Parallel::serial();
    let mut solid = body::<D>();
    // Stretched by 5 % along x, sheared, and bent.
    for r in solid.positions_mut() {
        let x = r[0];
        r[0] += 0.05 * x;
        r[1] += 0.1 * x + 2.0 * x * x;
    }
    solid.refresh(&parallel).unwrap();
    let forces = solid.particles().internal_forces();
    for (i, force) in forces.iter().enumerate() {
        let e = solid.explain(i).unwrap();
        let size: f64 = e.pairs.iter().map(|pair| pair.force.norm()).sum();
        assert!((e.force() - force).norm() < 1e-13 * size);
        assert_eq!(&e.deformation, &solid.particles().deformations()[i]);
        for pair in &e.pairs {
            let other = solid.explain(pair.id as usize).unwrap();
            let back = other.pairs.iter().find(|back| back.id == e.id).unwrap();
            assert_eq!(back.force, -pair.force);
        }
        let [most, least] = e.stretches;
        // Sum and product of the squared stretches are trace and determinant; in 3D the sum gives the third one.
        let rest = (e.deformation.transpose() * e.deformation).trace() - most * most - least * least;
        let third = if D == 3 { rest } else { 1.0 + rest };
        let missing = most * most * least * least * third - e.volume_ratio * e.volume_ratio;
        assert!(missing.abs() < 1e-12, "{missing:e} with {most} and {least}");
    }
    assert!(forces.iter().any(|force| force.norm() > 0.0));
    assert!(solid.explain(solid.len()).is_none());
}

#[test]
fn the_forces_of_the_pairs_add_up_to_that_of_the_sweep() {
    adds_up::<2>();
    adds_up::<3>();
}

/// The error names a particle, and it can be asked for in the body that has been brought back.
#[test]
fn the_particle_that_was_turned_inside_out_is_explained_as_it_was_before() {
    let parallel = Parallel::serial();
    let mut solid = body::<2>();
    let still = vec![Vector::zeros(); solid.len()];
    // The middle of the block is shot through its neighbours.
    solid.velocities_mut()[14] = Vector::from([3.0 * L0 / 1e-3, 0.0]);
    let error = solid.advance(&parallel, &still, &Vector::zeros(), 1e-3, 1).unwrap_err();
    let SolidError::Inverted { id, determinant, .. } = error else {
        unreachable!("{error}");
    };
    assert!(determinant <= 0.0);
    let e = solid.explain(id as usize).unwrap();
    assert!(e.id == id && (e.volume_ratio - 1.0).abs() < 1e-12);
    assert!(e.pairs.iter().any(|pair| pair.id == 14) || id == 14);
}
