//! Supports that slide and supports that move.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use approx::assert_relative_eq;
use mps_kernel::Vector;
use mps_kernel::weights::WendlandC2;
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::materials::CorotationalHooke;
use mps_solid::{Placement, Solid, SolidConfig, SolidError};

type V = Vector<f64, 2>;

fn bar(counts: [usize; 2], clamp: &[Face], slide: &[Face], nu: f64) -> Solid<f64, 2, CorotationalHooke<f64>> {
    let mut bar = body::block(V::zeros(), V::new(1.0, 0.25), counts, clamp).unwrap();
    slide.iter().for_each(|&face| bar.slide(face).unwrap());
    let material = CorotationalHooke::new(1.0, nu).unwrap();
    let (config, serial) = (SolidConfig::default(), Parallel::serial());
    Solid::new(bar.particles, bar.spacing, 1.0, material, WendlandC2, config, &serial).unwrap()
}

#[test]
fn a_particle_on_a_roller_and_a_clamp_is_clamped() {
    let solid = bar([9, 3], &[Face::lower(0), Face::lower(1)], &[Face::lower(1)], 0.3);
    let particles = solid.particles();
    for (i, x) in particles.reference_positions().iter().enumerate() {
        assert_eq!(particles.is_held(i, 0), x.x == 0.0, "{x}");
        assert_eq!(particles.is_held(i, 1), x.x == 0.0 || x.y == 0.0, "{x}");
    }
}

/// A support that is shaken sinusoidally below the first frequency of a bar in uniaxial motion: the end follows
/// with `1/cos(omega L/c)` times the amplitude.
#[test]
fn a_shaken_bar_answers_as_the_wave_equation_says() {
    let serial = Parallel::serial();
    let mut errors = Vec::new();
    for n in [16, 32] {
        // Poisson's ratio zero: the sides need no support.
        let mut solid = bar([n, n / 4], &[Face::lower(0)], &[], 0.0);
        let (omega, amplitude) = (0.7_f64, 1e-4);
        // The steady answer is given at the start, so that no free vibration is excited.
        let reference = solid.particles().reference_positions().to_vec();
        for (u, x) in solid.velocities_mut().iter_mut().zip(&reference) {
            u.x = amplitude * omega * shape_of(omega, x.x);
        }
        solid
            .move_supports(
                |x| x.x == 0.0,
                move |t: f64| Placement::shifted(V::new(amplitude * (omega * t).sin(), 0.0)),
            )
            .unwrap();
        let tip = solid.point(V::new(1.0, 0.125)).unwrap();
        let none = vec![V::zeros(); solid.len()];
        let (mut worst, steps) = (0.0_f64, 400);
        let period = 2.0 * core::f64::consts::PI / omega;
        for _ in 0..steps {
            let dt = period / f64::from(steps);
            let substeps = (dt / solid.max_step(&serial)).ceil() as usize;
            solid.advance(&serial, &none, &V::zeros(), dt, substeps).unwrap();
            let exact = amplitude * (omega * solid.time()).sin() * shape_of(omega, 1.0);
            worst = worst.max((tip.value(solid.positions()).x - 1.0 - exact).abs());
        }
        errors.push(worst / (amplitude / omega.cos()));
    }
    eprintln!("{errors:?}");
    assert!(errors[1] < 0.01, "{errors:?}");
    assert!(errors[1] < 0.5 * errors[0], "{errors:?}");
}

/// Amplitude at `x` over that of the support, for a free end at 1: `cos(k x) + tan(k) sin(k x)`.
fn shape_of(k: f64, x: f64) -> f64 {
    (k * x).cos() + k.tan() * (k * x).sin()
}

/// What pulls at a support does not change its speed: it would count as energy and shorten the step.
#[test]
fn a_moving_support_has_the_speed_of_its_motion_whatever_pulls_at_it() {
    let serial = Parallel::serial();
    let mut solid = bar([16, 4], &[Face::lower(0)], &[], 0.3);
    solid.move_supports(|_| true, |t| Placement::shifted(V::new(0.01 * t, 0.0))).unwrap();
    let pull = vec![V::new(1e-4, 2e-4); solid.len()];
    let dt = solid.max_step(&serial);
    for substeps in [1, 3] {
        solid.advance(&serial, &pull, &V::new(0.0, -0.01), dt * substeps as f64, substeps).unwrap();
        for i in (0..solid.len()).filter(|&i| solid.particles().is_clamped(i)) {
            assert_relative_eq!(solid.velocities()[i], V::new(0.01, 0.0), epsilon = 1e-12);
        }
    }
}

/// Turned slowly by a full turn at its clamp, the bar comes back without a strain.
#[test]
fn a_bar_turned_by_its_clamp_comes_round() {
    let serial = Parallel::serial();
    let mut solid = bar([16, 4], &[Face::lower(0)], &[], 0.3);
    let turn = 2.0 * core::f64::consts::PI;
    let (time, center) = (400.0, V::new(0.0, 0.125));
    // Starts and ends smoothly.
    let angle = move |t: f64| turn * (t / time - (turn * t / time).sin() / turn);
    solid.move_supports(|_| true, move |t| Placement::turned(angle(t), center)).unwrap();
    let none = vec![V::zeros(); solid.len()];
    while solid.time() < time {
        let dt = 10.0 * solid.max_step(&serial);
        solid.advance(&serial, &none, &V::zeros(), dt, 10).unwrap();
    }
    let worst = solid.positions().iter().zip(solid.particles().reference_positions());
    let worst = worst.map(|(x, x0)| (x - x0).norm()).fold(0.0, f64::max);
    assert!(worst < 0.02, "{worst}");
}

#[test]
fn damping_takes_the_motion_away() {
    let serial = Parallel::serial();
    let mut free = body::block(V::zeros(), V::repeat(1.0), [4, 4], &[]).unwrap();
    let config = SolidConfig { damping: 0.5, ..SolidConfig::default() };
    let material = CorotationalHooke::new(1.0, 0.3).unwrap();
    let particles = core::mem::take(&mut free.particles);
    let mut solid = Solid::new(particles, free.spacing, 1.0, material, WendlandC2, config, &serial).unwrap();
    solid.velocities_mut().fill(V::new(1.0, 0.0));
    let none = vec![V::zeros(); solid.len()];
    solid.advance(&serial, &none, &V::zeros(), 2.0, 40).unwrap();
    assert_relative_eq!(solid.velocities()[0].x, (-1.0_f64).exp(), epsilon = 1e-12);
}

#[test]
fn impossible_motions_are_refused() {
    let mut solid = bar([9, 3], &[Face::lower(0)], &[], 0.3);
    let still = |_: f64| Placement::shifted(V::zeros());
    let away = |_: f64| Placement::shifted(V::new(0.1, 0.0));
    assert!(matches!(solid.move_supports(|x| x.x > 0.5, still), Err(SolidError::Motion { .. })));
    assert!(matches!(solid.move_supports(|_| true, away), Err(SolidError::Motion { .. })));
    assert!(solid.move_supports(|_| true, still).is_ok());
}
