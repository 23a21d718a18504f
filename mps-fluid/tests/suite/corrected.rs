//! The corrected form of pressure gradient and divergence keeps what the plain form keeps, and is exact
//! for linear velocities.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{BLOB, blob};
use mps_fluid::{ArtificialViscosity, Diffusion, Fluid, FluidConfig, PressureForm};
use mps_kernel::weights::Rational;
use mps_kernel::{Tensor, Vector};
use mps_neighbors::Parallel;

fn config<const D: usize>(pressure_form: PressureForm) -> FluidConfig<f64, D> {
    FluidConfig { pressure_form, collisions: None, ..FluidConfig::water(BLOB.0, BLOB.1) }
}

/// Sums of force and torque of one step over the sums of the sizes of their terms.
fn residuals<const D: usize>(count: usize) -> (f64, f64) {
    let mut fluid = blob::<D, ()>(count, 0.5, config(PressureForm::Corrected), |_| ());
    fluid.begin_step(&Parallel::serial()).unwrap();
    let (mut force, mut torque) = (Vector::<f64, D>::zeros(), Tensor::<f64, D>::zeros());
    let (mut size, mut moment) = (0.0, 0.0);
    for (r, a) in fluid.particles().position.iter().zip(fluid.acceleration()) {
        force += a;
        torque += r * a.transpose() - a * r.transpose();
        size += a.norm();
        moment += r.norm() * a.norm();
    }
    assert!(size > 0.0, "there is pressure");
    (force.norm() / size, torque.norm() / moment)
}

#[test]
fn momentum_and_angular_momentum_are_kept_though_forces_are_not_central() {
    for (force, torque) in [residuals::<2>(20), residuals::<3>(8)] {
        assert!(force < 1e-14 && torque < 1e-14, "{force:e}, {torque:e}");
    }
}

#[test]
fn energy_of_motion_and_compression_never_rises() {
    let parallel = Parallel::serial();
    let viscosity = |r: &_| ArtificialViscosity::new::<2>(0.05, BLOB.1, r);
    let mut fluid = blob::<2, _>(20, 0.3, config(PressureForm::Corrected), viscosity);
    let start = fluid.energy(&parallel).total();
    let mut least = start;
    for _ in 0..400 {
        fluid.step(&parallel).unwrap();
        let now = fluid.energy(&parallel).total();
        assert!(now - least < 1e-12 * start, "{:e} at step {}", (now - least) / start, fluid.steps());
        least = least.min(now);
    }
    assert!(least < 0.9 * start);
}

/// Largest error of the rate of density, over its size, of a blob without pressure that moves with
/// the linear velocity `flow r`; the exact rate is minus the trace.
fn divergence_error(pressure_form: PressureForm, flow: &Tensor<f64, 2>) -> f64 {
    let parallel = Parallel::serial();
    let mut config = config(pressure_form);
    config.diffusion = Diffusion::None;
    let mut fluid: Fluid<f64, 2, Rational> = blob(12, 0.0, config, |_| ());
    let particles = fluid.particles_mut();
    particles.density.fill(1.0);
    for (u, r) in particles.velocity.iter_mut().zip(&particles.position) {
        *u = flow * r;
    }
    let dt = fluid.begin_step(&parallel).unwrap();
    fluid.finish_step(&parallel, dt);
    let exact = 1.0 - flow.trace() * dt;
    fluid.particles().density.iter().map(|n| (n - exact).abs()).fold(0.0, f64::max) / (flow.norm() * dt)
}

#[test]
fn the_divergence_of_linear_velocities_is_exact_at_the_surface_too() {
    for flow in [[[0.3, 0.0], [0.0, 0.3]], [[0.5, 0.2], [-0.4, -0.5]], [[0.0, 1.0], [-1.0, 0.0]]] {
        let flow = Tensor::<f64, 2>::from(flow);
        let corrected = divergence_error(PressureForm::Corrected, &flow);
        assert!(corrected < 1e-11, "{corrected:e}");
    }
    // The plain sum sees half a neighbourhood at the surface.
    let dilation = Tensor::<f64, 2>::from([[0.3, 0.0], [0.0, 0.3]]);
    assert!(divergence_error(PressureForm::Plain, &dilation) > 0.3);
}
