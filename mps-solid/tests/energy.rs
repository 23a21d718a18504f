//! The step is symplectic: the energy oscillates, its swing falls with dt^2, and nothing drifts.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use approx::assert_relative_eq;
use common::block;
use mps_kernel::Vector;
use mps_neighbors::Parallel;
use mps_solid::body::Face;
use mps_solid::materials::{CorotationalHooke, SaintVenantKirchhoff};

/// Total energy after every of `rounds` blocks of a bending vibration, relative to the start.
fn energies(fraction: f64, rounds: usize, time: f64) -> Vec<f64> {
    let parallel = Parallel::serial();
    let mut solid = block([31, 3], &[Face::lower(0)], SaintVenantKirchhoff::new(2.0e6, 0.4).unwrap());
    let length = solid.positions().iter().map(|x| x.x).fold(0.0, f64::max);
    let start: Vec<_> = solid.positions().iter().map(|x| (x.x / length).powi(2)).collect();
    for (u, shape) in solid.velocities_mut().iter_mut().zip(start) {
        u.y = 1.0 * shape;
    }
    let rest = vec![Vector::zeros(); solid.len()];
    let gravity = Vector::zeros();
    let energy0 = solid.energy(&parallel, &gravity).total();
    let span = time / rounds as f64;
    let substeps = (span / (fraction * solid.stability_limit())).ceil() as usize;
    (0..rounds)
        .map(|_| {
            solid.advance(&parallel, &rest, &gravity, span, substeps).unwrap();
            solid.energy(&parallel, &gravity).total() / energy0 - 1.0
        })
        .collect()
}

fn swing(values: &[f64]) -> f64 {
    values.iter().map(|e| e.abs()).fold(0.0, f64::max)
}

#[test]
fn energy_is_bounded_over_many_periods() {
    // The strip swings at about 2 Hz: 20 s are 40 periods.
    let energy = energies(0.8, 400, 20.0);
    let (early, late) = (swing(&energy[..100]), swing(&energy[300..]));
    assert!(early < 2e-3, "{early}");
    assert!(late < 1.5 * early, "grows from {early} to {late}");
}

#[test]
fn energy_error_falls_with_the_square_of_the_step() {
    let (coarse, fine) = (swing(&energies(0.8, 200, 1.0)), swing(&energies(0.2, 200, 1.0)));
    let order = (coarse / fine).log(4.0);
    assert!((1.7..2.4).contains(&order), "{coarse} to {fine}: order {order}");
}

#[test]
fn free_fall_is_exact() {
    let parallel = Parallel::serial();
    let mut solid = block([6, 4], &[], CorotationalHooke::new(2.0e6, 0.3).unwrap());
    let rest = vec![Vector::zeros(); solid.len()];
    let gravity = Vector::<f64, 2>::new(0.0, -9.81);
    let dt = solid.max_step(&parallel);
    let time = 200.0 * dt;
    solid.advance(&parallel, &rest, &gravity, time, 200).unwrap();
    for (x, x0) in solid.positions().iter().zip(solid.particles().reference_positions()) {
        assert_relative_eq!(x.y - x0.y, -0.5 * 9.81 * time * time, max_relative = 1e-10);
    }
    let energy = solid.energy(&parallel, &gravity);
    assert!(energy.total().abs() < 1e-10 * energy.kinetic);
}

#[test]
fn mean_velocity_is_displacement_over_time_and_clamped_particles_stay() {
    let parallel = Parallel::serial();
    let mut solid = block([12, 3], &[Face::lower(0)], CorotationalHooke::new(2.0e6, 0.3).unwrap());
    for u in solid.velocities_mut() {
        *u = Vector::<f64, 2>::new(0.1, -0.2);
    }
    let load: Vec<_> = (0..solid.len()).map(|i| Vector::<f64, 2>::new(0.0, 1e-3 * i as f64)).collect();
    let before = solid.positions().to_vec();
    let dt = 7.0 * solid.max_step(&parallel);
    solid.advance(&parallel, &load, &Vector::<f64, 2>::new(0.0, -9.81), dt, 7).unwrap();
    for (i, before) in before.iter().enumerate() {
        // To the last place of the position.
        let moved = (solid.positions()[i] - before) / dt;
        assert!((solid.mean_velocities()[i] - moved).amax() < 1e-17 / dt, "{i}");
        if solid.particles().is_clamped(i) {
            assert_eq!(&solid.positions()[i], before);
            assert_eq!(solid.mean_velocities()[i].norm(), 0.0);
        }
    }
}

/// In equilibrium the support carries the load. The vibration is damped by stopping it at its peaks.
#[test]
fn support_carries_the_weight() {
    let parallel = Parallel::serial();
    let mut solid = block([16, 4], &[Face::lower(0)], CorotationalHooke::new(2.0e6, 0.3).unwrap());
    let rest = vec![Vector::zeros(); solid.len()];
    let gravity = Vector::<f64, 2>::new(0.0, -1.0);
    let dt = 10.0 * solid.max_step(&parallel);
    let mut kinetic = 0.0;
    for _ in 0..3000 {
        solid.advance(&parallel, &rest, &gravity, dt, 10).unwrap();
        let now = solid.energy(&parallel, &gravity).kinetic;
        if now < kinetic {
            solid.velocities_mut().iter_mut().for_each(|u| *u = Vector::zeros());
        }
        kinetic = solid.energy(&parallel, &gravity).kinetic;
    }
    let particles = solid.particles();
    let clamped = (0..solid.len()).filter(|&i| particles.is_clamped(i));
    let pull: f64 = clamped.map(|i| particles.internal_forces()[i].y).sum();
    let weight: f64 =
        (0..solid.len()).filter(|&i| !particles.is_clamped(i)).map(|i| particles.masses()[i]).sum();
    assert_relative_eq!(pull, -weight, max_relative = 1e-3);
}
