//! Scenes shared by the tests.
#![allow(dead_code, unreachable_pub, reason = "every test uses its own part")]

use mps_coupling::{ElasticBody, Inertia, Scene, Structure, StructureEnergy};
use mps_fluid::{
    ArtificialViscosity, Boundary, EquationOfState, Fluid, FluidConfig, FluidParticles, Slip, Tait,
};
use mps_kernel::Vector;
use mps_kernel::weights::{Rational, WendlandC2};
use mps_neighbors::{Open, Parallel};
use mps_solid::body::{self, Face};
use mps_solid::materials::CorotationalHooke;
use mps_solid::{Solid, SolidConfig};
use std::any::Any;
use std::error::Error;

pub type Rubber<const D: usize = 2> = ElasticBody<f64, D, CorotationalHooke<f64>>;
pub type Wet<const D: usize = 2> = Scene<f64, D, Rational, ArtificialViscosity<f64>>;

/// Reproducible noise in [-1, 1).
pub struct Noise(u64);

impl Noise {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(1))
    }

    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / (1_u64 << 30) as f64 - 1.0
    }

    pub fn vector<const D: usize>(&mut self, size: f64) -> Vector<f64, D> {
        Vector::from_fn(|_, _| size * self.next())
    }
}

/// Cell centres of the lattice with spacing `l0` in a box of `counts` cells from `corner`.
pub fn lattice<const D: usize>(corner: [f64; D], counts: [usize; D], l0: f64) -> Vec<Vector<f64, D>> {
    let total: usize = counts.iter().product();
    (0..total)
        .map(|mut k| {
            Vector::from_fn(|axis, _| {
                let cell = k % counts[axis];
                k /= counts[axis];
                corner[axis] + (cell as f64 + 0.5) * l0
            })
        })
        .collect()
}

pub fn rubber<const D: usize>(
    lower: [f64; D],
    upper: [f64; D],
    counts: [usize; D],
    clamp: &[Face],
    modulus: f64,
) -> Rubber<D> {
    Rubber::new(block(lower, upper, counts, clamp, modulus))
}

pub fn block<const D: usize>(
    lower: [f64; D],
    upper: [f64; D],
    counts: [usize; D],
    clamp: &[Face],
    modulus: f64,
) -> Solid<f64, D, CorotationalHooke<f64>> {
    let body = body::block(lower.into(), upper.into(), counts, clamp).unwrap();
    let material = CorotationalHooke::new(modulus, 0.4).unwrap();
    let config = SolidConfig::default();
    let serial = Parallel::serial();
    Solid::new(body.particles, body.spacing, 1100.0, material, WendlandC2, config, &serial).unwrap()
}

pub fn solid_of<const D: usize>(scene: &Wet<D>) -> &Solid<f64, D, CorotationalHooke<f64>> {
    scene.structure(0).unwrap().as_any().downcast_ref::<Rubber<D>>().unwrap().solid()
}

/// A rubber block that floats in a blob of fluid, alone in space. The fluid moves at random with up
/// to `speed` and drifts past the block.
pub fn floating(speed: f64) -> Wet {
    floating_in(speed, 24, 8)
}

/// The same in any dimension: the blob has `across` particles along each axis, the block in its middle `wide`.
pub fn floating_in<const D: usize>(speed: f64, across: usize, wide: usize) -> Wet<D> {
    let (l0, c) = (0.01, 10.0);
    let parallel = Parallel::serial();
    let [from, to] = [(across - wide) / 2, usize::midpoint(across, wide)].map(|k| k as f64 * l0);
    let inside = |r: &Vector<f64, D>| r.iter().all(|&x| x > from && x < to);
    let points = lattice([0.0; D], [across; D], l0).into_iter().filter(|r| !inside(r)).collect();
    let mut particles = FluidParticles::at_rest(points);
    let mut noise = Noise::new(5);
    let mut drift = Vector::zeros();
    drift[0] = speed;
    for (u, n) in particles.velocity.iter_mut().zip(&mut particles.density) {
        *u = drift + noise.vector::<D>(speed);
        *n += 0.005 * (1.0 + noise.next());
    }
    let viscosity = |r: &_| ArtificialViscosity::new::<D>(0.05, c, r);
    let config = FluidConfig::water(l0, c);
    let fluid = Fluid::new(config, Rational, viscosity, Open, particles, Boundary::default()).unwrap();
    let mut scene = Scene::new(fluid);
    let block = rubber([from; D], [to; D], [wide; D], &[], 1e6);
    scene.add_structure(&parallel, Box::new(block), Slip::Free).unwrap();
    scene
}

/// Water of `counts` particles, 2.5 mm apart, in a tank whose right side ends in a rubber gate 5 mm
/// thick that hangs from a wall at half the height, with air behind it.
pub fn gate(counts: [usize; 2], slip: Slip) -> Wet {
    let l0 = 2.5e-3;
    let parallel = Parallel::serial();
    let [width, depth] = counts.map(|n| n as f64 * l0);
    let mut config = FluidConfig::water(l0, 10.0 * (9.81 * depth).sqrt());
    config.gravity = Vector::<f64, 2>::new(0.0, -9.81);
    let eos = Tait::new(config.density, config.sound_speed);
    let mut particles = FluidParticles::at_rest(lattice([-width, 0.0], counts, l0));
    for (n, r) in particles.density.iter_mut().zip(&particles.position) {
        *n = eos.density(1000.0 * 9.81 * (depth - r.y));
    }
    let gate_rows = counts[1] / 2;
    let gate_height = gate_rows as f64 * l0;
    let mut walls = lattice([-width - 3.0 * l0, -3.0 * l0], [3, counts[1] + 13], l0);
    walls.extend(lattice([-width, -3.0 * l0], [counts[0] + 30, 3], l0));
    walls.extend(lattice([0.0, gate_height], [2, counts[1] + 10 - gate_rows], l0));
    let mut boundary = Boundary::default();
    boundary.add_wall(&walls, slip).unwrap();
    let c = config.sound_speed;
    let viscosity = |r: &_| ArtificialViscosity::new::<2>(0.02, c, r);
    let fluid = Fluid::new(config, Rational, viscosity, Open, particles, boundary).unwrap();
    let mut scene = Scene::new(fluid);
    // Clear of the floor by a fifth of a spacing.
    let clamp = [Face::upper(1)];
    let (lower, upper) = ([0.0, 0.2 * l0], [2.0 * l0, gate_height]);
    let rows = body::counts(&lower.into(), &upper.into(), 0.5 * l0, &clamp)[1];
    let plate = rubber(lower, upper, [4, rows], &clamp, 7.8e6);
    scene.add_structure(&parallel, Box::new(plate), slip).unwrap();
    scene
}

/// Largest rise of a series above its smallest value so far.
pub fn largest_rise(values: &[f64]) -> f64 {
    let mut least = f64::INFINITY;
    values.iter().fold(0.0, |rise, &value| {
        least = least.min(value);
        rise.max(value - least)
    })
}

/// A rigid piston on a spring that moves along y: the whole of another simulator.
pub struct Piston {
    pub position: Vec<Vector<f64, 2>>,
    pub mean: Vec<Vector<f64, 2>>,
    pub volume: Vec<f64>,
    pub spacing: f64,
    pub mass: f64,
    /// N/m
    pub stiffness: f64,
    /// Displacement from the rest of the spring.
    pub y: f64,
    pub v: f64,
    pub max_step: f64,
    /// Whether it tells its mass.
    pub open: bool,
    pub breaks: bool,
}

impl Piston {
    pub fn new(points: Vec<Vector<f64, 2>>, spacing: f64, mass: f64, stiffness: f64) -> Self {
        let len = points.len();
        Self {
            position: points,
            mean: vec![Vector::zeros(); len],
            volume: vec![spacing * spacing; len],
            spacing,
            mass,
            stiffness,
            y: 0.0,
            v: 0.0,
            max_step: f64::INFINITY,
            open: false,
            breaks: false,
        }
    }
}

impl Structure<f64, 2> for Piston {
    fn positions(&self) -> &[Vector<f64, 2>] {
        &self.position
    }

    fn mean_velocities(&self) -> &[Vector<f64, 2>] {
        &self.mean
    }

    fn volumes(&self) -> &[f64] {
        &self.volume
    }

    fn spacing(&self) -> f64 {
        self.spacing
    }

    fn max_step(&self, _parallel: &Parallel) -> f64 {
        self.max_step
    }

    fn inertia(&self) -> Inertia<'_, f64> {
        if self.open { Inertia::Rigid(self.mass) } else { Inertia::Unknown }
    }

    fn advance(
        &mut self,
        _parallel: &Parallel,
        force: &[Vector<f64, 2>],
        gravity: &Vector<f64, 2>,
        dt: f64,
        substeps: usize,
    ) -> Result<(), Box<dyn Error + Send + Sync>> {
        if self.breaks {
            return Err("the piston rod broke".into());
        }
        let push = force.iter().map(|f| f.y).sum::<f64>() / self.mass + gravity.y;
        let (h, start) = (dt / substeps as f64, self.y);
        for _ in 0..substeps {
            self.v += h * (push - self.stiffness / self.mass * self.y);
            self.y += h * self.v;
        }
        let moved = Vector::<f64, 2>::new(0.0, self.y - start);
        self.position.iter_mut().for_each(|r| *r += moved);
        self.mean.fill(moved / dt);
        Ok(())
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn energy(&self, _parallel: &Parallel, gravity: &Vector<f64, 2>) -> StructureEnergy<f64> {
        StructureEnergy {
            kinetic: 0.5 * self.mass * self.v * self.v,
            strain: 0.5 * self.stiffness * self.y * self.y,
            potential: -self.mass * gravity.y * self.y,
        }
    }
}

/// A body that goes its way whatever pushes it.
pub struct Driven<const D: usize> {
    position: Vec<Vector<f64, D>>,
    velocity: Vec<Vector<f64, D>>,
    volume: Vec<f64>,
    spacing: f64,
}

impl<const D: usize> Driven<D> {
    pub fn new(position: Vec<Vector<f64, D>>, spacing: f64, velocity: Vector<f64, D>) -> Self {
        let len = position.len();
        Self { position, velocity: vec![velocity; len], volume: vec![spacing.powi(D as i32); len], spacing }
    }
}

impl<const D: usize> Structure<f64, D> for Driven<D> {
    fn positions(&self) -> &[Vector<f64, D>] {
        &self.position
    }

    fn mean_velocities(&self) -> &[Vector<f64, D>] {
        &self.velocity
    }

    fn volumes(&self) -> &[f64] {
        &self.volume
    }

    fn spacing(&self) -> f64 {
        self.spacing
    }

    fn max_step(&self, _: &Parallel) -> f64 {
        f64::INFINITY
    }

    fn advance(
        &mut self,
        _: &Parallel,
        _: &[Vector<f64, D>],
        _: &Vector<f64, D>,
        dt: f64,
        _: usize,
    ) -> Result<(), Box<dyn Error + Send + Sync>> {
        self.position.iter_mut().zip(&self.velocity).for_each(|(r, u)| *r += u * dt);
        Ok(())
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn energy(&self, _: &Parallel, _: &Vector<f64, D>) -> StructureEnergy<f64> {
        StructureEnergy::default()
    }
}

/// A column of water, endless sideways, between a floor and a piston.
pub mod column {
    use super::{Piston, lattice};
    use mps_coupling::Scene;
    use mps_fluid::{Boundary, Fluid, FluidConfig, FluidParticles, Slip, Tension};
    use mps_kernel::Vector;
    use mps_kernel::weights::Rational;
    use mps_neighbors::{Parallel, PeriodicBox};

    pub const L0: f64 = 0.01;
    /// Speed of sound.
    pub const C: f64 = 10.0;
    const COLUMNS: usize = 10;
    const ROWS: usize = 20;
    pub const WIDTH: f64 = COLUMNS as f64 * L0;
    pub const HEIGHT: f64 = ROWS as f64 * L0;
    /// Mass of the water.
    pub const WATER: f64 = 1000.0 * WIDTH * HEIGHT;
    /// Stiffness of the column at rest.
    pub const STIFFNESS: f64 = 1000.0 * C * C * WIDTH / HEIGHT;

    pub type Column = Scene<f64, 2, Rational, (), PeriodicBox<f64, 2>>;

    /// The piston has the given mass and spring and begins with `speed`; it moves in sub-steps of at most `sub_step`, the water with
    /// the Courant number `cfl`.
    pub fn column(mass: f64, stiffness: f64, speed: f64, steps: (f64, f64)) -> Column {
        column_under(mass, stiffness, speed, steps, false)
    }

    /// As [`column`]; the piston may tell its mass.
    pub fn column_under(
        mass: f64,
        stiffness: f64,
        speed: f64,
        (cfl, sub_step): (f64, f64),
        open: bool,
    ) -> Column {
        let parallel = Parallel::serial();
        let mut config = FluidConfig::water(L0, C);
        config.tension = Tension::Keep;
        config.cfl = cfl;
        let particles = FluidParticles::at_rest(lattice([0.0; 2], [COLUMNS, ROWS], L0));
        let mut boundary = Boundary::default();
        boundary.add_wall(&lattice([0.0, -3.0 * L0], [COLUMNS, 3], L0), Slip::Free).unwrap();
        let domain = PeriodicBox::new(Vector::zeros(), [Some(WIDTH), None]).unwrap();
        let fluid = Fluid::new(config, Rational, |_| (), domain, particles, boundary).unwrap();
        let mut scene = Scene::new(fluid);
        let mut piston = Piston::new(lattice([0.0, HEIGHT], [COLUMNS, 4], L0), L0, mass, stiffness);
        piston.v = speed;
        piston.max_step = sub_step;
        piston.open = open;
        scene.add_structure(&parallel, Box::new(piston), Slip::Free).unwrap();
        scene
    }

    /// Energy of water and piston.
    pub fn total(scene: &Column) -> f64 {
        let (fluid, piston) = scene.energy(&Parallel::serial());
        fluid.total() + piston.total()
    }

    pub fn piston(scene: &Column) -> &Piston {
        scene.structure(0).unwrap().as_any().downcast_ref::<Piston>().unwrap()
    }
}
