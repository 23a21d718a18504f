//! What the kit of conformance (`tests/conformance.rs`) does not ask: the sign of the stress, memory,
//! and known numbers.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

use approx::assert_relative_eq;
use mps_kernel::Tensor;
use mps_solid::ConstitutiveModel;
use mps_solid::materials::{
    CorotationalHooke, Moduli, NearlyIncompressible, NeoHookean, SaintVenantKirchhoff,
};

const YOUNG: f64 = 2.0e6;
const NU: f64 = 0.4;

fn pulling_and_pressing_is_resisted<const D: usize>(m: &impl ConstitutiveModel<f64, D, History = ()>) {
    let trace = |stretch: f64| m.first_piola(&(Tensor::<f64, D>::identity() * stretch), &mut (), 0.0).trace();
    assert!(trace(1.01) > 0.0 && trace(0.99) < 0.0);
    // Uniform dilation by epsilon: tr(P) = D (D lambda + 2 mu) epsilon.
    let d = D as f64;
    let expected = d * (d * m.first_lame_modulus() + 2.0 * m.shear_modulus());
    assert_relative_eq!((trace(1.0 + 1e-6) - trace(1.0 - 1e-6)) / 2e-6, expected, max_relative = 1e-5);
}

macro_rules! resisting {
    ($($name:ident: $material:ident;)+) => {$(
        #[test]
        fn $name() {
            let material = $material::new(YOUNG, NU).unwrap();
            pulling_and_pressing_is_resisted::<2>(&material);
            pulling_and_pressing_is_resisted::<3>(&material);
        }
    )+};
}

resisting! {
    corotational_resists: CorotationalHooke;
    saint_venant_resists: SaintVenantKirchhoff;
    neo_hookean_resists: NeoHookean;
    rubber_resists: NearlyIncompressible;
}

#[test]
fn elastic_materials_remember_nothing() {
    assert_eq!(size_of::<<NeoHookean<f64> as ConstitutiveModel<f64, 3>>::History>(), 0);
}

#[test]
fn wave_speed_of_case_one() {
    // K = 3.25 MPa, G = 0.715 MPa, rho = 1000: sqrt((K + 4/3 G)/rho).
    let m = CorotationalHooke::from(Moduli::from_bulk_and_shear(3.25e6, 0.715e6).unwrap());
    let speed = ConstitutiveModel::<f64, 2>::wave_speed(&m, 1000.0);
    assert_relative_eq!(speed, 64.82, max_relative = 1e-3);
}
