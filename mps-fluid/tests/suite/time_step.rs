//! Both sides of the border that the density diffusion sets to a step: noise on a lattice stays what it is in the steps of the fluid, however
//! large a Courant number is asked for, and grows in steps that are a little longer.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{Noise, lattice};
use mps_fluid::{
    ArtificialViscosity, Boundary, CompactViscosity, Diffusion, Fluid, FluidConfig, FluidParticles,
    LaminarViscosity, Limit, Tension, Viscosity,
};
use mps_kernel::weights::{Rational, WendlandGradient};
use mps_kernel::{Kernel, ReferenceDensity, Vector};
use mps_neighbors::{Parallel, PeriodicBox};

type Periodic<const D: usize, K, V = ()> = Fluid<f64, D, K, V, PeriodicBox<f64, D>>;

const FILTER: Diffusion<f64> = Diffusion::Filter { delta: 0.5 };

/// Noise a billionth in size, in a box without walls.
fn noise<const D: usize, K: Kernel<f64>>(
    kernel: K,
    radius_ratio: f64,
    diffusion: Diffusion<f64>,
    cfl: f64,
) -> Periodic<D, K> {
    viscous_noise(kernel, radius_ratio, diffusion, cfl, |_| ())
}

fn viscous_noise<const D: usize, K: Kernel<f64>, V: Viscosity<f64, D>>(
    kernel: K,
    radius_ratio: f64,
    diffusion: Diffusion<f64>,
    cfl: f64,
    viscosity: impl FnOnce(&ReferenceDensity<f64>) -> V,
) -> Periodic<D, K, V> {
    let side = if D == 2 { 16 } else { 8 };
    let (l0, sound) = (0.01, 10.0);
    let config = FluidConfig {
        radius_ratio,
        diffusion,
        cfl,
        tension: Tension::Keep,
        collisions: None,
        ..FluidConfig::water(l0, sound)
    };
    let mut noise = Noise::new(7);
    let mut particles = FluidParticles::at_rest(lattice([0.0; D], [side; D], l0));
    for (u, n) in particles.velocity.iter_mut().zip(&mut particles.density) {
        *u = noise.vector(1e-9 * sound);
        *n += 1e-9 * noise.next();
    }
    let domain = PeriodicBox::new(Vector::zeros(), [Some(l0 * side as f64); D]).unwrap();
    Fluid::new(config, kernel, viscosity, domain, particles, Boundary::default()).unwrap()
}

/// Largest difference of a density from 1, over that at the start, within 300 steps that are so many times as long as the fluid would have
/// them; it ends where the waves are no longer small.
fn growth<const D: usize, K: Kernel<f64>>(mut fluid: Periodic<D, K>, times: f64) -> f64 {
    let parallel = Parallel::serial();
    let mut largest = 1.0_f64;
    for _ in 0..300 {
        if largest > 1e5 {
            break;
        }
        let dt = fluid.begin_step(&parallel).unwrap();
        assert_eq!(fluid.limit(), Limit::Diffusion);
        fluid.finish_step(&parallel, dt * times);
        let off = fluid.particles().density.iter().map(|n| (n - 1.0).abs() / 1e-9);
        largest = off.fold(largest, f64::max);
    }
    largest
}

fn assert_capped<const D: usize, K: Kernel<f64>>(kernel: K, radius: f64, diffusion: Diffusion<f64>) {
    let fluid = || noise::<D, K>(kernel, radius, diffusion, 2.0);
    let case = format!("{D}D {} {radius} {diffusion:?}, {}", kernel.name(), fluid().stable_courant_number());
    let (fine, broken) = (growth(fluid(), 1.0), growth(fluid(), 1.06));
    assert!(fine < 10.0, "{case}: grows by {fine:e} in the steps of the fluid");
    assert!(broken > 1e3, "{case}: grows by {broken:e} only, 4 % beyond the border");
}

#[test]
fn a_large_courant_number_is_capped_at_the_border_of_the_diffusion() {
    assert_capped::<2, _>(Rational, 3.0, FILTER);
    assert_capped::<2, _>(WendlandGradient, 3.0, FILTER);
    assert_capped::<2, _>(Rational, 3.0, Diffusion::Filter { delta: 2.0 });
    assert_capped::<2, _>(WendlandGradient, 3.0, Diffusion::Hydrostatic);
    assert_capped::<2, _>(Rational, 3.0, Diffusion::Hydrostatic);
}

#[test]
fn and_in_space() {
    assert_capped::<3, _>(Rational, 3.0, FILTER);
    assert_capped::<3, _>(WendlandGradient, 3.0, Diffusion::Hydrostatic);
}

/// What the paper's weight bears: the Courant number 1, by a hair.
#[test]
fn the_usual_courant_number_is_left_alone() {
    let parallel = Parallel::serial();
    let courant = |cfl: f64| {
        let mut fluid = noise::<2, _>(Rational, 3.0, FILTER, cfl);
        let dt = fluid.begin_step(&parallel).unwrap();
        (dt * 10.0 / 0.01, fluid.limit(), fluid.stable_courant_number())
    };
    let (half, limit, border) = courant(0.5);
    assert!((half - 0.5).abs() < 1e-6 && limit == Limit::Sound, "{half} by {limit:?}");
    assert!((border - 2.0 / (0.5 * 3.915_744_386_22_f64)).abs() < 1e-9, "{border}");
    let (one, limit, _) = courant(1.0);
    assert!((one - 1.0).abs() < 1e-6 && limit == Limit::Sound, "{one} by {limit:?}");
    let (capped, limit, _) = courant(1.1);
    assert!((capped - 0.98 * border).abs() < 1e-9 && limit == Limit::Diffusion, "{capped} by {limit:?}");
}

/// Viscosity takes its part of what a step bears: of waves that have a slope, as those of a small radius, whose border it moves.
#[test]
fn viscosity_is_in_the_border() {
    fn assert_borne<const D: usize, V: Viscosity<f64, D>>(
        radius: f64,
        diffusion: Diffusion<f64>,
        viscosity: impl Fn(&ReferenceDensity<f64>) -> V,
    ) {
        for cfl in [1.0, 2.0] {
            let mut fluid = viscous_noise::<D, _, _>(Rational, radius, diffusion, cfl, &viscosity);
            let border = fluid.stable_courant_number();
            let mut largest = 0.0_f64;
            for _ in 0..120 {
                fluid.step(&Parallel::serial()).unwrap();
                let off = fluid.particles().density.iter().map(|n| (n - 1.0).abs() / 1e-9);
                largest = off.fold(largest, f64::max);
                assert!(
                    largest < 10.0,
                    "{D}D {radius} {diffusion:?}, {cfl} of {border}: grows by {largest:e}"
                );
            }
        }
    }
    for diffusion in [FILTER, Diffusion::None, Diffusion::Hydrostatic] {
        for radius in [2.1, 3.0] {
            for alpha in [0.1, 1.0] {
                assert_borne::<2, _>(radius, diffusion, |r| ArtificialViscosity::new::<2>(alpha, 10.0, r));
            }
            // Of the size of c l0, where the viscous limit is near.
            for nu in [1e-3, 1e-2, 5e-2] {
                assert_borne::<2, _>(radius, diffusion, |r| LaminarViscosity::new::<2>(nu, r));
                assert_borne::<2, _>(radius, diffusion, |r| CompactViscosity::new::<2>(nu, r));
            }
        }
        assert_borne::<3, _>(2.1, diffusion, |r| ArtificialViscosity::new::<3>(0.1, 10.0, r));
    }
}

/// What the alternating wave bears does not depend on a little viscosity, nor do the steps that are usual.
#[test]
fn a_little_viscosity_leaves_the_border_where_it_was() {
    let inviscid = noise::<2, _>(Rational, 3.0, FILTER, 1.0).stable_courant_number();
    let viscosity = |r: &_| ArtificialViscosity::new::<2>(0.1, 10.0, r);
    let viscous = viscous_noise::<2, _, _>(Rational, 3.0, FILTER, 1.0, viscosity).stable_courant_number();
    assert_eq!(viscous, inviscid);
}
