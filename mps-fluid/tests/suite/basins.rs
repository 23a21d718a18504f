//! Water rests in basins of any shape: what the walls add to its pressure, and what its packing does.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::fill;
use mps_fluid::{
    ArtificialViscosity, Boundary, EquationOfState, Fluid, FluidConfig, FluidParticles, Slip, Tait,
};
use mps_kernel::weights::{Rational, WendlandGradient};
use mps_kernel::{Kernel, Vector};
use mps_neighbors::{Open, Parallel};

const L0: f64 = 0.01;
/// Depth of all basins, and radius of the round one.
const DEPTH: f64 = 0.16;
const WEIGHT: f64 = 1000.0 * 9.81;
/// Wall points have half the spacing of the water.
const FINE: f64 = 0.5 * L0;

type Point = Vector<f64, 2>;

/// Signed distance from the walls, positive in the water.
type Shape = fn(&Point) -> f64;

fn turned(degrees: f64, points: Vec<Point>) -> Vec<Point> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    points.iter().map(|r| Point::new(cos * r.x - sin * r.y, sin * r.x + cos * r.y)).collect()
}

/// The lattice through the origin, turned.
fn grid(degrees: f64, spacing: f64) -> Vec<Point> {
    turned(degrees, fill([-0.4; 2], [0.4; 2], spacing, |_| true))
}

/// Half rings around the origin, `spacing` apart, as many as there are radii between `inner` and `outer`.
fn rings(inner: f64, outer: f64, spacing: f64) -> Vec<Point> {
    let half = core::f64::consts::PI;
    let ring = |k: usize| {
        let r = outer - (k as f64 + 0.5) * spacing;
        let n = (half * r / spacing).round().max(1.0) as usize;
        (0..n).map(move |i| {
            let (sin, cos) = (-half * (i as f64 + 0.5) / n as f64).sin_cos();
            Point::new(r * cos, r * sin)
        })
    };
    (0..((outer - inner) / spacing).round() as usize).flat_map(ring).collect()
}

/// A box with upright walls.
fn upright(r: &Point) -> f64 {
    r.x.min(0.28 - r.x).min(r.y)
}

/// Walls that rise from an edge at the origin, 30 degrees steep to the right and 60 to the left.
fn valley(r: &Point) -> f64 {
    let (sin, cos) = (0.5, 0.75_f64.sqrt());
    (cos * r.y - sin * r.x).min(cos * r.x + sin * r.y)
}

/// A box with a step on its bed: convex and concave corners.
fn step(r: &Point) -> f64 {
    let (left, above) = (0.14 - r.x, r.y - 0.07);
    let outside = left.max(0.0).hypot(above.max(0.0));
    let step = if outside > 0.0 { outside } else { left.max(above) };
    r.x.min(0.28 - r.x).min(r.y).min(step)
}

/// The lower half of a circle around a point at the level of the water, upright walls above.
fn bowl(r: &Point) -> f64 {
    let y = r.y - DEPTH;
    if y > 0.0 { DEPTH - r.x.abs() } else { DEPTH - r.x.hypot(y) }
}

/// Moves the centre of the bowl to the level of the water.
fn raised(points: Vec<Point>) -> Vec<Point> {
    points.iter().map(|r| Point::new(r.x, r.y + DEPTH)).collect()
}

fn water_in(shape: Shape, points: Vec<Point>) -> Vec<Point> {
    points.into_iter().filter(|r| shape(r) > 0.4 * L0 && r.y > 0.0 && r.y < DEPTH).collect()
}

fn walls_of(shape: Shape, points: Vec<Point>) -> Vec<Point> {
    points.into_iter().filter(|r| shape(r) < 0.0 && shape(r) > -3.0 * L0 && r.y < DEPTH + 0.05).collect()
}

/// What is measured of a basin that has come to rest.
#[derive(Debug)]
struct Rest {
    /// Root mean square error of the pressure over that at the bottom.
    error: f64,
    /// Mean error of the particles within a spacing of the walls.
    beside: f64,
    /// Root mean square speed over `sqrt(g H)`.
    speed: f64,
    /// Mean force on the walls over the weight of the water, along x and down.
    carried: [f64; 2],
    /// The least distance any particle ever had from the surface of the walls, over the spacing.
    closest: f64,
}

fn rest<K: Kernel<f64>>(shape: Shape, kernel: K, water: Vec<Point>, walls: &[Point]) -> Rest {
    let parallel = Parallel::serial();
    let sound = 10.0 * (9.81 * DEPTH).sqrt();
    // The level at which so many particles fill the basin.
    let cell = L0 / 8.0;
    let volume = fill([-0.4, 0.0], [0.4, 0.4], cell, |r| shape(r) > 0.0);
    let mut heights: Vec<f64> = volume.iter().map(|r| r.y).collect();
    heights.sort_unstable_by(f64::total_cmp);
    let level = heights[water.len() * 64] + 0.5 * cell;

    let mut water = FluidParticles::at_rest(water);
    let eos = Tait::new(1000.0, sound);
    for (n, r) in water.density.iter_mut().zip(&water.position) {
        *n = eos.density(WEIGHT * (level - r.y).max(0.0));
    }
    let mut boundary = Boundary::default();
    boundary.add_structure(walls, core::iter::repeat(0.25), Slip::Free);
    let mut config = FluidConfig::<f64, 2>::water(L0, sound);
    config.gravity.y = -9.81;
    let viscosity = |r: &_| ArtificialViscosity::new::<2>(0.1, sound, r);
    let mut fluid = Fluid::new(config, kernel, viscosity, Open, water, boundary).unwrap();

    let (mut squares, mut speeds, mut count) = (0.0, 0.0, 0.0);
    let (mut beside, mut near) = (0.0, 0.0);
    let (mut push, mut span) = (Point::zeros(), 0.0);
    let mut closest = f64::MAX;
    while fluid.time() < 0.6 {
        let dt = fluid.begin_step(&parallel).unwrap();
        let force: Point = fluid.boundary().force.iter().sum();
        fluid.finish_step(&parallel, dt);
        let water = fluid.particles();
        closest = water.position.iter().map(|r| shape(r) / L0).fold(closest, f64::min);
        if fluid.time() > 0.4 {
            push += force * dt;
            span += dt;
            for ((r, p), u) in water.position.iter().zip(&water.pressure).zip(&water.velocity) {
                let error = (p - WEIGHT * (level - r.y)) / (WEIGHT * DEPTH);
                (squares, speeds, count) = (squares + error * error, speeds + u.norm_squared(), count + 1.0);
                if shape(r) < L0 {
                    (beside, near) = (beside + error, near + 1.0);
                }
            }
        }
    }
    let weight = WEIGHT * L0 * L0 * fluid.particles().id.len() as f64 * span;
    Rest {
        carried: [push.x / weight, -push.y / weight],
        error: (squares / count).sqrt(),
        beside: beside / near,
        speed: (speeds / count / (9.81 * DEPTH)).sqrt(),
        closest,
    }
}

/// Water whose rows or rings run along the walls. Layers of wall points that follow the surface and a lattice that
/// cuts it in stairs serve alike: the stairs are half as fine as the water.
#[test]
fn water_packed_along_its_walls_rests_at_the_hydrostatic_pressure() {
    let above = |r: &Point| r.y > DEPTH;
    let mut layers = raised(rings(DEPTH, DEPTH + 3.0 * L0, FINE));
    layers.extend(walls_of(bowl, grid(0.0, FINE)).into_iter().filter(above));
    let (along, round) = (water_in(valley, grid(30.0, L0)), raised(rings(0.0, DEPTH, L0)));
    let cases: [(&str, Shape, _, _); 5] = [
        ("valley, layers", valley, along.clone(), walls_of(valley, grid(30.0, FINE))),
        ("valley, stairs", valley, along, walls_of(valley, grid(0.0, FINE))),
        ("step", step, water_in(step, grid(0.0, L0)), walls_of(step, grid(0.0, FINE))),
        ("bowl, layers", bowl, round.clone(), layers),
        ("bowl, stairs", bowl, round, walls_of(bowl, raised(grid(0.0, FINE)))),
    ];
    for (name, shape, water, walls) in cases {
        let rest = rest(shape, WendlandGradient, water, &walls);
        assert!(rest.error < 0.018 && rest.beside.abs() < 0.018, "{name}: {rest:?}");
        assert!(rest.carried[0].abs() < 0.01 && (rest.carried[1] - 1.0).abs() < 0.01, "{name}: {rest:?}");
        assert!(rest.speed < 0.006 && rest.closest > 0.3, "{name}: {rest:?}");
    }
}

#[test]
fn the_default_weight_shows_too_little_pressure_beside_a_wall() {
    let round = raised(rings(0.0, DEPTH, L0));
    let cases: [(&str, Shape, _, _); 2] = [
        ("step", step, water_in(step, grid(0.0, L0)), walls_of(step, grid(0.0, FINE))),
        ("bowl", bowl, round, walls_of(bowl, raised(grid(0.0, FINE)))),
    ];
    for (name, shape, water, walls) in cases {
        let rest = rest(shape, Rational, water, &walls);
        assert!(rest.closest > 0.25 && rest.speed < 0.01, "{name}: {rest:?}");
        // 4 % of the pressure at the bottom are missing in the first row, four times as much as with the other weight.
        assert!(rest.error < 0.035 && rest.beside > -0.055, "{name}: {rest:?}");
    }
}

/// Not a promise but a record: density follows the motion, so that the gaps a lattice leaves at walls it does not
/// fit are never filled. The first row carries what its few neighbours cannot, and shows a fifth (bowl) to a third (box)
/// of the pressure at the bottom too much. It fades over seconds. The walls are innocent, those of the box are flat, and
/// what they feel is the weight of the water.
#[test]
fn water_cut_from_a_lattice_that_does_not_fit_shows_too_much_pressure_beside_walls() {
    let cases: [(&str, Shape, _, _); 2] = [
        ("box", upright, grid(30.0, L0), walls_of(upright, grid(0.0, FINE))),
        ("bowl", bowl, raised(grid(0.0, L0)), walls_of(bowl, raised(grid(0.0, FINE)))),
    ];
    for (name, shape, lattice, walls) in cases {
        let rest = rest(shape, WendlandGradient, water_in(shape, lattice), &walls);
        assert!(rest.closest > 0.1 && rest.speed < 0.06, "{name}: {rest:?}");
        assert!(rest.carried[0].abs() < 0.01 && (rest.carried[1] - 1.0).abs() < 0.05, "{name}: {rest:?}");
        assert!(rest.error < 0.3 && rest.beside < 0.5, "{name}: {rest:?}");
        assert!(rest.error > 0.06 && rest.beside > 0.1, "no longer so? {name}: {rest:?}");
    }
}
