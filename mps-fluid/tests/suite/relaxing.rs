//! The density of the equation of state returns to the packing of the particles.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use approx::assert_relative_eq;
use mps_fluid::{
    Boundary, Fluid, FluidConfig, FluidParticles, LaminarViscosity, PressureForm, Shifting, Tension,
};
use mps_kernel::Vector;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::{Parallel, PeriodicBox};

type Periodic = Fluid<f64, 2, WendlandGradient, LaminarViscosity<f64>, PeriodicBox<f64, 2>>;

/// Particles a side.
const N: usize = 20;

/// A unit square of fluid at rest, packed more closely than the `spacing` of its parameters says.
fn square(spacing: f64, relaxation: f64) -> Periodic {
    let l0 = 1.0 / N as f64;
    let mut config = FluidConfig::water(spacing, 10.0);
    config.radius_ratio = 4.0;
    config.tension = Tension::Keep;
    config.collisions = None;
    config.background_pressure = 2000.0;
    config.pressure_form = PressureForm::Corrected;
    config.shifting = Some(Shifting { iterations: 1, ..Shifting::default() });
    config.density_relaxation = relaxation;
    let place = |k: usize| (k as f64 + 0.5) * l0;
    let particles =
        FluidParticles::at_rest((0..N * N).map(|k| Vector::from([place(k % N), place(k / N)])).collect());
    let domain = PeriodicBox::new(Vector::zeros(), [Some(1.0); 2]).unwrap();
    let viscosity = |reference: &_| LaminarViscosity::new::<2>(1.0 / 400.0, reference);
    Fluid::new(config, WendlandGradient, viscosity, domain, particles, Boundary::default()).unwrap()
}

/// Root mean square of packing less density.
fn apart(fluid: &mut Periodic) -> f64 {
    fluid.measure_packing(&Parallel::serial()).unwrap();
    let density = &fluid.particles().density;
    let sum: f64 = fluid.packing().iter().zip(density).map(|(packing, n)| (packing - n).powi(2)).sum();
    (sum / density.len() as f64).sqrt()
}

#[test]
fn an_even_compression_is_learnt_exponentially() {
    let (spacing, relaxation) = (0.05 * 1.01, 0.02);
    let mut fluid = square(spacing, relaxation);
    let start = apart(&mut fluid);
    assert!(start > 0.015, "packed too closely by about 2 %: {start}");
    let mut left = start;
    let mut last = 0.0;
    for _ in 0..100 {
        // The first step has no step before it.
        left *= 1.0 - relaxation * last * 10.0 / spacing;
        last = fluid.step(&Parallel::serial()).unwrap();
    }
    assert_relative_eq!(apart(&mut fluid), left, max_relative = 1e-9);
    assert!(left < 0.5 * start, "{left} of {start}");
}

#[test]
fn what_it_does_to_the_energy_is_booked() {
    let parallel = Parallel::serial();
    let mut fluid = square(0.05 * 1.01, 0.02);
    fluid.keep_books();
    let start = fluid.energy(&parallel).total();
    for _ in 0..20 {
        fluid.step(&parallel).unwrap();
    }
    let budget = fluid.budget().unwrap();
    let gained = fluid.energy(&parallel).total() - start;
    assert!(gained > 1.0, "compression stores energy: {gained} J");
    assert_relative_eq!(budget.relaxation, gained, max_relative = 1e-9);
    assert_relative_eq!(budget.total(), gained, max_relative = 1e-9);
}
