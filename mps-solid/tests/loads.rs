//! Loads, supports and static answers against closed forms and finite elements.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use approx::assert_relative_eq;
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Tensor, Vector};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Body, Face};
use mps_solid::materials::{CorotationalHooke, NeoHookean, SaintVenantKirchhoff};
use mps_solid::{ConstitutiveModel, Relaxation, Solid, SolidConfig, SolidError, SolidParticles};

type V = Vector<f64, 2>;

fn build<M: ConstitutiveModel<f64, 2>>(body: &Body<f64, 2>, density: f64, material: M) -> Solid<f64, 2, M> {
    let (particles, serial) = (body.particles.clone(), Parallel::serial());
    Solid::new(particles, body.spacing, density, material, WendlandC2, SolidConfig::default(), &serial)
        .unwrap()
}

fn nothing(_: &SolidParticles<f64, 2>, _: &mut [V]) {}

#[test]
fn a_point_knows_linear_fields_and_hands_on_force_and_moment() {
    let solid = common::block::<f64, 2, _>([9, 6], &[], CorotationalHooke::new(1e6, 0.3).unwrap());
    let x = solid.positions();
    let spacing = *solid.spacing();
    // Inside, on a side, at a corner.
    for at in [V::new(4.3, 2.7), V::new(0.0, 3.1), V::new(9.0, 6.0)] {
        let at = at.component_mul(&spacing);
        let point = solid.point(at).unwrap();
        assert_relative_eq!(point.value(x), at, epsilon = 1e-14);
        let force = V::new(3.0, -5.0);
        let mut forces = vec![V::zeros(); solid.len()];
        point.add_force(&force, &mut forces);
        let sum: V = forces.iter().sum();
        let moment: f64 = forces.iter().zip(x).map(|(f, x)| x.x * f.y - x.y * f.x).sum();
        assert_relative_eq!(sum, force, epsilon = 1e-13);
        assert_relative_eq!(moment, at.x * force.y - at.y * force.x, epsilon = 1e-13);
    }
    assert!(matches!(solid.point(V::new(-1.0, 0.0)), Err(SolidError::Outside { .. })));
}

/// Stretched by a traction, held by rollers at two faces: a uniform state of the neo-Hookean law solves
/// `P_11 = t`, `P_22 = 0`. What is missing of it comes from the free corner and falls with the spacing.
#[test]
fn a_square_on_rollers_stretches_uniformly() {
    let mut errors = Vec::new();
    for n in [9, 17, 33] {
        let faces = [Face::lower(0), Face::lower(1)];
        let mut square = body::block(V::zeros(), V::repeat(1.0), [n, n], &faces).unwrap();
        faces.iter().for_each(|&face| square.slide(face).unwrap());
        let material = NeoHookean::new(1.0, 0.3).unwrap();
        let mut solid = build(&square, 1.0, material);
        let right = square.face(Face::upper(0)).unwrap();
        assert_relative_eq!(right.area(), 1.0, epsilon = 1e-12);
        assert!(matches!(
            square.face(Face::lower(1)),
            Err(SolidError::ClampedFace { axis: 1, upper: false })
        ));
        let pull = V::new(0.4, 0.0);
        let relaxation = Relaxation { tolerance: 1e-8, ..Relaxation::default() };
        let serial = Parallel::serial();
        solid.relax(&serial, &V::zeros(), |_, force| right.add_traction(&pull, force), &relaxation).unwrap();

        let center = solid.point(V::repeat(0.5)).unwrap();
        let f: Tensor<f64, 2> = center.value(solid.particles().deformations());
        let p = material.first_piola(&f, &mut (), 0.0);
        errors.push((p - Tensor::<f64, 2>::new(0.4, 0.0, 0.0, 0.0)).norm() / 0.4);
    }
    eprintln!("{errors:?}");
    assert!(errors[0] < 2e-4 && errors[1] < 0.4 * errors[0] && errors[2] < 0.4 * errors[1], "{errors:?}");
}

/// A dead load turns with nothing, a pressure turns with the surface: a body turned by 90 degrees is pushed
/// along the turned normal, and twice as hard when it is stretched to twice the length.
#[test]
fn pressure_follows_the_surface() {
    let square = body::block(V::zeros(), V::repeat(1.0), [6, 6], &[]).unwrap();
    let mut solid = build(&square, 1.0, NeoHookean::new(1.0, 0.3).unwrap());
    let top = square.face(Face::upper(1)).unwrap();
    let stretched = Tensor::<f64, 2>::new(0.0, -1.0, 1.0, 0.0) * Tensor::<f64, 2>::new(2.0, 0.0, 0.0, 1.0);
    common::deform(&mut solid, |x| stretched * x);
    let mut forces = vec![V::zeros(); solid.len()];
    top.add_pressure(3.0, solid.particles(), &mut forces);
    assert_relative_eq!(forces.iter().sum::<V>(), V::new(6.0, 0.0), epsilon = 1e-12);
}

/// Clamped at one end, loaded by 10 N/m: the tip sinks by 0.01682 m with quadratic finite elements of the Saint
/// Venant-Kirchhoff law (plane strain, 140 x 8).
#[test]
fn a_beam_under_its_own_weight_sags_as_with_finite_elements() {
    let serial = Parallel::serial();
    let mut errors = Vec::new();
    for across in [4, 8] {
        let spacing = 0.02 / across as f64;
        let clamp = [Face::lower(0)];
        let upper = V::new(0.35, 0.02);
        let counts = body::counts(&V::zeros(), &upper, spacing, &clamp);
        let beam = body::block(V::zeros(), upper, counts, &clamp).unwrap();
        let mut solid = build(&beam, 500.0, SaintVenantKirchhoff::new(1.4e6, 0.4).unwrap());
        let tip = solid.point(V::new(0.35, 0.01)).unwrap();
        let settled = solid.relax(&serial, &V::new(0.0, -1.0), nothing, &Relaxation::default()).unwrap();
        let sag = 0.01 - tip.value(solid.positions()).y;
        eprintln!("{across}: {sag} {:e} {settled:?}", sag / 0.0168213 - 1.0);
        errors.push((sag / 0.016_821_3 - 1.0).abs());
    }
    assert!(errors[0] < 0.02 && errors[1] < 0.009, "{errors:?}");
}

#[test]
fn a_body_that_nothing_holds_does_not_settle() {
    let square = body::block(V::zeros(), V::repeat(1.0), [4, 4], &[]).unwrap();
    let mut solid = build(&square, 1.0, CorotationalHooke::new(1.0, 0.3).unwrap());
    let few = Relaxation { max_steps: 50, ..Relaxation::default() };
    let failed = solid.relax(&Parallel::serial(), &V::new(0.0, -1.0), nothing, &few);
    assert!(matches!(failed, Err(SolidError::NotSettled { steps: 50, .. })));
}
