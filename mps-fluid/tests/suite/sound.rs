//! Standing sound waves and what bulk viscosity takes of them.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::Noise;
use core::f64::consts::PI;
use mps_fluid::{Boundary, Diffusion, Fluid, FluidConfig, FluidParticles, PressureForm, Tension};
use mps_kernel::Vector;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::{Parallel, PeriodicBox};

const SOUND: f64 = 10.0;
/// Wave number in a box of unit length.
const K: f64 = 2.0 * PI;

/// A standing wave of velocity along a periodic box `n` by 8 particles, at its largest.
fn wave(
    n: usize,
    damping: f64,
    form: PressureForm,
    cfl: f64,
) -> Fluid<f64, 2, WendlandGradient, (), PeriodicBox<f64, 2>> {
    let l0 = 1.0 / n as f64;
    let mut config = FluidConfig::water(l0, SOUND);
    (config.radius_ratio, config.cfl, config.sound_damping) = (3.0, cfl, damping);
    (config.tension, config.collisions, config.diffusion) = (Tension::Keep, None, Diffusion::None);
    config.pressure_form = form;
    let place = |k: usize| (k as f64 + 0.5) * l0;
    let places = (0..8 * n).map(|k| Vector::from([place(k % n), place(k / n)])).collect();
    let mut particles = FluidParticles::at_rest(places);
    for (u, r) in particles.velocity.iter_mut().zip(&particles.position) {
        u.x = 1e-4 * (K * r.x).sin();
    }
    let domain = PeriodicBox::new(Vector::zeros(), [Some(1.0), Some(8.0 * l0)]).unwrap();
    Fluid::new(config, WendlandGradient, |_: &_| (), domain, particles, Boundary::default()).unwrap()
}

/// Rate \[1/s\] at which the amplitude decays over two periods.
fn decay(n: usize, damping: f64, form: PressureForm) -> f64 {
    let (parallel, mut fluid) = (Parallel::serial(), wave(n, damping, form, 0.25));
    let start = fluid.energy(&parallel).total();
    let end = 2.0 / SOUND;
    while fluid.time() < end {
        fluid.step(&parallel).unwrap();
    }
    -0.5 * (fluid.energy(&parallel).total() / start).ln() / fluid.time()
}

#[test]
fn sound_decays_as_bulk_viscosity_says() {
    for (form, damping) in [(PressureForm::Plain, 0.2), (PressureForm::Corrected, 0.5)] {
        let errors = [32, 64].map(|n| {
            let exact = 0.5 * damping * SOUND / n as f64 * K * K;
            let found = decay(n, damping, form) - decay(n, 0.0, form);
            found / exact - 1.0
        });
        assert!(errors[0].abs() < 0.05, "{errors:?}");
        assert!(errors[1].abs() < 0.4 * errors[0].abs() + 2e-3, "it converges: {errors:?}");
    }
}

#[test]
fn damping_of_any_strength_is_stable_at_courant_number_one() {
    let parallel = Parallel::serial();
    for damping in [0.0, 0.2, 0.5, 1.0, 2.0] {
        let mut fluid = wave(16, damping, PressureForm::Corrected, 1.0);
        let mut noise = Noise::new(5);
        fluid.particles_mut().velocity.iter_mut().for_each(|u| *u = noise.vector(1e-4));
        let start = fluid.energy(&parallel).total();
        for _ in 0..500 {
            fluid.step(&parallel).unwrap();
        }
        let end = fluid.energy(&parallel).total();
        assert!(end < 1.001 * start, "{damping}: {start} to {end} J");
        assert!(damping == 0.0 || end < 0.9 * start, "{damping}: {start} to {end} J");
    }
}

#[test]
fn what_sound_loses_is_booked() {
    let parallel = Parallel::serial();
    let mut fluid = wave(32, 0.5, PressureForm::Plain, 0.25);
    fluid.keep_books();
    let start = fluid.energy(&parallel).total();
    for _ in 0..200 {
        fluid.step(&parallel).unwrap();
    }
    let (lost, budget) = (fluid.energy(&parallel).total() - start, fluid.budget().unwrap());
    assert!(lost < -0.5 * start, "{lost} of {start} J");
    assert!((budget.sound - lost).abs() < 0.01 * lost.abs(), "{budget:?}, {lost} J");
    assert_eq!(budget.total(), budget.sound, "nothing else acts");
}
