//! The forces are the exact gradient of one energy, and what follows from that.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use approx::assert_relative_eq;
use common::{Noise, block, deform, rotation, stored};
use mps_kernel::{Tensor, Vector};
use mps_neighbors::Parallel;
use mps_solid::materials::{CorotationalHooke, NeoHookean, SaintVenantKirchhoff};
use mps_solid::{ConstitutiveModel, Solid};

const YOUNG: f64 = 2.0e6;

/// A smooth large deformation (shear up to 30 % for `size = 1`) with noise on top, turned and moved.
fn shake<const D: usize, M: ConstitutiveModel<f64, D>>(solid: &mut Solid<f64, D, M>, size: f64) {
    let turn = rotation::<f64, D>(0.7);
    let mut noise = Noise::new(11);
    deform(solid, |x| {
        let mut y = *x;
        y[0] += size * 3.0 * x[0] * x[1];
        y[1] -= size * 1.5 * x[0] * x[0];
        turn * (y + noise.vector::<f64, D>() * (size * 1e-3)) + Vector::repeat(0.2)
    });
}

fn linear_displacements_are_exact<const D: usize>(counts: [usize; D]) {
    let mut solid = block(counts, &[], NeoHookean::new(YOUNG, 0.3).unwrap());
    let gradient = rotation::<f64, D>(1.1) * (Tensor::identity() + Noise::new(5).tensor::<f64, D>() * 0.5);
    deform(&mut solid, |x| gradient * x + Vector::repeat(3.0));
    for f in solid.particles().deformations() {
        assert!((f - gradient).norm() < 1e-12 * gradient.norm(), "{f} is not {gradient}");
    }
    let energy = solid.energy(&Parallel::serial(), &Vector::zeros());
    assert!(energy.bending < 1e-20 * energy.strain);
}

#[test]
fn patch_test() {
    linear_displacements_are_exact([7, 5]);
    linear_displacements_are_exact([9, 2]);
    linear_displacements_are_exact([5, 4, 3]);
    linear_displacements_are_exact([5, 2, 2]);
}

/// Uniform dilation and compression: `F = s I` in every particle (eq. 35 as printed knows no compression).
#[test]
fn dilation_and_compression_have_their_sign() {
    for stretch in [0.8, 0.99, 1.01, 1.3] {
        let material = SaintVenantKirchhoff::new(YOUNG, 0.3).unwrap();
        let mut solid = block([6, 5], &[], material);
        deform(&mut solid, |x| x * stretch);
        for f in solid.particles().deformations() {
            assert_relative_eq!(f.trace() / 2.0, stretch, max_relative = 1e-12);
        }
        let work: f64 =
            solid.positions().iter().zip(solid.particles().internal_forces()).map(|(x, f)| x.dot(f)).sum();
        // The virial is -V tr(P F^T): negative in tension.
        assert!(work * (stretch - 1.0) < 0.0);
        let p = material.first_piola(&(Tensor::<f64, 2>::identity() * stretch), &mut (), 0.0);
        let volume: f64 = solid.volumes().iter().sum();
        assert_relative_eq!(work, -volume * p.trace() * stretch, max_relative = 1e-10);
    }
}

fn force_is_the_gradient<const D: usize, M: ConstitutiveModel<f64, D>>(counts: [usize; D], material: M) {
    let mut solid = block(counts, &[], material);
    shake(&mut solid, 1.0);
    let force = solid.particles().internal_forces().to_vec();
    let scale = force.iter().map(|f| f.norm()).fold(0.0, f64::max);
    let step = 1e-8;
    for (i, force) in force.iter().enumerate() {
        for (axis, component) in force.iter().enumerate() {
            solid.positions_mut()[i][axis] += step;
            let there = stored(&solid);
            solid.positions_mut()[i][axis] -= 2.0 * step;
            let back = stored(&solid);
            solid.positions_mut()[i][axis] += step;
            let slope = (there - back) / (2.0 * step);
            assert!((component + slope).abs() < 1e-5 * scale, "particle {i}: {component} and {slope}");
        }
    }
}

#[test]
fn force_is_minus_the_gradient_of_the_energy() {
    force_is_the_gradient([6, 4], CorotationalHooke::new(YOUNG, 0.4).unwrap());
    force_is_the_gradient([6, 4], SaintVenantKirchhoff::new(YOUNG, 0.4).unwrap());
    force_is_the_gradient([6, 4], NeoHookean::new(YOUNG, 0.47).unwrap());
    force_is_the_gradient([4, 3, 3], CorotationalHooke::new(YOUNG, 0.4).unwrap());
    force_is_the_gradient([4, 3, 3], NeoHookean::new(YOUNG, 0.4).unwrap());
}

fn rigid_motion_is_free<const D: usize, M: ConstitutiveModel<f64, D>>(counts: [usize; D], material: M) {
    let mut solid = block(counts, &[], material);
    deform(&mut solid, |x| x * 1.001);
    let scale = solid.particles().internal_forces().iter().map(|f| f.norm()).fold(0.0, f64::max);
    for k in 0..12 {
        let turn = rotation::<f64, D>(0.55 * k as f64);
        deform(&mut solid, |x| turn * x + Vector::repeat(0.3));
        // The stress of a strain of 0.001 gives the scale; positions are rounded at 1e-16 of 0.4 m.
        let worst = solid.particles().internal_forces().iter().map(|f| f.norm()).fold(0.0, f64::max);
        assert!(worst < 1e-9 * scale, "{worst} of {scale}");
        assert!(stored(&solid).abs() < 1e-15 * YOUNG * 1e-2_f64.powi(D as i32));
    }
}

#[test]
fn rigid_motion_has_no_force() {
    rigid_motion_is_free([7, 5], CorotationalHooke::new(YOUNG, 0.4).unwrap());
    rigid_motion_is_free([7, 5], SaintVenantKirchhoff::new(YOUNG, 0.4).unwrap());
    rigid_motion_is_free([5, 4, 3], CorotationalHooke::new(YOUNG, 0.4).unwrap());
    rigid_motion_is_free([5, 4, 3], NeoHookean::new(YOUNG, 0.4).unwrap());
}

#[test]
fn action_is_minus_reaction_bit_by_bit() {
    let mut plane = block([8, 5], &[], CorotationalHooke::new(YOUNG, 0.47).unwrap());
    shake(&mut plane, 1.0);
    assert!((0..plane.len()).all(|i| plane.reaction_defect(i) == 0.0));
    let mut space = block([4, 3, 3], &[], NeoHookean::new(YOUNG, 0.4).unwrap());
    shake(&mut space, 1.0);
    assert!((0..space.len()).all(|i| space.reaction_defect(i) == 0.0));
}

fn momenta_are_kept<const D: usize, M: ConstitutiveModel<f64, D>>(counts: [usize; D], material: M) {
    let parallel = Parallel::serial();
    let mut solid = block(counts, &[], material);
    shake(&mut solid, 0.4);
    let mut noise = Noise::new(2);
    for u in solid.velocities_mut() {
        *u = Vector::repeat(0.5) + noise.vector::<f64, D>();
    }
    let center = Vector::repeat(0.1);
    let (p0, l0) = (solid.momentum(&parallel), solid.angular_momentum(&parallel, &center));
    let rest = vec![Vector::zeros(); solid.len()];
    let dt = solid.max_step(&parallel);
    for _ in 0..20 {
        solid.advance(&parallel, &rest, &Vector::zeros(), 50.0 * dt, 50).unwrap();
    }
    let (p, l) = (solid.momentum(&parallel), solid.angular_momentum(&parallel, &center));
    assert!((p - p0).norm() < 1e-12 * p0.norm(), "momentum changed by {}", (p - p0).norm() / p0.norm());
    assert!((l - l0).norm() < 1e-12 * l0.norm(), "angular momentum: {}", (l - l0).norm() / l0.norm());
}

#[test]
fn free_vibration_keeps_linear_and_angular_momentum() {
    momenta_are_kept([12, 5], CorotationalHooke::new(YOUNG, 0.4).unwrap());
    momenta_are_kept([12, 5], NeoHookean::new(YOUNG, 0.47).unwrap());
    momenta_are_kept([6, 4, 3], CorotationalHooke::new(YOUNG, 0.4).unwrap());
}
