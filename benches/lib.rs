//! Scenes shared by the benchmarks.
//!
//! `cargo bench -p mps-benches` runs all of them in a few minutes; the numbers and how to read them
//! are in `docs/performance.md`.

// A scene that cannot be built is a mistake in the benchmark: nothing to recover from.
#![allow(clippy::expect_used)]

pub mod counting;

use core::time::Duration;
use criterion::Criterion;
use mps_coupling::{ElasticBody, Scene};
use mps_fluid::{
    ArtificialViscosity, Boundary, Diffusion, EquationOfState, Fluid, FluidConfig, FluidParticles, Shifting,
    Slip, Viscosity,
};
use mps_kernel::weights::{Rational, WendlandC2};
use mps_kernel::{Real, ReferenceDensity, Vector};
use mps_neighbors::{Open, Parallel};
use mps_solid::body::{Face, block, counts};
use mps_solid::materials::CorotationalHooke;
use mps_solid::{Solid, SolidConfig};

/// A fluid with the weight of the paper.
pub type Water<T, const D: usize> = Fluid<T, D, Rational, ArtificialViscosity<T>>;
/// A rubber body.
pub type Rubber<const D: usize = 2> = Solid<f64, D, CorotationalHooke<f64>, WendlandC2>;
/// Water and the gate.
pub type GateScene = Scene<f64, 2, Rational, ArtificialViscosity<f64>>;

/// Particles of the plane scenes: a tank of 160 x 125.
pub const PLANE: [usize; 2] = [160, 125];
/// Particles of the scenes in space: a tank of 40 x 25 x 30.
pub const SPACE: [usize; 3] = [40, 25, 30];
/// Spacing of the particles \[m\].
pub const SPACING: f64 = 1e-3;
/// Effective radius over spacing, as everywhere in the fluid.
pub const RADIUS_RATIO: f64 = 3.0;
/// What the rows reach beyond the effective radius, over the spacing.
pub const SKIN_RATIO: f64 = 0.3;
/// Largest displacement of a particle from its lattice site, over the spacing.
const JITTER: f64 = 0.1;
const GRAVITY: f64 = 9.81;

/// Short measurements: the whole set takes minutes, and noise shows as spread, not as bias of the
/// minimum.
pub fn short() -> Criterion {
    Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_secs(1))
        .without_plots()
}

/// The thread counts every parallel loop is measured on.
pub fn pools() -> [Parallel; 2] {
    [Parallel::serial(), Parallel::new(2).expect("two threads")]
}

/// A number in -1..1 that depends on `seed` alone.
pub fn noise(seed: usize) -> f64 {
    let mut x = (seed as u64).wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    x = (x ^ (x >> 31)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x ^= x >> 29;
    (x >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// Cell centres of a lattice of `cells` from `corner`, which need not be the origin.
pub fn lattice<T: Real, const D: usize>(corner: [f64; D], cells: [usize; D], l0: f64) -> Vec<Vector<T, D>> {
    (0..cells.iter().product())
        .map(|index: usize| {
            let mut rest = index;
            Vector::from_fn(|axis, _| {
                let k = rest % cells[axis];
                rest /= cells[axis];
                T::of(corner[axis] + (k as f64 + 0.5) * l0)
            })
        })
        .collect()
}

/// A lattice from the origin whose particles have moved a little: what rows look like in a flow.
pub fn disordered<T: Real, const D: usize>(cells: [usize; D]) -> Vec<Vector<T, D>> {
    let mut points = lattice::<T, D>([0.0; D], cells, SPACING);
    for (i, point) in points.iter_mut().enumerate() {
        for axis in 0..D {
            point[axis] += T::of(JITTER * SPACING * noise(D * i + axis));
        }
    }
    points
}

/// What a tank has besides water.
#[derive(Clone, Copy, Debug)]
pub struct Features {
    /// Pairwise collisions (DPC).
    pub collisions: bool,
    /// Density diffusion.
    pub diffusion: bool,
    /// Floor and side walls.
    pub walls: bool,
    /// Parts of the particle shifting (icPS), 0 for none.
    pub shifting: u32,
}

impl Features {
    /// What the elastic gate uses, but for its weight.
    pub const GATE: Self = Self { collisions: true, diffusion: true, walls: true, shifting: 0 };
}

/// A tank of water under gravity, disordered and slightly in motion.
pub fn tank<T: Real, const D: usize>(cells: [usize; D], features: Features) -> Water<T, D> {
    let configure = |config: &mut FluidConfig<T, D>| {
        if !features.collisions {
            config.collisions = None;
        }
        if !features.diffusion {
            config.diffusion = Diffusion::None;
        }
        if features.shifting > 0 {
            config.shifting = Some(Shifting { iterations: features.shifting, ..Shifting::default() });
        }
    };
    tank_with(cells, features.walls.then_some(Slip::Free), configure, artificial)
}

/// The viscosity of the gate.
pub fn artificial<T: Real, const D: usize>(
    config: &FluidConfig<T, D>,
    reference: &ReferenceDensity<T>,
) -> ArtificialViscosity<T> {
    ArtificialViscosity::new::<D>(T::of(0.02), config.sound_speed, reference)
}

/// As [`tank`], with any numerics, any viscosity, and walls of the given slip or none.
pub fn tank_with<T: Real, const D: usize, V: Viscosity<T, D>>(
    cells: [usize; D],
    walls: Option<Slip>,
    configure: impl FnOnce(&mut FluidConfig<T, D>),
    viscosity: impl FnOnce(&FluidConfig<T, D>, &ReferenceDensity<T>) -> V,
) -> Fluid<T, D, Rational, V> {
    let height = cells[D - 1] as f64 * SPACING;
    let sound_speed = 10.0 * (2.0 * GRAVITY * height).sqrt();
    let mut config = FluidConfig::<T, D>::water(T::of(SPACING), T::of(sound_speed));
    config.gravity[D - 1] = T::of(-GRAVITY);
    configure(&mut config);
    let mut particles = FluidParticles::at_rest(disordered::<T, D>(cells));
    let eos = config.equation_of_state();
    for i in 0..particles.position.len() {
        let depth = T::of(height) - particles.position[i][D - 1];
        particles.density[i] = eos.density(config.density * T::of(GRAVITY) * depth);
        for axis in 0..D {
            particles.velocity[i][axis] = T::of(0.01 * sound_speed * noise(D * i + axis + 1_000_000));
        }
    }
    let mut boundary = Boundary::default();
    if let Some(slip) = walls {
        boundary.add_wall(&tank_walls::<T, D>(cells), slip).expect("walls come first");
    }
    let described = config.clone();
    Fluid::new(config, Rational, |r| viscosity(&described, r), Open, particles, boundary)
        .expect("a valid tank")
}

/// Three layers of points below and beside the tank.
fn tank_walls<T: Real, const D: usize>(cells: [usize; D]) -> Vec<Vector<T, D>> {
    const LAYERS: usize = 3;
    let mut around = cells.map(|n| n + 2 * LAYERS);
    around[D - 1] = cells[D - 1] + LAYERS;
    let inside = |p: &Vector<T, D>| {
        (0..D).all(|axis| {
            let x = p[axis].to_double();
            x > 0.0 && (axis == D - 1 || x < cells[axis] as f64 * SPACING)
        })
    };
    let mut points = lattice([-(LAYERS as f64) * SPACING; D], around, SPACING);
    points.retain(|p| !inside(p));
    points
}

/// A rubber block, clamped at its top.
pub fn rubber<const D: usize>(lower: [f64; D], upper: [f64; D], cells: [usize; D]) -> Rubber<D> {
    let body = block(lower.into(), upper.into(), cells, &[Face::upper(D - 1)]).expect("a valid block");
    let material = CorotationalHooke::new(7.8e6, 0.47).expect("valid rubber");
    let (config, serial) = (SolidConfig::default(), Parallel::serial());
    Solid::new(body.particles, body.spacing, 1100.0, material, WendlandC2, config, &serial)
        .expect("a valid solid")
}

/// The gate of `across` particles across its thickness: 4 x 63 for 4.
pub fn gate(across: usize) -> Rubber {
    let (lower, upper) = ([0.1, 0.0], [0.105, 0.079]);
    let spacing = 0.005 / across as f64;
    let cells = counts(&lower.into(), &upper.into(), spacing, &[Face::upper(1)]);
    rubber(lower, upper, cells)
}

/// The dam break through an elastic gate, at the moment the gate is let go, with the weight of the paper and 4 particles across.
pub fn gate_scene(l0: f64) -> GateScene {
    let (width, depth) = (0.1, 0.14);
    let sound_speed = 10.0 * (2.0 * GRAVITY * depth).sqrt();
    let mut config = FluidConfig::<f64, 2>::water(l0, sound_speed);
    config.gravity[1] = -GRAVITY;
    let mut particles = FluidParticles::at_rest(fill([0.0, 0.0], [width, depth], l0));
    let eos = config.equation_of_state();
    for (n, r) in particles.density.iter_mut().zip(&particles.position) {
        *n = eos.density(config.density * GRAVITY * (depth - r[1]));
    }
    let layers = 3.0 * l0;
    let mut walls = fill([-layers, 0.0], [0.0, 0.18], l0);
    walls.extend(fill([-layers, -layers], [0.2, 0.0], l0));
    walls.extend(fill([width, 0.079], [width + layers, 0.18], l0));
    let mut boundary = Boundary::default();
    boundary.add_wall(&walls, Slip::Free).expect("walls come first");
    let fluid = Fluid::new(
        config,
        Rational,
        |reference| ArtificialViscosity::new::<2>(0.02, sound_speed, reference),
        Open,
        particles,
        boundary,
    )
    .expect("a valid fluid");
    let mut scene = Scene::new(fluid);
    scene
        .add_structure(&Parallel::serial(), Box::new(ElasticBody::new(gate(4))), Slip::Free)
        .expect("a valid gate");
    scene
}

fn fill(lower: [f64; 2], upper: [f64; 2], l0: f64) -> Vec<Vector<f64, 2>> {
    let cells = [0, 1].map(|axis| ((upper[axis] - lower[axis]) / l0).round() as usize);
    lattice(lower, cells, l0)
}
