//! Scenes shared by the tests.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]
#![allow(dead_code, unreachable_pub, reason = "every test uses its own part")]

use mps_fluid::{
    ArtificialViscosity, Boundary, Diffusion, EquationOfState, Fluid, FluidConfig, FluidParticles,
    LaminarViscosity, PressureForm, Shifting, Slip, Tait, Tension, Viscosity,
};
use mps_kernel::weights::Rational;
use mps_kernel::{Kernel, Real, ReferenceDensity, Vector};
use mps_neighbors::{Open, Parallel};

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

    pub fn vector<T: Real, const D: usize>(&mut self, size: f64) -> Vector<T, D> {
        Vector::from_fn(|_, _| T::of(size * self.next()))
    }
}

/// Cell centres of the lattice with spacing `l0` in a box of `counts` cells from `corner`.
pub fn lattice<T: Real, const D: usize>(corner: [f64; D], counts: [usize; D], l0: f64) -> Vec<Vector<T, D>> {
    let total = counts.iter().product();
    (0..total)
        .map(|index: usize| {
            let mut rest = index;
            Vector::from_fn(|axis, _| {
                let k = rest % counts[axis];
                rest /= counts[axis];
                T::of(corner[axis] + (k as f64 + 0.5) * l0)
            })
        })
        .collect()
}

/// Three layers of points below and beside a box that is open at the top (the last axis).
pub fn tank_walls<T: Real, const D: usize>(counts: [usize; D], height: usize, l0: f64) -> Vec<Vector<T, D>> {
    let layers = 3;
    let mut around = counts.map(|n| n + 2 * layers);
    around[D - 1] = height + layers;
    let corner = [-(layers as f64) * l0; D];
    let inside = |p: &Vector<T, D>| {
        (0..D).all(|axis| {
            let x = p[axis].to_double();
            x > 0.0 && (axis == D - 1 || x < counts[axis] as f64 * l0)
        })
    };
    lattice::<T, D>(corner, around, l0).into_iter().filter(|p| !inside(p)).collect()
}

/// Three layers of points all around a box of `counts` cells at the origin.
pub fn closed_walls<const D: usize>(counts: [usize; D], l0: f64) -> Vec<Vector<f64, D>> {
    let inside = |p: &Vector<f64, D>| (0..D).all(|axis| p[axis] > 0.0 && p[axis] < counts[axis] as f64 * l0);
    lattice::<f64, D>([-3.0 * l0; D], counts.map(|n| n + 6), l0).into_iter().filter(|p| !inside(p)).collect()
}

/// A tank of `counts` particles at rest under gravity, with hydrostatic density and the paper's weight.
pub fn tank<T: Real, const D: usize, V: Viscosity<T, D>>(
    counts: [usize; D],
    config: FluidConfig<T, D>,
    viscosity: impl FnOnce(&ReferenceDensity<T>) -> V,
) -> Fluid<T, D, Rational, V> {
    tank_of(Rational, counts, config, viscosity)
}

/// [`tank`] with any weight.
pub fn tank_of<T: Real, const D: usize, V: Viscosity<T, D>, K: Kernel<T>>(
    kernel: K,
    counts: [usize; D],
    config: FluidConfig<T, D>,
    viscosity: impl FnOnce(&ReferenceDensity<T>) -> V,
) -> Fluid<T, D, K, V> {
    let l0 = config.spacing.to_double();
    let points = lattice::<T, D>([0.0; D], counts, l0);
    let mut particles = FluidParticles::at_rest(points);
    let eos = Tait::new(config.density, config.sound_speed);
    let surface = T::of(counts[D - 1] as f64 * l0);
    let g = -config.gravity[D - 1];
    for (n, r) in particles.density.iter_mut().zip(&particles.position) {
        *n = eos.density(config.density * g * (surface - r[D - 1]));
    }
    let mut boundary = Boundary::default();
    let height = counts[D - 1] + counts[D - 1] / 2;
    boundary.add_wall(&tank_walls::<T, D>(counts, height, l0), Slip::Free).unwrap();
    Fluid::new(config, kernel, viscosity, Open, particles, boundary).unwrap()
}

/// Water of the given spacing under gravity, `c = 10 sqrt(g H)`.
pub fn water<T: Real, const D: usize>(l0: f64, depth: f64) -> FluidConfig<T, D> {
    let mut config = FluidConfig::water(T::of(l0), T::of(10.0 * (9.81 * depth).sqrt()));
    config.gravity[D - 1] = T::of(-9.81);
    config
}

/// Spacing and sound speed of [`blob`].
pub const BLOB: (f64, f64) = (0.01, 10.0);

/// A block of fluid alone in space: a disturbed lattice with random velocities up to `speed` and
/// random densities within 1 %.
pub fn blob<const D: usize, V: Viscosity<f64, D>>(
    count: usize,
    speed: f64,
    config: FluidConfig<f64, D>,
    viscosity: impl FnOnce(&ReferenceDensity<f64>) -> V,
) -> Fluid<f64, D, Rational, V> {
    let mut noise = Noise::new(7);
    let l0 = config.spacing;
    let mut points = lattice::<f64, D>([0.0; D], [count; D], l0);
    for r in &mut points {
        *r += noise.vector::<f64, D>(0.15 * l0);
    }
    let mut particles = FluidParticles::at_rest(points);
    for (u, n) in particles.velocity.iter_mut().zip(&mut particles.density) {
        *u = noise.vector(speed);
        *n += 0.01 * noise.next();
    }
    Fluid::new(config, Rational, viscosity, Open, particles, Boundary::default()).unwrap()
}

/// Root mean square of `p - hydrostatic`, over the pressure at the bottom.
pub fn pressure_error<T: Real, const D: usize, V: Viscosity<T, D>, K: Kernel<T>>(
    fluid: &Fluid<T, D, K, V>,
    depth: f64,
) -> f64 {
    let particles = fluid.particles();
    let error = |(r, p): (&Vector<T, D>, &T)| {
        (p.to_double() - 1000.0 * 9.81 * (depth - r[D - 1].to_double())).powi(2)
    };
    let sum: f64 = particles.position.iter().zip(&particles.pressure).map(error).sum();
    (sum / particles.position.len() as f64).sqrt() / (1000.0 * 9.81 * depth)
}

/// Cell centres at the given spacing between `low` and `high` at which `keep` holds; surfaces at multiples of
/// the spacing lie half a spacing before the first of them.
pub fn fill<const D: usize>(
    low: [f64; D],
    high: [f64; D],
    spacing: f64,
    keep: impl Fn(&Vector<f64, D>) -> bool,
) -> Vec<Vector<f64, D>> {
    let counts = core::array::from_fn(|axis| ((high[axis] - low[axis]) / spacing).round() as usize);
    lattice::<f64, D>(low, counts, spacing).into_iter().filter(|r| keep(r)).collect()
}

/// What a step did to the momenta of the fluid.
pub struct Account {
    pub dt: f64,
    /// Force of the fluid on all walls \[N\].
    pub force: Vector<f64, 2>,
    /// Change of momentum that neither the walls nor gravity account for \[kg m/s\].
    pub lost: f64,
    /// The same of the angular momentum about the origin \[kg m^2/s\].
    pub lost_spin: f64,
}

/// `sum a x b` in the plane.
fn spin<'a>(pairs: impl Iterator<Item = (&'a Vector<f64, 2>, &'a Vector<f64, 2>)>) -> f64 {
    pairs.map(|(a, b)| a.x * b.y - a.y * b.x).sum()
}

/// One step among walls that are all reactive; `motion` sets the velocities the boundary points move with.
pub fn step_on_account<K: Kernel<f64>, V: Viscosity<f64, 2>>(
    fluid: &mut Fluid<f64, 2, K, V>,
    motion: impl FnOnce(&mut Boundary<f64, 2>, f64),
) -> Account {
    let parallel = Parallel::serial();
    let momenta = |fluid: &Fluid<f64, 2, K, V>| {
        let water = fluid.particles();
        let spin = spin(water.position.iter().zip(&water.velocity));
        (fluid.momentum(&parallel), spin * fluid.config().particle_mass())
    };
    let before = momenta(fluid);
    let dt = fluid.begin_step(&parallel).unwrap();
    let weight = fluid.config().gravity * fluid.config().particle_mass();
    let water = &fluid.particles().position;
    let (pull, turn) = (weight * water.len() as f64, spin(water.iter().map(|r| (r, &weight))));
    let walls = fluid.boundary();
    let force: Vector<f64, 2> = walls.force.iter().sum();
    let torque = spin(walls.position.iter().zip(&walls.force));
    motion(fluid.boundary_mut(), dt);
    fluid.finish_step(&parallel, dt);
    let after = momenta(fluid);
    let Boundary { position, velocity, .. } = fluid.boundary_mut();
    position.iter_mut().zip(velocity).for_each(|(r, u)| *r += *u * dt);
    Account {
        dt,
        force,
        lost: (after.0 - before.0 - (pull - force) * dt).norm(),
        lost_spin: (after.1 - before.1 - (turn - torque) * dt).abs(),
    }
}

/// The viscosities of [`everything`].
pub type Both<T> = (LaminarViscosity<T>, ArtificialViscosity<T>);

/// A shaken closed box with all that a fluid can have and the dam break has not: the corrected form, hydrostatic diffusion, relaxation, shifting,
/// collisions, tension, books; walls without slip below, with a law of the wall at the sides, and a block of reactive points that feels both viscosities.
pub fn everything<T: Real, const D: usize>(counts: [usize; D]) -> Fluid<T, D, Rational, Both<T>> {
    let l0 = 0.01;
    let mut config = water::<T, D>(l0, counts[D - 1] as f64 * l0);
    config.pressure_form = PressureForm::Corrected;
    config.diffusion = Diffusion::Hydrostatic;
    config.tension = Tension::Keep;
    config.background_pressure = T::of(2000.0);
    config.density_relaxation = T::of(0.01);
    config.shifting = Some(Shifting { strength: T::of(2.0), iterations: 2 });
    let (block, points): (Vec<_>, Vec<_>) = lattice::<T, D>([0.0; D], counts, l0)
        .into_iter()
        .partition(|r| (0..D).all(|axis| (r[axis].to_double() / l0 - 0.5 * counts[axis] as f64).abs() < 2.0));
    let mut noise = Noise::new(3);
    let mut particles = FluidParticles::at_rest(points);
    particles.velocity.iter_mut().for_each(|u| *u = noise.vector(1.0));
    let (below, beside): (Vec<_>, Vec<_>) =
        tank_walls::<T, D>(counts, counts[D - 1] + 3, l0).into_iter().partition(|r| r[D - 1] < T::zero());
    let mut boundary = Boundary::default();
    boundary.add_wall(&below, Slip::None).unwrap();
    boundary.add_wall(&beside, Slip::Law).unwrap();
    boundary.add_structure(&block, core::iter::repeat(T::one()), Slip::None);
    let c = config.sound_speed;
    let viscosity = |r: &_| {
        (LaminarViscosity::new::<D>(T::of(1e-4), r), ArtificialViscosity::new::<D>(T::of(0.05), c, r))
    };
    let mut fluid = Fluid::new(config, Rational, viscosity, Open, particles, boundary).unwrap();
    fluid.keep_books();
    fluid
}

/// A step of [`everything`] in which the block vibrates in two sub-steps.
pub fn vibrating_step<T: Real, const D: usize>(
    fluid: &mut Fluid<T, D, Rational, Both<T>>,
    parallel: &Parallel,
) {
    let dt = fluid.begin_step(parallel).unwrap();
    let block = fluid.boundary().reactive();
    for speed in [0.1, -0.1] {
        fluid.boundary_mut().velocity[block.clone()].fill(Vector::from_element(T::of(speed)));
        fluid.follow_shear();
        fluid.compress_interface(parallel, dt * T::of(0.5));
    }
    fluid.finish_step(parallel, dt);
}
