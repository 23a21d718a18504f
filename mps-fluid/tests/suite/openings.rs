//! Fluid enters and leaves: without pulses, without loss, absorbing sound, the same for any number of threads.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::lattice;
use mps_fluid::{
    Boundary, EquationOfState, Fluid, FluidConfig, FluidError, FluidParticles, Inlet, LaminarViscosity,
    Opening, Outlet, Slip, Tension, Viscosity,
};
use mps_kernel::weights::WendlandGradient;
use mps_kernel::{ReferenceDensity, Vector};
use mps_neighbors::{Open, Parallel, PeriodicBox, state_hash};

const L0: f64 = 0.05;
const HEIGHT: f64 = 0.5;
const LENGTH: f64 = 1.5;
const SOUND: f64 = 20.0;
const LEVEL: f64 = 2000.0;

fn opening(at: f64) -> Opening<f64, 2> {
    Opening { axis: 0, at, forward: true, lower: Vector::zeros(), upper: Vector::from([0.0, HEIGHT]) }
}

/// A channel at rest with walls of the given slip.
pub(crate) fn channel<V: Viscosity<f64, 2>>(
    slip: Slip,
    viscosity: impl FnOnce(&ReferenceDensity<f64>) -> V,
    speed: impl Fn(&Vector<f64, 2>, f64) -> f64 + Send + Sync + 'static,
    absorbing: bool,
) -> Fluid<f64, 2, WendlandGradient, V> {
    let mut config = FluidConfig::water(L0, SOUND);
    config.tension = Tension::Keep;
    config.collisions = None;
    config.background_pressure = LEVEL;
    let counts = [(LENGTH / L0).round() as usize, (HEIGHT / L0).round() as usize];
    let mut boundary = Boundary::default();
    // Twice as fine as the fluid: smooth to what slides along them.
    for y in [-4.0 * L0, HEIGHT] {
        let points = lattice([-6.0 * L0, y], [2 * (counts[0] + 18), 8], 0.5 * L0);
        boundary.add_fine_wall(&points, 0.25, slip).unwrap();
    }
    let particles = FluidParticles::at_rest(lattice([0.0; 2], counts, L0));
    let mut fluid = Fluid::new(config, WendlandGradient, viscosity, Open, particles, boundary).unwrap();
    fluid.add_inlet(Inlet::new(opening(0.0), speed)).unwrap();
    fluid.add_outlet(Outlet { absorbing, pressure: LEVEL, opening: opening(LENGTH) }).unwrap();
    fluid
}

/// Root mean square of `value` over the particles in the channel.
fn typical<V: Viscosity<f64, 2>>(
    fluid: &Fluid<f64, 2, WendlandGradient, V>,
    value: impl Fn(&Vector<f64, 2>, &Vector<f64, 2>, f64) -> f64,
) -> f64 {
    let FluidParticles { position, velocity, pressure, .. } = fluid.particles();
    let inside: Vec<usize> = (0..position.len()).filter(|i| position[*i][0] < LENGTH).collect();
    let squares = inside.iter().map(|i| value(&position[*i], &velocity[*i], pressure[*i] - LEVEL).powi(2));
    (squares.sum::<f64>() / inside.len() as f64).sqrt()
}

/// Without friction at its walls the channel moves as one body, and its pressure is what accelerates it. (Its viscosity damps what the
/// points of the walls stir while the fluid is slow.)
#[test]
fn a_plug_speeds_up_and_flows_without_pulses() {
    const SPEED: f64 = 1.0;
    const RAMP: f64 = 2.0;
    let speed = |t: f64| {
        if t < RAMP { 0.5 * SPEED * (1.0 - (core::f64::consts::PI * t / RAMP).cos()) } else { SPEED }
    };
    let push = |t: f64| 0.5 * SPEED * core::f64::consts::PI / RAMP * (core::f64::consts::PI * t / RAMP).sin();
    let mut fluid = channel(Slip::Free, |r| LaminarViscosity::new::<2>(0.005, r), move |_, t| speed(t), true);
    let parallel = Parallel::serial();
    let (mut off_speed, mut off_pressure) = (0.0_f64, 0.0_f64);
    while fluid.time() < 5.0 {
        fluid.step(&parallel).unwrap();
        let t = fluid.time();
        off_speed = off_speed.max(typical(&fluid, |_, u, _| (u - Vector::from([speed(t), 0.0])).norm()));
        let expected = |x: f64| if t < RAMP { 1000.0 * push(t) * (LENGTH - x) } else { 0.0 };
        off_pressure = off_pressure.max(typical(&fluid, |r, _, p| p - expected(r[0])));
    }
    let [entered, left] = fluid.passed();
    // Four metres have passed: 80 columns of 10.
    assert!((780..=810).contains(&entered) && (780..=810).contains(&left), "{entered} {left}");
    assert!(off_speed < 0.06 * SPEED, "speed {off_speed}");
    assert!(off_pressure < 0.12 * 1000.0 * SPEED * SPEED, "pressure {off_pressure}");
}

/// What is beyond the outlet at the start goes on with the others: at rest it would stay there for ever.
#[test]
fn a_plug_that_is_under_way_leaves_as_it_came() {
    const WIDTH: f64 = 8.0 * L0;
    let config = FluidConfig { tension: Tension::Keep, collisions: None, ..FluidConfig::water(L0, SOUND) };
    let opening = |at| Opening { upper: Vector::from([0.0, WIDTH]), ..opening(at) };
    let speed = Vector::from([1.0, 0.0]);
    let mut particles = FluidParticles::at_rest(lattice([0.0; 2], [30, 8], L0));
    particles.velocity.fill(speed);
    let sides = PeriodicBox::new(Vector::zeros(), [None, Some(WIDTH)]).unwrap();
    let mut fluid =
        Fluid::new(config, WendlandGradient, |_: &_| (), sides, particles, Boundary::default()).unwrap();
    fluid.add_inlet(Inlet::new(opening(0.0), |_, _| 1.0)).unwrap();
    fluid.add_outlet(Outlet::absorbing(opening(LENGTH))).unwrap();
    while fluid.time() < 3.0 * LENGTH {
        fluid.step(&Parallel::serial()).unwrap();
    }
    let off = fluid.particles().velocity.iter().map(|u| (u - speed).norm()).fold(0.0, f64::max);
    assert!(off < 1e-9, "{off}");
    // Ninety columns of eight, and one that is about to pass.
    let [entered, left] = fluid.passed();
    assert!((712..=728).contains(&entered) && entered.abs_diff(left) <= 8, "{entered} {left}");
}

/// What acts before an outlet and how long a step takes must not matter beyond it: there counts by how much the speed at the plane has changed.
#[test]
fn what_is_beyond_an_outlet_keeps_pace_whatever_the_steps_and_the_fields() {
    const PUSH: f64 = 1e-3;
    let mut fluid = free(under_way(&[([0.0, 0.0], [30, 10])], 1.0));
    fluid.add_outlet(Outlet { absorbing: false, ..Outlet::absorbing(opening(LENGTH)) }).unwrap();
    let parallel = Parallel::serial();
    let mut expected = 1.0;
    while fluid.time() < 0.5 {
        let dt = fluid.begin_step(&parallel).unwrap();
        fluid.finish_step(&parallel, dt);
        // All of the push comes in a step that is a hundred times as short as the one before and after it.
        let short = 0.01 * fluid.begin_step(&parallel).unwrap();
        fluid.add_acceleration(&parallel, |_| Vector::from([PUSH / short, 0.0]));
        fluid.finish_step(&parallel, short);
        expected += PUSH;
    }
    assert!(expected > 1.1, "{expected}");
    let FluidParticles { position, velocity, .. } = fluid.particles();
    let beyond = position.iter().zip(velocity).filter(|(r, _)| r.x > LENGTH);
    let off: Vec<f64> = beyond.map(|(_, u)| (u.x - expected).abs()).collect();
    assert!(off.len() >= 60, "{}", off.len());
    // They learn of a push a step later.
    let largest = off.into_iter().fold(0.0, f64::max);
    assert!(largest < 3.0 * PUSH, "{largest:e}");
}

/// Fluid that goes to the right at one metre a second from `lower` on, `counts` spacings.
fn under_way(bodies: &[([f64; 2], [usize; 2])], speed: f64) -> FluidParticles<f64, 2> {
    let places = bodies.iter().flat_map(|(lower, counts)| lattice(*lower, *counts, L0)).collect();
    let mut particles = FluidParticles::at_rest(places);
    particles.velocity.fill(Vector::from([speed, 0.0]));
    particles
}

/// Without walls: at the density of rest nothing pushes.
fn free(particles: FluidParticles<f64, 2>) -> Fluid<f64, 2, WendlandGradient, ()> {
    let config = FluidConfig { tension: Tension::Keep, collisions: None, ..FluidConfig::water(L0, SOUND) };
    Fluid::new(config, WendlandGradient, |_: &_| (), Open, particles, Boundary::default()).unwrap()
}

/// Two streams side by side that leave at different places, and fluid behind the plane of either outlet that is none of its business.
#[test]
fn an_outlet_minds_its_own_zone() {
    let across = |at: f64, bottom: f64| Opening {
        lower: Vector::from([0.0, bottom]),
        upper: Vector::from([0.0, bottom + HEIGHT]),
        ..opening(at)
    };
    let streams = [([0.0, 0.0], [30, 10]), ([0.0, 2.0 * HEIGHT], [15, 10])];
    let mut fluid = free(under_way(&[streams[0], streams[1], ([2.0, 4.0 * HEIGHT], [6, 6])], 1.0));
    for (at, bottom) in [(LENGTH, 0.0), (0.5 * LENGTH, 2.0 * HEIGHT)] {
        fluid.add_inlet(Inlet::new(across(0.0, bottom), |_, _| 1.0)).unwrap();
        fluid.add_outlet(Outlet::absorbing(across(at, bottom))).unwrap();
    }
    while fluid.time() < LENGTH {
        fluid.step(&Parallel::serial()).unwrap();
    }
    let particles = fluid.particles();
    let off = particles.velocity.iter().map(|u| (u - Vector::from([1.0, 0.0])).norm()).fold(0.0, f64::max);
    assert!(off < 1e-9, "{off}");
    let there = |low: f64, high: f64| {
        particles.position.iter().filter(|r| r.y > low && r.y < high && r.x < LENGTH).count()
    };
    assert!((290..=310).contains(&there(0.0, HEIGHT)), "{}", there(0.0, HEIGHT));
    // The zone behind the second outlet is seven columns deep.
    assert!(
        (210..=240).contains(&there(2.0 * HEIGHT, 3.0 * HEIGHT)),
        "{}",
        there(2.0 * HEIGHT, 3.0 * HEIGHT)
    );
    assert_eq!(particles.position.iter().filter(|r| r.y > 4.0 * HEIGHT).count(), 36);
    let [entered, left] = fluid.passed();
    assert!((580..=620).contains(&entered) && entered.abs_diff(left) <= 20, "{entered} {left}");
}

/// What is behind the plane at the start is at rest; it goes with the first fluid that comes.
#[test]
fn what_comes_to_an_outlet_later_leaves_through_it() {
    let mut fluid = free(under_way(&[([0.0, 0.0], [10, 10])], 1.0));
    fluid.add_outlet(Outlet { absorbing: false, ..Outlet::absorbing(opening(LENGTH)) }).unwrap();
    assert!(fluid.particles().velocity.iter().filter(|u| u.norm() == 0.0).count() == 70);
    while fluid.time() < LENGTH + 0.2 {
        fluid.step(&Parallel::serial()).unwrap();
    }
    let off = fluid.particles().velocity.iter().map(|u| (u.x - 1.0).abs()).fold(0.0, f64::max);
    assert!(off < 1e-9, "{off}");
    let [_, left] = fluid.passed();
    assert!(left >= 80, "{left} of 170 particles have left");
}

/// Fluid at rest beside an outlet from its floor to its surface stays at rest: the pressure beyond is that of its weight.
#[test]
fn an_outlet_bears_the_weight_of_the_fluid() {
    let gravity = Vector::from([0.0, -9.81]);
    let config = FluidConfig { gravity, ..FluidConfig::water(L0, SOUND) };
    let eos = config.equation_of_state();
    let counts = [20, 10];
    let mut particles = FluidParticles::at_rest(lattice([0.0; 2], counts, L0));
    for (n, r) in particles.density.iter_mut().zip(&particles.position) {
        *n = eos.density(1000.0 * 9.81 * (HEIGHT - r.y));
    }
    let mut boundary = Boundary::default();
    boundary.add_wall(&lattice([-3.0 * L0, -3.0 * L0], [40, 3], L0), Slip::Free).unwrap();
    boundary.add_wall(&lattice([-3.0 * L0, 0.0], [3, 15], L0), Slip::Free).unwrap();
    let mut fluid = Fluid::new(config, WendlandGradient, |_: &_| (), Open, particles, boundary).unwrap();
    let pressure = 0.5 * 1000.0 * 9.81 * HEIGHT;
    fluid.add_outlet(Outlet { absorbing: false, pressure, opening: opening(1.0) }).unwrap();
    while fluid.time() < 1.0 {
        fluid.step(&Parallel::serial()).unwrap();
    }
    let FluidParticles { position, velocity, .. } = fluid.particles();
    let inside = velocity.iter().zip(position).filter(|(_, r)| r.x < 1.0);
    let energy = inside.map(|(u, _)| u.norm_squared()).sum::<f64>() / 200.0;
    assert!(energy.sqrt() < 0.05 * (9.81 * HEIGHT).sqrt(), "{}", energy.sqrt());
    assert_eq!(fluid.passed(), [0, 0]);
}

/// Who measures the packing before everything has been added gets it anew afterwards.
#[test]
fn the_packing_knows_of_an_inlet_that_came_after_it_was_measured() {
    let measured = |before: bool| {
        let mut fluid = free(under_way(&[([0.0, 0.0], [10, 10])], 1.0));
        if before {
            fluid.measure_packing(&Parallel::serial()).unwrap();
        }
        fluid.add_inlet(Inlet::new(opening(0.0), |_, _| 1.0)).unwrap();
        fluid.measure_packing(&Parallel::serial()).unwrap();
        let mut packing: Vec<_> =
            fluid.particles().id.iter().zip(fluid.packing()).map(|(id, p)| (*id, p.to_bits())).collect();
        packing.sort_unstable();
        packing
    };
    assert_eq!(measured(true), measured(false));
}

/// A developed profile goes through unchanged and has its pressure gradient.
#[test]
fn a_developed_flow_passes_unchanged() {
    const MEAN: f64 = 1.0;
    let profile = |y: f64| 6.0 * MEAN * y * (HEIGHT - y) / (HEIGHT * HEIGHT);
    let nu = 0.02;
    let mut fluid = channel(
        Slip::None,
        |reference| LaminarViscosity::new::<2>(nu, reference),
        move |place, _| profile(place[1]),
        true,
    );
    // It starts as it is to go on.
    let particles = fluid.particles_mut();
    for (u, r) in particles.velocity.iter_mut().zip(&particles.position) {
        u[0] = profile(r[1]);
    }
    let parallel = Parallel::serial();
    let (mut slopes, mut off) = (Vec::new(), 0.0_f64);
    while fluid.time() < 4.0 {
        fluid.step(&parallel).unwrap();
        if fluid.time() > 2.0 {
            let away = |r: &Vector<f64, 2>, u: &Vector<f64, 2>, _| (u[0] - profile(r[1])).hypot(u[1]);
            off = off.max(typical(&fluid, away));
            slopes.push(slope(&fluid));
        }
    }
    let expected = -12.0 * 1000.0 * nu * MEAN / (HEIGHT * HEIGHT);
    let slope = slopes.iter().sum::<f64>() / slopes.len() as f64;
    // No slip is of first order: 11 % too much with these 10 particles across.
    assert!((slope / expected - 1.0).abs() < 0.15, "{slope} {expected}");
    assert!(off < 0.07 * MEAN, "{off}");
}

/// Slope of the pressure along the channel by least squares.
fn slope<V: Viscosity<f64, 2>>(fluid: &Fluid<f64, 2, WendlandGradient, V>) -> f64 {
    let FluidParticles { position, pressure, .. } = fluid.particles();
    let (mut n, mut sx, mut sp, mut sxp, mut sxx) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for (r, p) in position.iter().zip(pressure).filter(|(r, _)| r[0] > 0.2 && r[0] < LENGTH - 0.2) {
        (n, sx, sp, sxp, sxx) = (n + 1.0, sx + r[0], sp + p, sxp + r[0] * p, sxx + r[0] * r[0]);
    }
    (n * sxp - sx * sp) / (n * sxx - sx * sx)
}

/// Sound that is left in a channel at rest after it has run through it twice and a half.
fn sound_left(absorbing: bool) -> f64 {
    let mut fluid = channel(Slip::Free, |_| (), |_, _| 0.0, absorbing);
    let particles = fluid.particles_mut();
    for (n, r) in particles.density.iter_mut().zip(&particles.position) {
        *n += 1e-3 * (-((r[0] - 0.5 * LENGTH) / 0.3).powi(2)).exp();
    }
    let parallel = Parallel::serial();
    fluid.step(&parallel).unwrap();
    let before = typical(&fluid, |_, _, p| p);
    while fluid.time() < 2.5 * LENGTH / SOUND {
        fluid.step(&parallel).unwrap();
    }
    typical(&fluid, |_, _, p| p) / before
}

#[test]
fn an_absorbing_outlet_lets_sound_out() {
    let (absorbed, reflected) = (sound_left(true), sound_left(false));
    assert!(absorbed < 0.12, "{absorbed}");
    assert!(reflected > 0.4, "{reflected}");
}

#[test]
fn openings_have_the_same_bits_for_any_threads() {
    let hash = |parallel: &Parallel| {
        let mut fluid = channel(Slip::None, |r| LaminarViscosity::new::<2>(0.01, r), |_, t| 2.0 + t, true);
        fluid.particles_mut().velocity.iter_mut().for_each(|u| u[0] = 2.0);
        for _ in 0..200 {
            fluid.step(parallel).unwrap();
        }
        assert!(fluid.passed().iter().all(|passed| *passed > 50), "{:?}", fluid.passed());
        let mut ids = fluid.particles().id.clone();
        ids.sort_unstable();
        assert!(ids.windows(2).all(|w| w[0] < w[1]), "every particle has a number of its own");
        state_hash(fluid.particles_mut())
    };
    let expected = hash(&Parallel::serial());
    for threads in [2, 3] {
        assert_eq!(hash(&Parallel::new(threads).unwrap()), expected, "{threads} threads");
    }
}

#[test]
fn what_cannot_be_an_opening_is_refused() {
    let mut fluid = channel(Slip::Free, |_| (), |_, t| 0.1 - t, true);
    let narrow = Opening { upper: Vector::from([0.0, 0.52]), ..opening(0.0) };
    assert!(matches!(fluid.add_outlet(Outlet::absorbing(narrow)), Err(FluidError::Opening { .. })));
    let parallel = Parallel::serial();
    let failed = (0..1000).find_map(|_| fluid.step(&parallel).err()).unwrap();
    assert!(matches!(failed, FluidError::Inflow { speed, .. } if speed < 0.0), "{failed}");
    assert!(fluid.time() > 0.09, "not before it happens");
    let late = fluid.add_inlet(Inlet::new(opening(0.0), |_, _| 1.0)).unwrap_err();
    assert!(late.to_string().contains("before the first step"), "{late}");
}
