//! `f32` runs and agrees with `f64`; three dimensions agree with beam theory; a material may remember.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::block;
use mps_kernel::{Real, Tensor, Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::materials::{CorotationalHooke, NeoHookean, SaintVenantKirchhoff};
use mps_solid::{ConstitutiveModel, Solid, SolidConfig};

/// Tip of a strip that falls under its weight for a fixed time \[m\].
fn tip<T: Real>() -> f64 {
    let parallel = Parallel::serial();
    let material = CorotationalHooke::new(T::of(2.0e6), T::of(0.4)).unwrap();
    let mut solid = block([24, 3], &[Face::lower(0)], material);
    let rest = vec![Vector::<T, 2>::zeros(); solid.len()];
    let gravity = Vector::from_fn(|axis, _| T::of(if axis == 1 { -9.81 } else { 0.0 }));
    for _ in 0..100 {
        solid.advance(&parallel, &rest, &gravity, T::of(1e-3), 20).unwrap();
    }
    solid.positions().iter().map(|x| x.y.to_double()).fold(f64::INFINITY, f64::min)
}

#[test]
fn single_precision_agrees_with_double() {
    let (single, double) = (tip::<f32>(), tip::<f64>());
    assert!(double < -1e-3, "{double}");
    assert!((single - double).abs() < 1e-3 * double.abs(), "{single} and {double}");
}

/// A strip of `f32` two thirds of a metre from the origin, where the last place of a coordinate is 6e-8 m, moves by a quarter of that in every sub-step.
#[test]
fn single_precision_moves_by_less_than_its_last_place() {
    let parallel = Parallel::serial();
    let (lower, upper) = (Vector::<f32, 2>::new(0.65, 0.65), Vector::<f32, 2>::new(0.73, 0.67));
    let strip = body::block(lower, upper, [16, 4], &[]).unwrap();
    let material = SaintVenantKirchhoff::new(1e6, 0.3).unwrap();
    let config = SolidConfig::default();
    let mut solid =
        Solid::new(strip.particles, strip.spacing, 1000.0, material, WendlandC2, config, &parallel).unwrap();
    let u = Vector::<f32, 2>::new(0.1, -0.03);
    solid.velocities_mut().fill(u);
    let rest = vec![Vector::zeros(); solid.len()];
    let (dt, steps) = (1.5e-7_f32, 2000_u16);
    let before: Vec<_> = solid.positions().to_vec();
    for _ in 0..steps {
        solid.advance(&parallel, &rest, &Vector::zeros(), dt, 1).unwrap();
        let mean = solid.mean_velocities();
        assert!(mean.iter().all(|v| (v - u).norm() < 0.02 * u.norm()), "{:?}", mean[0]);
    }
    for (x, x0) in solid.positions().iter().zip(&before) {
        let way = u * dt * f32::from(steps);
        assert!((x - x0 - way).norm() < 0.02 * way.norm(), "{} instead of {way}", x - x0);
    }
}

/// A square bar, clamped, set off in its first mode: the period of Euler-Bernoulli with the
/// Timoshenko correction for a length of 16 times the thickness (shear and rotary inertia: about +1 %).
#[test]
fn bar_in_space_swings_like_a_beam() {
    let parallel = Parallel::serial();
    let (length, across, young, density) = (0.16, 3, 2.0e6, 1000.0);
    let thickness = 0.01;
    let clamp = [Face::lower(0)];
    let upper = Vector::<f64, 3>::new(length, thickness, thickness);
    let bar = body::block(Vector::<f64, 3>::zeros(), upper, [48, across, across], &clamp).unwrap();
    let material = SaintVenantKirchhoff::new(young, 0.3).unwrap();
    let config = SolidConfig::default();
    let mut solid =
        Solid::new(bar.particles, bar.spacing, density, material, WendlandC2, config, &parallel).unwrap();
    let start: Vec<_> = solid.positions().iter().map(|x| (x.x / length).powi(2)).collect();
    for (u, shape) in solid.velocities_mut().iter_mut().zip(start) {
        u.z = 0.01 * shape;
    }
    let rest = vec![Vector::zeros(); solid.len()];
    let last = solid.len() - 1;
    let rest_position = solid.positions()[last].z;
    let dt = 4.0 * solid.max_step(&parallel);
    let (mut time, mut before, mut crossings) = (0.0, 0.0, Vec::new());
    while crossings.len() < 3 {
        solid.advance(&parallel, &rest, &Vector::zeros(), dt, 4).unwrap();
        let now = solid.positions()[last].z - rest_position;
        if time > 0.0 && before * now < 0.0 {
            crossings.push(time + dt * before / (before - now));
        }
        (time, before) = (time + dt, now);
        assert!(time < 3.0, "does not swing");
    }
    let period = crossings[2] - crossings[0];
    let omega = 1.8751_f64.powi(2) / length.powi(2) * (young * thickness.powi(2) / (12.0 * density)).sqrt();
    let beam = 2.0 * core::f64::consts::PI / omega;
    assert!((0.99..1.03).contains(&(period / beam)), "{}", period / beam);
}

/// Remembers the largest volume ratio it has seen; otherwise neo-Hookean.
struct Remembering(NeoHookean<f64>);

impl ConstitutiveModel<f64, 2> for Remembering {
    type History = f64;

    fn energy(&self, f: &Tensor<f64, 2>, _: &f64) -> f64 {
        self.0.energy(f, &())
    }

    fn first_piola(&self, f: &Tensor<f64, 2>, largest: &mut f64, elapsed: f64) -> Tensor<f64, 2> {
        *largest = largest.max(f.determinant());
        self.0.first_piola(f, &mut (), elapsed)
    }

    fn first_lame_modulus(&self) -> f64 {
        self.0.moduli.lambda
    }

    fn shear_modulus(&self) -> f64 {
        self.0.moduli.mu
    }

    fn name(&self) -> &'static str {
        "remembering"
    }
}

#[test]
fn a_material_may_have_a_history() {
    let parallel = Parallel::serial();
    let mut solid = block([8, 4], &[], Remembering(NeoHookean::new(1e6, 0.3).unwrap()));
    // The trial displacements of the set-up leave no trace: the history starts with the rest state.
    assert!(solid.history().iter().all(|&j| (j - 1.0).abs() < 1e-12));
    common::deform(&mut solid, |x| x * 1.1);
    let rest = vec![Vector::<f64, 2>::zeros(); solid.len()];
    let dt = solid.max_step(&parallel);
    solid.advance(&parallel, &rest, &Vector::<f64, 2>::zeros(), 200.0 * dt, 200).unwrap();
    assert!(solid.history().iter().all(|&j| j >= 1.21 - 1e-12));
}
