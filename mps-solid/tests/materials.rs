//! Every material, in 2D and 3D: stress is the derivative of the energy, rotations cost nothing, and
//! small strains follow Hooke's law.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use approx::assert_relative_eq;
use common::{Noise, rotation};
use mps_kernel::{Tensor, tensor::determinant};
use mps_solid::ConstitutiveModel;
use mps_solid::materials::{CorotationalHooke, NeoHookean, SaintVenantKirchhoff};

const YOUNG: f64 = 2.0e6;
const NU: f64 = 0.4;

/// Deformation gradients near a rotation, with strains up to some 20 %.
fn deformations<const D: usize>() -> Vec<Tensor<f64, D>> {
    let mut noise = Noise::new(7);
    (0..40)
        .map(|k| {
            let stretch = Tensor::identity() + noise.tensor::<f64, D>() * 0.4;
            let f = rotation::<f64, D>(0.3 * k as f64) * stretch;
            assert!(determinant(&f) > 0.1);
            f
        })
        .collect()
}

fn stress_is_the_derivative_of_the_energy<const D: usize>(m: &impl ConstitutiveModel<f64, D, History = ()>) {
    for f in deformations::<D>() {
        let p = m.first_piola(&f, &mut (), 0.0);
        for index in 0..D * D {
            let step = 1e-6;
            let mut there = f;
            there[index] += step;
            let mut back = f;
            back[index] -= step;
            let slope = (m.energy(&there, &()) - m.energy(&back, &())) / (2.0 * step);
            assert_relative_eq!(p[index], slope, epsilon = 1e-7 * YOUNG, max_relative = 1e-6);
        }
    }
}

fn rotations_are_not_noticed<const D: usize>(m: &impl ConstitutiveModel<f64, D, History = ()>) {
    for f in deformations::<D>() {
        for angle in [0.1, 1.0, 2.0, 3.0, 4.5] {
            let q = rotation::<f64, D>(angle);
            assert_relative_eq!(m.energy(&(q * f), &()), m.energy(&f, &()), max_relative = 1e-10);
            let (turned, stress) = (m.first_piola(&(q * f), &mut (), 0.0), m.first_piola(&f, &mut (), 0.0));
            assert!((turned - q * stress).norm() < 1e-11 * stress.norm());
        }
    }
}

fn a_rotation_has_no_stress<const D: usize>(m: &impl ConstitutiveModel<f64, D, History = ()>) {
    for k in 0..64 {
        let q = rotation::<f64, D>(0.1 * k as f64);
        assert!(m.first_piola(&q, &mut (), 0.0).norm() < 1e-14 * 20.0 * YOUNG);
        assert!(m.energy(&q, &()).abs() < 1e-14 * YOUNG);
    }
}

fn small_strains_follow_hooke<const D: usize>(m: &impl ConstitutiveModel<f64, D, History = ()>) {
    let (lambda, mu) = (m.first_lame_modulus(), m.shear_modulus());
    let mut noise = Noise::new(3);
    for _ in 0..20 {
        let gradient = noise.tensor::<f64, D>() * 1e-7;
        let strain = (gradient + gradient.transpose()) * 0.5;
        let hooke = Tensor::identity() * (lambda * strain.trace()) + strain * (2.0 * mu);
        let p = m.first_piola(&(Tensor::identity() + gradient), &mut (), 0.0);
        assert!((p - hooke).norm() < 1e-5 * hooke.norm());
    }
}

fn pulling_and_pressing_is_resisted<const D: usize>(m: &impl ConstitutiveModel<f64, D, History = ()>) {
    let trace = |stretch: f64| m.first_piola(&(Tensor::<f64, D>::identity() * stretch), &mut (), 0.0).trace();
    assert!(trace(1.01) > 0.0 && trace(0.99) < 0.0);
    // Uniform dilation by epsilon: tr(P) = D (D lambda + 2 mu) epsilon.
    let d = D as f64;
    let expected = d * (d * m.first_lame_modulus() + 2.0 * m.shear_modulus());
    assert_relative_eq!((trace(1.0 + 1e-6) - trace(1.0 - 1e-6)) / 2e-6, expected, max_relative = 1e-5);
}

macro_rules! properties {
    ($($name:ident: $material:ident in $d:literal;)+) => {$(
        mod $name {
            use super::*;

            #[test]
            fn holds() {
                let material = $material::new(YOUNG, NU).unwrap();
                stress_is_the_derivative_of_the_energy::<$d>(&material);
                rotations_are_not_noticed::<$d>(&material);
                a_rotation_has_no_stress::<$d>(&material);
                small_strains_follow_hooke::<$d>(&material);
                pulling_and_pressing_is_resisted::<$d>(&material);
            }
        }
    )+};
}

properties! {
    corotational_plane: CorotationalHooke in 2;
    corotational_space: CorotationalHooke in 3;
    saint_venant_plane: SaintVenantKirchhoff in 2;
    saint_venant_space: SaintVenantKirchhoff in 3;
    neo_hookean_plane: NeoHookean in 2;
    neo_hookean_space: NeoHookean in 3;
}

#[test]
fn elastic_materials_remember_nothing() {
    assert_eq!(size_of::<<NeoHookean<f64> as ConstitutiveModel<f64, 3>>::History>(), 0);
}

#[test]
fn wave_speed_of_case_one() {
    // K = 3.25 MPa, G = 0.715 MPa, rho = 1000: sqrt((K + 4/3 G)/rho).
    let m =
        CorotationalHooke::from(mps_solid::materials::Moduli::from_bulk_and_shear(3.25e6, 0.715e6).unwrap());
    let speed = ConstitutiveModel::<f64, 2>::wave_speed(&m, 1000.0);
    assert_relative_eq!(speed, 64.82, max_relative = 1e-3);
}
