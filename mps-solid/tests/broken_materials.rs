//! Materials with one mistake each: the kit of conformance names it.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

use core::sync::atomic::{AtomicU64, Ordering};
use mps_kernel::{Tensor, tensor::cofactor, tensor::determinant};
use mps_solid::ConstitutiveModel;
use mps_solid::conformance::{Check, Conformance, ConformanceError};
use mps_solid::materials::NeoHookean;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Mistake {
    None,
    DividesByElapsed,
    WritesWhenAsked,
    ForgetsTheRate,
    NeverSettles,
    RemembersOutside,
    StressFactor,
    Transposed,
    SeesRotation,
    RateOfF,
    Torque,
    NoDerivative,
    EnergyConstant,
    Prestress,
    Fibre,
    ShearModulus,
    WaveSpeed,
}

use Mistake as M;

/// Neo-Hookean with a viscous stress `F 2 eta dE/dt`, and a mistake.
struct Broken {
    base: NeoHookean<f64>,
    mistake: Mistake,
    outside: AtomicU64,
}

const MU: f64 = 1e6;
const ETA: f64 = 100.0;

fn broken(mistake: Mistake) -> Broken {
    let base = NeoHookean::new(2.0 * MU * 1.3, 0.3).unwrap();
    Broken { base, mistake, outside: AtomicU64::new(0) }
}

fn read<const D: usize>(memory: &[[f64; 3]; 3]) -> Tensor<f64, D> {
    Tensor::from_fn(|a, b| memory[a][b])
}

fn written<const D: usize>(tensor: Tensor<f64, D>) -> [[f64; 3]; 3] {
    core::array::from_fn(|a| core::array::from_fn(|b| tensor.get((a, b)).copied().unwrap_or(0.0)))
}

/// `F^T F` of the fibre along the first axis.
fn fibre<const D: usize>(f: &Tensor<f64, D>) -> f64 {
    f.column(0).norm_squared()
}

impl Broken {
    fn strain<const D: usize>(&self, f: &Tensor<f64, D>) -> Tensor<f64, D> {
        if self.mistake == M::RateOfF {
            f - Tensor::identity()
        } else {
            (f.transpose() * f - Tensor::identity()) * 0.5
        }
    }
}

impl<const D: usize> ConstitutiveModel<f64, D> for Broken {
    /// Strain and its rate (`F` and its rate for `RateOfF`).
    type History = [[[f64; 3]; 3]; 2];

    fn energy(&self, f: &Tensor<f64, D>, _: &Self::History) -> f64 {
        let w = self.base.energy(f, &());
        match self.mistake {
            M::EnergyConstant => w + MU,
            M::Prestress => w + MU * determinant(f),
            M::SeesRotation => w + 0.5 * MU * (f[(0, 0)] - 1.0).powi(2),
            M::Fibre => w + 0.25 * MU * (fibre(f) - 1.0).powi(2),
            _ => w,
        }
    }

    fn first_piola(&self, f: &Tensor<f64, D>, history: &mut Self::History, elapsed: f64) -> Tensor<f64, D> {
        let strain = self.strain(f);
        let divides = self.mistake == M::DividesByElapsed;
        if elapsed > 0.0 || divides {
            history[1] = written((strain - read(&history[0])) / elapsed);
        }
        if elapsed > 0.0 || self.mistake == M::WritesWhenAsked {
            history[0] = written(strain);
        }
        let mut p = self.base.first_piola(f, &mut (), elapsed);
        let rate = if self.mistake == M::ForgetsTheRate && elapsed == 0.0 {
            Tensor::zeros()
        } else {
            read(&history[1])
        };
        p += if self.mistake == M::RateOfF { rate * ETA } else { f * rate * (2.0 * ETA) };
        match self.mistake {
            M::RemembersOutside => {
                let before = self.outside.swap(strain.trace().to_bits(), Ordering::Relaxed);
                p += f * (ETA * f64::from_bits(before));
            }
            M::StressFactor => p *= 1.0 + 1e-5,
            M::Transposed => p = p.transpose(),
            M::SeesRotation => p[(0, 0)] += MU * (f[(0, 0)] - 1.0),
            M::Torque => {
                let twist = Tensor::from_fn(|a, b| b as f64 - a as f64);
                p += f * twist * (ETA * rate.norm());
            }
            M::NoDerivative => p += f * (f.transpose() * f) * (determinant(f) - 1.0) * MU,
            M::Prestress => p += cofactor(f) * MU,
            M::Fibre => {
                let tension = MU * (fibre(f) - 1.0);
                for row in 0..D {
                    p[(row, 0)] += tension * f[(row, 0)];
                }
            }
            _ => {}
        }
        p
    }

    fn settle(&self, f: &Tensor<f64, D>, history: &mut Self::History) {
        if self.mistake != M::NeverSettles {
            *history = [written(self.strain(f)), [[0.0; 3]; 3]];
        }
    }

    fn first_lame_modulus(&self) -> f64 {
        self.base.moduli.lambda
    }

    fn shear_modulus(&self) -> f64 {
        self.base.moduli.mu * if self.mistake == M::ShearModulus { 1.01 } else { 1.0 }
    }

    fn wave_speed(&self, density: f64) -> f64 {
        let exact = ((self.base.moduli.lambda + 2.0 * self.base.moduli.mu) / density).sqrt();
        exact * if self.mistake == M::WaveSpeed { 0.98 } else { 1.0 }
    }

    fn name(&self) -> &'static str {
        "broken"
    }
}

fn found<const D: usize>(mistake: Mistake) -> Option<Check> {
    match Conformance::default().check::<D, _>(&broken(mistake)) {
        Ok(()) => None,
        Err(error) => Some(error.check().unwrap_or_else(|| panic!("{mistake:?}: {error}"))),
    }
}

#[test]
fn every_mistake_is_found_and_named() {
    assert_eq!((found::<2>(M::None), found::<3>(M::None)), (None, None));
    for (mistake, check) in [
        (M::DividesByElapsed, Check::ElapsedZero),
        (M::WritesWhenAsked, Check::ElapsedZero),
        (M::ForgetsTheRate, Check::ElapsedZero),
        (M::NeverSettles, Check::Settle),
        (M::RemembersOutside, Check::Restart),
        (M::StressFactor, Check::EnergyGradient),
        (M::Transposed, Check::EnergyGradient),
        (M::NoDerivative, Check::EnergyGradient),
        (M::SeesRotation, Check::Objectivity),
        (M::RateOfF, Check::Objectivity),
        (M::Torque, Check::StressSymmetry),
        (M::EnergyConstant, Check::Rest),
        (M::Prestress, Check::Rest),
        (M::Fibre, Check::Isotropy),
        (M::ShearModulus, Check::Moduli),
        (M::WaveSpeed, Check::WaveSpeed),
    ] {
        assert_eq!(found::<2>(mistake), Some(check), "{mistake:?} in the plane");
        assert_eq!(found::<3>(mistake), Some(check), "{mistake:?} in space");
    }
}

/// The checks that another one precedes find their mistake alone as well.
#[test]
fn a_check_may_be_made_alone() {
    let kit = Conformance::default();
    for (mistake, check) in [
        (M::NoDerivative, Check::TangentSymmetry),
        (M::Transposed, Check::Objectivity),
        (M::SeesRotation, Check::StressSymmetry),
        (M::SeesRotation, Check::Rest),
        (M::Fibre, Check::Moduli),
        (M::Fibre, Check::WaveSpeed),
    ] {
        let error = kit.only::<3, _>(check, &broken(mistake)).unwrap_err();
        assert_eq!(error.check(), Some(check), "{mistake:?}: {error}");
    }
    assert!(kit.only::<2, _>(Check::TangentSymmetry, &broken(M::Fibre)).is_ok());
}

#[test]
fn a_material_with_fibres_conforms_if_it_says_so() {
    let kit = Conformance { isotropic: false, ..Conformance::default() };
    kit.check::<2, _>(&broken(M::Fibre)).unwrap();
    kit.check::<3, _>(&broken(M::Fibre)).unwrap();
}

#[test]
fn the_message_says_what_where_and_why() {
    let error = Conformance::default().check::<2, _>(&broken(M::StressFactor)).unwrap_err();
    let ConformanceError::Violated { deformation, value, expected, tolerance, .. } = &error else {
        panic!("{error}")
    };
    assert!(deformation.len() == 2 && deformation[0].len() == 2);
    let difference = (value / expected - 1.0).abs();
    assert!((difference - 1e-5).abs() < 1e-8, "{difference}");
    assert!((value - expected).abs() > *tolerance);
    let message = error.to_string();
    for part in ["material broken", "EnergyGradient", "dw/dF", "at F = [[", "within", "missing term"] {
        assert!(message.contains(part), "{message}");
    }
}

#[test]
fn settings_out_of_range_are_refused() {
    let good = Conformance::default();
    for bad in [
        Conformance { samples: 0, ..good },
        Conformance { strain: f64::NAN, ..good },
        Conformance { strain: 3.0, ..good },
        Conformance { tolerance: 0.0, ..good },
        Conformance { elapsed: f64::INFINITY, ..good },
        Conformance { wave_tolerance: -1.0, ..good },
    ] {
        let error = bad.check::<2, _>(&broken(M::None)).unwrap_err();
        assert!(matches!(error, ConformanceError::Setting { .. }), "{bad:?}: {error}");
    }
}
