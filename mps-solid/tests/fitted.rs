//! Bodies whose particles follow a round surface instead of lying in rows.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use approx::assert_relative_eq;
use common::{deform, rotation, stored};
use core::f64::consts::PI;
use mps_kernel::Vector;
use mps_kernel::weights::WendlandC2;
use mps_neighbors::Parallel;
use mps_neighbors::fit::{Nearest, Shape, fit};
use mps_solid::materials::NeoHookean;
use mps_solid::{ConstitutiveModel, Solid, SolidConfig, SolidParticles};

const RADIUS: f64 = 0.1;

/// A disc or ball around the origin.
struct Round;

impl<const D: usize> Shape<D> for Round {
    fn bounds(&self) -> [Vector<f64, D>; 2] {
        [-RADIUS, RADIUS].map(Vector::repeat)
    }

    fn nearest(&self, r: &Vector<f64, D>) -> Option<Nearest<D>> {
        let foot = r.try_normalize(0.0).unwrap_or(Vector::repeat((D as f64).sqrt().recip())) * RADIUS;
        Some(Nearest { foot, depth: RADIUS - r.norm() })
    }
}

fn round<const D: usize>(spacing: f64) -> Solid<f64, D, NeoHookean<f64>> {
    let parallel = Parallel::serial();
    let fitted = fit(&Round, spacing, &parallel).unwrap();
    let mut particles = SolidParticles::new();
    for place in &fitted.places {
        particles.push(*place, fitted.volume, false);
    }
    let material = NeoHookean::new(2e6, 0.3).unwrap();
    let spacing = Vector::repeat(spacing);
    Solid::new(particles, spacing, 1000.0, material, WendlandC2, SolidConfig::default(), &parallel).unwrap()
}

fn stretched_it_is_uniform<const D: usize>(spacing: f64, volume: f64) {
    let mut solid = round::<D>(spacing);
    let mass: f64 = solid.particles().masses().iter().sum();
    assert_relative_eq!(mass, 1000.0 * volume, max_relative = 2e-3);
    let mut gradient = rotation::<f64, D>(0.6) * 1.1;
    gradient[(0, 1)] += 0.2;
    deform(&mut solid, |x| gradient * x + Vector::repeat(0.3));
    for f in solid.particles().deformations() {
        assert!((f - gradient).norm() < 1e-11, "{f} is not {gradient}");
    }
    // The stress is uniform, and so is the energy: that of the material, times the volume.
    let energy = solid.energy(&Parallel::serial(), &Vector::zeros());
    let density = solid.material().energy(&gradient, &());
    assert_relative_eq!(energy.strain, density * mass / 1000.0, max_relative = 1e-9);
    assert!(energy.bending < 1e-18 * energy.strain);
    // Forces inside a body add up to nothing.
    let sum: Vector<f64, D> = solid.particles().internal_forces().iter().sum();
    let largest = solid.particles().internal_forces().iter().map(|f| f.norm()).fold(0.0, f64::max);
    assert!(sum.norm() < 1e-10 * largest);
}

#[test]
fn a_homogeneous_deformation_has_uniform_stress() {
    stretched_it_is_uniform::<2>(0.01, PI * RADIUS * RADIUS);
    stretched_it_is_uniform::<3>(0.02, 4.0 / 3.0 * PI * RADIUS.powi(3));
}

#[test]
fn turned_it_feels_nothing() {
    let mut solid = round::<2>(0.01);
    let turn = rotation::<f64, 2>(2.1);
    let per_strain = 2e6 * PI * RADIUS * RADIUS;
    deform(&mut solid, |x| turn * x + Vector::repeat(1.0));
    assert!(stored(&solid) < 1e-20 * per_strain, "{}", stored(&solid));
    let largest = solid.particles().internal_forces().iter().map(|f| f.norm()).fold(0.0, f64::max);
    assert!(largest < 1e-10 * per_strain, "{largest}");
}
