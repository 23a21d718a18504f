//! Geometry and materials of case 4: a dam break through an elastic gate.

use mps_coupling::{ElasticBody, Scene};
use mps_examples::Failure;
use mps_fluid::{
    ArtificialViscosity, Boundary, Diffusion, Dpc, EquationOfState, Fluid, FluidConfig, FluidParticles,
    PressureForm, Shifting, Slip,
};
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Open, Parallel};
use mps_solid::body::{Face, block};
use mps_solid::materials::CorotationalHooke;
use mps_solid::{Solid, SolidConfig};

/// Width of the reservoir \[m\] (Antoci, Gallati, Sibilla 2007).
pub(crate) const RESERVOIR_WIDTH: f64 = 0.1;
/// Depth of the water \[m\].
pub(crate) const WATER_DEPTH: f64 = 0.14;
/// Length of the gate \[m\].
pub(crate) const GATE_LENGTH: f64 = 0.079;
/// Thickness of the gate \[m\].
pub(crate) const GATE_THICKNESS: f64 = 0.005;
/// Height of the reservoir's walls \[m\].
pub(crate) const WALL_HEIGHT: f64 = 0.18;
/// Acceleration of gravity \[m/s^2\].
pub(crate) const GRAVITY: f64 = 9.81;

/// The fluid, with artificial viscosity, and the gate.
pub(crate) type GateScene<T, K> = Scene<T, 2, K, ArtificialViscosity<T>>;

/// The gate.
pub(crate) type Gate<T> = ElasticBody<T, 2, CorotationalHooke<T>>;

/// The rubber, as different authors set it. None of them is the measured one, which is nonlinear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rubber {
    /// Density \[kg/m^3\].
    pub(crate) density: f64,
    /// Young's modulus \[Pa\].
    pub(crate) youngs_modulus: f64,
    /// Poisson's ratio \[-\].
    pub(crate) poissons_ratio: f64,
}

/// Everything the command line can change.
#[derive(Clone, Debug)]
pub(crate) struct Settings {
    /// Spacing of the fluid particles \[m\].
    pub(crate) spacing: f64,
    /// Structure particles across the gate.
    pub(crate) across: usize,
    /// The rubber.
    pub(crate) rubber: Rubber,
    /// Simulated time \[s\], for the length of the floor.
    pub(crate) end_time: f64,
    /// Effective radius over the spacing.
    pub(crate) radius: f64,
    /// Least number of sub-steps of the gate in a step of the water.
    pub(crate) min_substeps: usize,
    /// Strength of the density diffusion, 0 for none.
    pub(crate) diffusion: f64,
    /// Whether close particles collide.
    pub(crate) collisions: bool,
    /// Numerical sound speed over `sqrt(2 g H)`, the speed of the jet.
    pub(crate) sound_ratio: f64,
    /// Courant number of the fluid.
    pub(crate) cfl: f64,
    /// Strength of the artificial viscosity.
    pub(crate) alpha: f64,
    /// Parts of the particle shifting in a step, 0 for none.
    pub(crate) shifting: u32,
    /// Form of pressure gradient and divergence.
    pub(crate) pressure_form: PressureForm,
}

/// Numerical sound speed \[m/s\].
pub(crate) fn sound_speed(settings: &Settings) -> f64 {
    settings.sound_ratio * (2.0 * GRAVITY * WATER_DEPTH).sqrt()
}

/// Builds the scene: reservoir full of water at rest, gate straight, everything let go at `t = 0`.
pub(crate) fn build<T: Real, K: Kernel<T>>(
    settings: &Settings,
    weight: K,
    parallel: &Parallel,
) -> Result<GateScene<T, K>, Failure> {
    let fluid = water(settings, weight)?;
    let gate = gate::<T>(settings, parallel)?;
    let mut scene = Scene::new(fluid);
    scene.min_substeps = settings.min_substeps;
    scene.add_structure(parallel, Box::new(ElasticBody::new(gate)), Slip::Free)?;
    Ok(scene)
}

fn water<T: Real, K: Kernel<T>>(
    settings: &Settings,
    weight: K,
) -> Result<Fluid<T, 2, K, ArtificialViscosity<T>>, Failure> {
    let l0 = settings.spacing;
    let mut config = FluidConfig::water(T::of(l0), T::of(sound_speed(settings)));
    config.gravity = Vector::from([T::zero(), T::of(-GRAVITY)]);
    config.radius_ratio = T::of(settings.radius);
    config.cfl = T::of(settings.cfl);
    config.diffusion = Diffusion::filter(settings.diffusion);
    config.collisions = settings.collisions.then(Dpc::default);
    config.pressure_form = settings.pressure_form;
    config.shifting =
        (settings.shifting > 0).then(|| Shifting { iterations: settings.shifting, ..Shifting::default() });

    let mut particles = FluidParticles::at_rest(fill([0.0, 0.0], [RESERVOIR_WIDTH, WATER_DEPTH], l0));
    let eos = config.equation_of_state();
    for (n, r) in particles.density.iter_mut().zip(&particles.position) {
        let depth = T::of(WATER_DEPTH) - r[1];
        *n = eos.density(config.density * T::of(GRAVITY) * depth);
    }
    let mut boundary = Boundary::default();
    boundary.add_wall(&walls(settings), Slip::Free);
    let c = config.sound_speed;
    let alpha = T::of(settings.alpha);
    let viscosity = |reference: &_| ArtificialViscosity::new::<2>(alpha, c, reference);
    Ok(Fluid::new(config, weight, viscosity, Open, particles, boundary)?)
}

/// Length of the floor behind the gate \[m\]: the jet leaves with less than twice the speed of free fall from the surface.
pub(crate) fn run_out(settings: &Settings) -> f64 {
    let run_out = 2.0 * (2.0 * GRAVITY * WATER_DEPTH).sqrt() * settings.end_time;
    run_out.max(0.05)
}

/// Thickness of the walls \[m\]: whole layers of points, at least as deep as the effective radius.
pub(crate) fn wall_depth(settings: &Settings) -> f64 {
    settings.radius.ceil() * settings.spacing
}

/// Left wall, floor on both sides of the gate, and the wall the gate hangs from: layers of points
/// as deep as the effective radius, the first half a spacing behind the surface.
fn walls<T: Real>(settings: &Settings) -> Vec<Vector<T, 2>> {
    let l0 = settings.spacing;
    let depth = wall_depth(settings);
    let right = RESERVOIR_WIDTH + GATE_THICKNESS + run_out(settings);
    let thickness = GATE_THICKNESS.max(depth);
    let mut points = fill([-depth, 0.0], [0.0, WALL_HEIGHT], l0);
    points.extend(fill([-depth, -depth], [right, 0.0], l0));
    points.extend(fill([RESERVOIR_WIDTH, GATE_LENGTH], [RESERVOIR_WIDTH + thickness, WALL_HEIGHT], l0));
    points
}

/// The gate: clamped where it hangs from the wall, free at the floor.
fn gate<T: Real>(
    settings: &Settings,
    parallel: &Parallel,
) -> Result<Solid<T, 2, CorotationalHooke<T>, WendlandC2>, Failure> {
    let rubber = settings.rubber;
    let lower = Vector::from([T::of(RESERVOIR_WIDTH), T::zero()]);
    let upper = Vector::from([T::of(RESERVOIR_WIDTH + GATE_THICKNESS), T::of(GATE_LENGTH)]);
    let top = [Face::upper(1)];
    let spacing = GATE_THICKNESS / settings.across as f64;
    let along = mps_solid::body::counts(&lower, &upper, T::of(spacing), &top)[1];
    let body = block(lower, upper, [settings.across, along], &top)?;
    let material = CorotationalHooke::new(T::of(rubber.youngs_modulus), T::of(rubber.poissons_ratio))?;
    Ok(Solid::new(
        body.particles,
        body.spacing,
        T::of(rubber.density),
        material,
        WendlandC2,
        SolidConfig::default(),
        parallel,
    )?)
}

/// Cell centres of a lattice that fills the box; the spacing is fitted to whole cells from `lower`.
fn fill<T: Real>(lower: [f64; 2], upper: [f64; 2], l0: f64) -> Vec<Vector<T, 2>> {
    let count = |axis: usize| ((upper[axis] - lower[axis]) / l0).round().max(0.0) as usize;
    let (nx, ny) = (count(0), count(1));
    let place = |axis: usize, k: usize| T::of(lower[axis] + (k as f64 + 0.5) * l0);
    (0..nx * ny).map(|k| Vector::from([place(0, k % nx), place(1, k / nx)])).collect()
}

/// Displacements \[m\] at the free end of the gate.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct FreeEnd {
    /// The lower corner on the side away from the water: the point the published runs follow.
    pub(crate) corner: [f64; 2],
    /// The middle of the free end.
    pub(crate) middle: [f64; 2],
}

/// Extrapolates linearly from the lowest two rows, whose particles lie half a spacing and one and a
/// half above the end, and for the corner from the outermost two particles of each.
pub(crate) fn free_end<T: Real>(
    positions: &[Vector<T, 2>],
    reference: &[Vector<T, 2>],
    across: usize,
) -> FreeEnd {
    let moved = |row: usize, column: usize| {
        let i = row * across + column;
        (positions[i] - reference[i]).map(|x| x.to_double())
    };
    let outward = |near: Vector<f64, 2>, far: Vector<f64, 2>| near * 1.5 - far * 0.5;
    let outer = |row| outward(moved(row, across - 1), moved(row, across - 2));
    let mean =
        |row| (0..across).fold(Vector::zeros(), |sum: Vector<f64, 2>, k| sum + moved(row, k)) / across as f64;
    let (corner, middle) = (outward(outer(0), outer(1)), outward(mean(0), mean(1)));
    FreeEnd { corner: corner.into(), middle: middle.into() }
}
