//! Pressure at the free surface, and what an impact leaves behind.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::fill;
use mps_fluid::surface::Surface::{Detached, Free};
use mps_fluid::{
    ArtificialViscosity, Boundary, EquationOfState, Fluid, FluidConfig, FluidParticles, Slip, Tait,
};
use mps_kernel::weights::{Rational, WendlandGradient};
use mps_kernel::{Kernel, Vector};
use mps_neighbors::{Open, Parallel};

const L0: f64 = 0.01;
const WIDTH: f64 = 0.16;
const DEPTH: f64 = 0.2;
const WEIGHT: f64 = 1000.0 * 9.81;

type Point = Vector<f64, 2>;

type Tank<K> = Fluid<f64, 2, K, ArtificialViscosity<f64>>;

/// A tank with walls of fine points, full of water that falls with `speed` or rests.
fn tank<K: Kernel<f64>>(kernel: K, sound: f64, alpha: f64, speed: f64) -> Tank<K> {
    let mut water = FluidParticles::at_rest(fill([0.0; 2], [WIDTH, DEPTH], L0, |_| true));
    let eos = Tait::new(1000.0, sound);
    if speed == 0.0 {
        for (n, r) in water.density.iter_mut().zip(&water.position) {
            *n = eos.density(WEIGHT * (DEPTH - r.y));
        }
    }
    water.velocity.fill(Point::new(0.0, -speed));
    let walls =
        fill([-0.03; 2], [WIDTH + 0.03, 2.0 * DEPTH], 0.5 * L0, |r| r.y < 0.0 || r.x < 0.0 || r.x > WIDTH);
    let mut boundary = Boundary::default();
    boundary.add_fine_wall(&walls, 0.25, Slip::Free).unwrap();
    let mut config = FluidConfig::<f64, 2>::water(L0, sound);
    config.gravity.y = -9.81;
    let viscosity = |r: &_| ArtificialViscosity::new::<2>(alpha, sound, r);
    Fluid::new(config, kernel, viscosity, Open, water, boundary).unwrap()
}

/// Of the particles found at the surface of a tank at rest: their number, the mean of their pressure and the
/// root mean square of its error, over the weight of one spacing of water.
fn at_surface<K: Kernel<f64>>(kernel: K) -> [f64; 3] {
    let parallel = Parallel::serial();
    let mut fluid = tank(kernel, 10.0 * (9.81 * DEPTH).sqrt(), 0.05, 0.0);
    let mut classes = Vec::new();
    let (mut sum, mut squares, mut count, mut looks) = (0.0, 0.0, 0.0, 0.0);
    while fluid.time() < 0.7 {
        fluid.step(&parallel).unwrap();
        if fluid.time() < 0.4 || !fluid.steps().is_multiple_of(20) {
            continue;
        }
        fluid.classify_surface(&parallel, &mut classes).unwrap();
        assert!(!classes.contains(&Detached), "{} s", fluid.time());
        looks += 1.0;
        let water = fluid.particles();
        for ((r, p), _) in
            water.position.iter().zip(&water.pressure).zip(&classes).filter(|(_, class)| **class == Free)
        {
            assert!(DEPTH - r.y < 1.2 * L0, "{} m below the surface", DEPTH - r.y);
            let unit = WEIGHT * L0;
            count += 1.0;
            sum += p / unit;
            squares += ((p - WEIGHT * (DEPTH - r.y)) / unit).powi(2);
        }
    }
    [count / looks, sum / count, f64::sqrt(squares / count)]
}

#[test]
fn the_surface_of_a_tank_at_rest_is_its_top_row_under_half_a_spacing_of_water() {
    for found in [at_surface(WendlandGradient), at_surface(Rational)] {
        let [count, pressure, error] = found;
        assert!((13.0..=16.5).contains(&count), "{found:?}");
        assert!((pressure - 0.5).abs() < 0.2 && error < 0.25, "{found:?}");
    }
}

/// What an impact of the whole tank on its bed leaves behind.
#[derive(Debug)]
struct Impact {
    /// Largest mean pressure of the bottom row over that of a water hammer, `rho c v`.
    peak: f64,
    /// Mean pressure of the bottom row, and its swing, over that of the water above it, twenty periods later.
    mean: f64,
    swing: f64,
    /// Smallest and median distance of a particle from its nearest neighbour, over the spacing.
    nearest: [f64; 2],
}

fn impact<K: Kernel<f64>>(kernel: K) -> Impact {
    let parallel = Parallel::serial();
    let (sound, speed) = (20.0, 1.0);
    let mut fluid = tank(kernel, sound, 0.02, speed);
    // Of the slowest sound: bed to surface and back, twice.
    let period = 4.0 * DEPTH / sound;
    let bottom = WEIGHT * (DEPTH - 0.5 * L0);
    let (mut peak, mut sum, mut squares, mut count) = (0.0_f64, 0.0, 0.0, 0.0);
    while fluid.time() < 26.0 * period {
        fluid.step(&parallel).unwrap();
        let water = fluid.particles();
        let row = water.position.iter().zip(&water.pressure).filter(|(r, _)| r.y < L0);
        let (total, n) = row.fold((0.0, 0), |(total, n), (_, p)| (total + p, n + 1));
        let pressure = total / f64::from(n.max(1));
        peak = peak.max(pressure);
        if fluid.time() > 20.0 * period {
            (sum, squares, count) = (sum + pressure, squares + pressure * pressure, count + 1.0);
        }
    }
    let places = &fluid.particles().position;
    let nearest = |a: &Point| {
        let others = places.iter().map(|b| (a - b).norm()).filter(|d| *d > 0.0);
        others.fold(f64::MAX, f64::min) / L0
    };
    let mut distances: Vec<f64> = places.iter().map(nearest).collect();
    distances.sort_unstable_by(f64::total_cmp);
    let mean = sum / count;
    Impact {
        peak: peak / (1000.0 * sound * speed),
        mean: mean / bottom,
        swing: (squares / count - mean * mean).max(0.0).sqrt() / bottom,
        nearest: [distances[0], distances[distances.len() / 2]],
    }
}

/// The hammer is ten times the weight of the water, and the water leaves the bed once more before it rests. What is
/// left to ring is 1 % of the hammer; the mean is 16 and 6 % too high, as the packing beside the bed is
/// uneven by then (`basins.rs`).
#[test]
fn an_impact_leaves_neither_ringing_nor_clusters() {
    for impact in [impact(WendlandGradient), impact(Rational)] {
        assert!((impact.mean - 1.0).abs() < 0.2 && impact.swing < 0.3, "{impact:?}");
        assert!(impact.nearest[0] > 0.7 && impact.nearest[1] > 0.9, "{impact:?}");
        // A record: behind the front the pressure overshoots.
        assert!((1.0..2.0).contains(&impact.peak), "{impact:?}");
    }
}
