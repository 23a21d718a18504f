//! A small dam break in three dimensions against the same one in two.

use super::case::{Case, Curve, Measure, Outcome, Pace, Plot};
use super::scene::{GRAVITY, SOUND, Water, heavy_water, lattice, press, walls};
use crate::Failure;
use mps_fluid::{ArtificialViscosity, Fluid, FluidParticles};
use mps_io::CurvePlot;
use mps_kernel::Vector;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::{Open, Parallel};

/// In 3D between side walls with free slip, so that the flow is that in 2D.
pub(crate) struct DamBreak3d;

/// Height and length of the column \[m\].
const HEIGHT: f64 = 0.2;
/// Length of the tank over that of the column, and its width over the height of the column.
const TANK: usize = 4;
const WIDTH: f64 = 0.5;
/// Strength of the artificial viscosity.
const ALPHA: f64 = 0.05;
const SAME: &str = "the same case in two dimensions";

type Column<const D: usize> = Water<D, ArtificialViscosity<f64>>;

fn build<const D: usize>(n: usize) -> Result<Column<D>, Failure> {
    let l0 = HEIGHT / n as f64;
    let config = heavy_water::<f64, D>(l0, HEIGHT, SOUND);
    let mut column = [(WIDTH * n as f64).round() as usize; D];
    (column[0], column[D - 1]) = (n, n);
    let mut tank = column;
    tank[0] = TANK * n;
    let mut particles = FluidParticles::at_rest(lattice([0.0; D], column, l0));
    let weight = config.density * GRAVITY;
    press(&mut particles, &config, |r| weight * (HEIGHT - r[D - 1]));
    let c = config.sound_speed;
    let viscosity = |r: &_| ArtificialViscosity::new::<D>(ALPHA, c, r);
    let boundary = walls(tank, Some(n), l0);
    Ok(Fluid::new(config, WendlandGradient, viscosity, Open, particles, boundary)?)
}

/// What a run leaves behind.
struct Run {
    /// Time over `sqrt(H/g)` and distance of the furthest particle from the back wall over `H`.
    front: Vec<(f64, f64)>,
    /// Energy lost over that at the start, and the part of the change without a cause.
    lost: f64,
    open: f64,
    /// What the walls have given, in the same unit.
    walls: f64,
    /// Particles outside of the tank.
    leaked: usize,
}

fn run<const D: usize>(n: usize, end: f64, parallel: &Parallel) -> Result<Run, Failure> {
    let unit = (HEIGHT / GRAVITY).sqrt();
    let mut fluid = build::<D>(n)?;
    fluid.keep_books();
    let start = fluid.energy(parallel);
    let mut front = Vec::new();
    while fluid.time() < end * unit {
        let furthest = fluid.particles().position.iter().map(|r| r[0]).fold(0.0, f64::max);
        front.push((fluid.time() / unit, furthest / HEIGHT));
        fluid.step(parallel)?;
    }
    let change = fluid.energy(parallel).total() - start.total();
    let budget = fluid.budget().unwrap_or_default();
    let out = |r: &&Vector<f64, D>| {
        let l0 = fluid.config().spacing;
        let side = |axis: usize| if axis == 0 { TANK as f64 * HEIGHT } else { WIDTH * HEIGHT };
        r[D - 1] < -0.5 * l0 || (0..D - 1).any(|k| r[k] < -0.5 * l0 || r[k] > side(k) + 0.5 * l0)
    };
    Ok(Run {
        front,
        lost: -change / start.potential,
        open: (change - budget.total()) / start.potential,
        walls: budget.boundary / start.potential,
        leaked: fluid.particles().position.iter().filter(out).count(),
    })
}

/// Distance of the front at a time.
fn at(front: &[(f64, f64)], time: f64) -> f64 {
    let after = front.partition_point(|p| p.0 < time).clamp(1, front.len() - 1);
    let (a, b) = (front[after - 1], front[after]);
    a.1 + (b.1 - a.1) * (time - a.0) / (b.0 - a.0)
}

impl Case for DamBreak3d {
    fn name(&self) -> &'static str {
        "dam-break-3d"
    }

    fn about(&self) -> &'static str {
        "A column 0.2 m high and long and 0.1 m wide in a tank four times as long, let go. All walls have free slip, so that the flow is that \
         in two dimensions, which is run as well. c = 10 sqrt(g H), artificial viscosity 0.05, until 4 sqrt(H/g), after the impact on the far wall. \
         Front: largest difference until 2 sqrt(H/g), before it."
    }

    fn resolution(&self) -> &'static str {
        "particles per height"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![8], vec![8, 12, 16])
    }

    fn run(&self, n: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let end = pace.choose(2.2, 4.0);
        let flat = run::<2>(n, end, parallel)?;
        let solid = run::<3>(n, end, parallel)?;
        let times = (1..=40).map(|k| 0.05 * f64::from(k));
        let off = times.map(|t| (at(&solid.front, t) - at(&flat.front, t)).abs()).fold(0.0, f64::max);
        let exact = "every change of energy has a cause";
        let (time, x): (Vec<_>, Vec<_>) = solid.front.iter().copied().unzip();
        let (time2, x2): (Vec<_>, Vec<_>) = flat.front.iter().copied().unzip();
        let measures = vec![
            Measure::new("front, largest difference", "H", off, 0.0, SAME),
            Measure::new("energy lost", "E0", solid.lost, flat.lost, SAME),
            Measure::new("energy by walls", "E0", solid.walls, flat.walls, SAME),
            Measure::new("energy without a cause", "E0", solid.open, 0.0, exact).within(0.01, 0),
            Measure::new("leaked particles", "-", solid.leaked as f64, 0.0, "no leak").within(0.0, 0),
        ];
        let curves = vec![
            Curve { plot: "front", name: format!("3D, {n} per height"), x: time, y: x },
            Curve { plot: "front", name: format!("2D, {n} per height"), x: time2, y: x2 },
        ];
        Ok(Outcome::new(measures, curves))
    }

    fn plots(&self) -> Vec<Plot> {
        let axes = CurvePlot::new("Small dam break in 3D and 2D", "t \u{221a}(g/H) [-]", "front x/H [-]");
        vec![Plot { name: "front", axes }]
    }
}
