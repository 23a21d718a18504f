//! Every material of the crate conforms, in 2D and 3D, from soft to nearly incompressible.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

use mps_solid::ConstitutiveModel;
use mps_solid::conformance::{Check, Conformance, measured_wave_speed};
use mps_solid::materials::{
    CorotationalHooke, Moduli, NearlyIncompressible, NeoHookean, SaintVenantKirchhoff,
};

const YOUNG: f64 = 2.0e6;

fn conforms<M>(material: &M)
where
    M: ConstitutiveModel<f64, 2> + ConstitutiveModel<f64, 3>,
{
    let kit = Conformance::default();
    kit.check::<2, _>(material).unwrap_or_else(|error| panic!("{error}"));
    kit.check::<3, _>(material).unwrap_or_else(|error| panic!("{error}"));
    // Small strains are no special case, nor are large ones.
    for (strain, seed) in [(1e-2, 2), (0.5, 3)] {
        let kit = Conformance { strain, seed, ..kit };
        // The pulse does not depend on them.
        for check in kit.checks().filter(|check| *check != Check::WaveSpeed) {
            kit.only::<2, _>(check, material).unwrap_or_else(|error| panic!("strain {strain}: {error}"));
            kit.only::<3, _>(check, material).unwrap_or_else(|error| panic!("strain {strain}: {error}"));
        }
    }
}

macro_rules! conforming {
    ($($test:ident: $material:ident;)+) => {$(
        #[test]
        fn $test() {
            for nu in [-0.3, 0.0, 0.4, 0.49] {
                conforms(&$material::new(YOUNG, nu).unwrap());
            }
        }
    )+};
}

conforming! {
    corotational_hooke: CorotationalHooke;
    saint_venant_kirchhoff: SaintVenantKirchhoff;
    neo_hookean: NeoHookean;
    nearly_incompressible: NearlyIncompressible;
}

/// The kit allows a deviation of 0.5 %; the pulse itself is far better than that.
#[test]
fn the_pulse_measures_the_wave_speed() {
    for nu in [-0.3, 0.0, 0.4, 0.49] {
        let moduli = Moduli::new(YOUNG, nu).unwrap();
        let (hooke, rubber) = (CorotationalHooke::from(moduli), NearlyIncompressible::from(moduli));
        let exact = ConstitutiveModel::<f64, 2>::wave_speed(&hooke, 1000.0);
        let deviations = [
            measured_wave_speed::<2, _>(&hooke, 1000.0).unwrap() / exact - 1.0,
            measured_wave_speed::<3, _>(&hooke, 1000.0).unwrap() / exact - 1.0,
            measured_wave_speed::<2, _>(&rubber, 1000.0).unwrap() / exact - 1.0,
            measured_wave_speed::<3, _>(&rubber, 1000.0).unwrap() / exact - 1.0,
        ];
        assert!(deviations.iter().all(|deviation| deviation.abs() < 2e-4), "nu {nu}: {deviations:?}");
    }
}
