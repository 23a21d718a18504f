//! Particle shifting evens out the packing and disturbs nothing that is even already.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{Noise, lattice};
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidParticles, Shifting};
use mps_kernel::weights::Rational;
use mps_kernel::{Neighborhood, Vector};
use mps_neighbors::{BruteForce, Domain, Open, Parallel, PeriodicBox};

const L0: f64 = 0.01;
const N: usize = 14;

fn periodic() -> PeriodicBox<f64, 2> {
    PeriodicBox::new(Vector::zeros(), [Some(N as f64 * L0); 2]).unwrap()
}

/// A fluid that has made one step (the length of which the shift needs) without forces, and all of
/// whose particles move with `u`.
fn flowing<P: Domain<f64, 2>>(
    points: Vec<Vector<f64, 2>>,
    domain: P,
    iterations: u32,
    u: Vector<f64, 2>,
) -> Fluid<f64, 2, Rational, (), P> {
    let mut particles = FluidParticles::at_rest(points);
    particles.velocity.fill(u);
    let mut config = FluidConfig::water(L0, 10.0);
    config.collisions = None;
    config.shifting = Some(Shifting { strength: 2.0, iterations });
    let boundary = Boundary::default();
    let mut fluid = Fluid::new(config, Rational, |_| (), domain, particles, boundary).unwrap();
    fluid.step(&Parallel::serial()).unwrap();
    fluid
}

/// Positions by the number of the particle.
fn by_id<P: Domain<f64, 2>>(fluid: &Fluid<f64, 2, Rational, (), P>) -> Vec<Vector<f64, 2>> {
    let particles = fluid.particles();
    let mut found = particles.position.clone();
    for (r, &id) in particles.position.iter().zip(&particles.id) {
        found[id as usize] = *r;
    }
    found
}

/// Displacements by the shift at the beginning of a step, and the positions before it.
fn shifts<P: Domain<f64, 2>>(
    fluid: &mut Fluid<f64, 2, Rational, (), P>,
    domain: P,
) -> (Vec<Vector<f64, 2>>, Vec<Vector<f64, 2>>) {
    let before = by_id(fluid);
    fluid.begin_step(&Parallel::serial()).unwrap();
    let moved = before.iter().zip(by_id(fluid)).map(|(r, new)| domain.separation(r, &new)).collect();
    (moved, before)
}

/// Root mean square of `sum e_ij W_ij/r`, times the spacing.
fn asymmetry<P: Domain<f64, 2>>(points: &[Vector<f64, 2>], domain: P) -> f64 {
    let all = BruteForce::within(domain, points, Rational, 3.0 * L0);
    let lean = |i: usize| {
        let mut sum = Vector::<f64, 2>::zeros();
        all.for_each(i, |pair| sum += pair.gradient_vector());
        sum.norm_squared()
    };
    L0 * ((0..points.len()).map(lean).sum::<f64>() / points.len() as f64).sqrt()
}

fn disturbed(size: f64) -> Vec<Vector<f64, 2>> {
    let mut noise = Noise::new(9);
    let shake = |r: Vector<f64, 2>| periodic().wrap(r + noise.vector::<f64, 2>(size * L0));
    lattice([0.0; 2], [N, N], L0).into_iter().map(shake).collect()
}

#[test]
fn a_full_lattice_is_left_alone() {
    for u in [Vector::zeros(), Vector::<f64, 2>::new(0.7, 0.3)] {
        let mut fluid = flowing(disturbed(0.0), periodic(), 5, u);
        let (moved, _) = shifts(&mut fluid, periodic());
        let most = moved.iter().map(|d| d.norm()).fold(0.0, f64::max);
        assert!(most < 1e-13 * L0, "{most:e}");
    }
}

#[test]
fn a_disturbed_interior_becomes_more_even_with_every_step() {
    let mut points = disturbed(0.15);
    let start = asymmetry(&points, periodic());
    let mut last = start;
    for round in 0..30 {
        let mut fluid = flowing(points, periodic(), 5, Vector::<f64, 2>::new(1.0, 0.0));
        let (moved, before) = shifts(&mut fluid, periodic());
        let now = asymmetry(&before, periodic());
        points = before.iter().zip(&moved).map(|(r, d)| periodic().wrap(r + d)).collect();
        let shifted = asymmetry(&points, periodic());
        assert!(shifted < now, "round {round}: {now} to {shifted}");
        assert!(moved.iter().all(|d| d.norm() <= 0.01 * L0 * (1.0 + 1e-9)), "bounded");
        last = shifted;
    }
    assert!(last < 0.5 * start, "{start} to {last}");
}

#[test]
fn a_fluid_at_rest_is_not_shifted() {
    let mut fluid = flowing(disturbed(0.15), periodic(), 5, Vector::zeros());
    fluid.particles_mut().velocity.fill(Vector::zeros());
    let (moved, _) = shifts(&mut fluid, periodic());
    assert!(moved.iter().all(|d| d.norm() == 0.0));
}

#[test]
fn detached_particles_are_not_moved_and_surface_particles_only_along_it() {
    let mut points = lattice([0.0; 2], [N, N], L0);
    let mut noise = Noise::new(2);
    // The inside is disturbed, the three outer layers are in order.
    let inside = |x: f64| x > 3.0 * L0 && x < (N as f64 - 3.0) * L0;
    for r in &mut points {
        if inside(r.x) && inside(r.y) {
            *r += noise.vector::<f64, 2>(0.1 * L0);
        }
    }
    let bulk = points.len();
    points.extend([[0.5, 0.5], [0.5, 0.513], [-0.3, 0.0]].map(Vector::<f64, 2>::from));
    let mut fluid = flowing(points, Open, 1, Vector::<f64, 2>::new(1.0, 0.0));
    let (moved, before) = shifts(&mut fluid, Open);
    assert!(moved[bulk..].iter().all(|d| d.norm() == 0.0), "spray");
    let middle = (N as f64 / 2.0 - 2.0) * L0..(N as f64 / 2.0 + 2.0) * L0;
    let drift = before[0].x - 0.5 * L0;
    let mut seen = 0;
    for (d, r) in moved.iter().zip(&before) {
        if middle.contains(&(r.x - drift)) && (r.y < L0 || r.y > (N as f64 - 1.0) * L0) {
            assert!(d.y.abs() < 1e-3 * 0.01 * L0, "{d} at {r}");
            seen += 1;
        }
    }
    assert_eq!(seen, 8, "both surfaces");
    assert!(moved.iter().any(|d| d.norm() > 1e-4 * L0), "the inside was moved");
}

#[test]
fn the_shift_does_not_depend_on_the_order_of_the_particles() {
    let points = disturbed(0.15);
    let len = points.len();
    // A stride without a common divisor with the number of particles visits all of them.
    let order: Vec<usize> = (0..len).map(|k| k * 73 % len).collect();
    let shuffled: Vec<_> = order.iter().map(|&k| points[k]).collect();
    let u = Vector::<f64, 2>::new(1.0, 0.0);
    let (straight, _) = shifts(&mut flowing(points, periodic(), 5, u), periodic());
    let (other, _) = shifts(&mut flowing(shuffled, periodic(), 5, u), periodic());
    for (place, &k) in order.iter().enumerate() {
        assert!((other[place] - straight[k]).norm() < 1e-12 * L0, "particle {k}");
    }
    assert!(straight.iter().any(|d| d.norm() > 1e-4 * L0));
}

/// Rows that end at the radius would miss whom a shift brings in: they reach as far as that, even without a skin.
#[test]
fn without_a_skin_nobody_is_missed() {
    let swept = |skin_ratio: f64| {
        let mut noise = Noise::new(11);
        let mut points = lattice::<f64, 2>([0.0; 2], [N, N], L0);
        points.iter_mut().for_each(|r| *r += noise.vector::<f64, 2>(0.2 * L0));
        let mut particles = FluidParticles::at_rest(points);
        particles.velocity.fill(Vector::from([2.0, 0.0]));
        particles.density.iter_mut().for_each(|n| *n += 0.005 + 0.005 * noise.next());
        let mut config = FluidConfig::water(L0, 10.0);
        (config.skin_ratio, config.collisions) = (skin_ratio, None);
        config.shifting = Some(Shifting { strength: 10.0, iterations: 3 });
        let nothing = Boundary::default();
        let mut fluid = Fluid::new(config, Rational, |_| (), periodic(), particles, nothing).unwrap();
        for _ in 0..3 {
            fluid.step(&Parallel::serial()).unwrap();
        }
        fluid.begin_step(&Parallel::serial()).unwrap();
        let mut found = vec![Vector::zeros(); N * N];
        for (a, &id) in fluid.acceleration().iter().zip(&fluid.particles().id) {
            found[id as usize] = *a;
        }
        found
    };
    let wide = swept(0.2);
    let largest = wide.iter().fold(0.0_f64, |most, a| most.max(a.norm()));
    for skin_ratio in [0.0, 0.005, 0.015] {
        let off = swept(skin_ratio).iter().zip(&wide).fold(0.0_f64, |most, (a, b)| most.max((a - b).norm()));
        assert!(off < 1e-8 * largest, "skin {skin_ratio}: {off} of {largest} m/s2");
    }
}
