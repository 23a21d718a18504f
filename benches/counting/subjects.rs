//! Everything that is counted, by name.
//!
//! Steps are so short that nothing moves: the rows stay, and every step does the same work. Everything runs on one thread.

use super::lean::Lean;
use super::recipe::{Physics, Recipe};
use crate::{RADIUS_RATIO, SKIN_RATIO, SPACING, artificial, disordered, rubber, tank_with};
use mps_coupling::{ElasticBody, Scene};
use mps_fluid::{
    Fluid, FluidConfig, FluidParticles, Inlet, LaminarViscosity, Opening, Outlet, Slip, Viscosity,
};
use mps_kernel::weights::Rational;
use mps_kernel::{Real, ReferenceDensity, Vector};
use mps_neighbors::{Cells, Open, Parallel, Permutation, Rows};

/// Particles of the tanks in the plane.
const PLANE: [usize; 2] = [80, 60];
/// Particles of the tanks in space.
const SPACE: [usize; 3] = [20, 12, 15];
/// Particles across the elastic body.
const ACROSS: usize = 4;
/// Length of a step \[s\].
const NO_TIME: f64 = 1e-12;

/// Something whose steps are counted. The first two have been done.
pub struct Subject {
    /// Particles that take part in a step.
    pub particles: usize,
    /// One step.
    pub step: Box<dyn FnMut()>,
}

/// A subject that is yet to be made.
pub struct Entry {
    /// Dimension, precision and what it is, as `2d/f64/walls`.
    pub name: String,
    /// Builds it and does the first steps, which find the rows and fetch the memory.
    pub make: Box<dyn Fn() -> Subject>,
}

/// All subjects.
pub fn entries() -> Vec<Entry> {
    let mut all = Vec::new();
    fluids::<f64, 2>(&mut all, "2d/f64", PLANE);
    options(&mut all, "2d/f64", PLANE);
    coupled(&mut all, "2d/f64", PLANE);
    fluids::<f32, 2>(&mut all, "2d/f32", PLANE);
    fluids::<f64, 3>(&mut all, "3d/f64", SPACE);
    options(&mut all, "3d/f64", SPACE);
    coupled(&mut all, "3d/f64", SPACE);
    all
}

fn add(all: &mut Vec<Entry>, name: String, make: impl Fn() -> Subject + 'static) {
    all.push(Entry { name, make: Box::new(make) });
}

/// Steps of the fluid with nothing and with what the elastic gate has, and its sweeps one by one.
fn fluids<T: Real, const D: usize>(all: &mut Vec<Entry>, prefix: &str, cells: [usize; D]) {
    let mut step =
        |name: &str, recipe| add(all, format!("{prefix}/{name}"), move || fluid::<T, D>(cells, recipe));
    step("bare", Recipe(&[]));
    step("gate", Recipe::GATE);
    add(all, format!("{prefix}/lean"), move || {
        let (mut lean, parallel) =
            (Lean::<T, D>::of(&tank(cells, Recipe(&[]), |_, _| ())), Parallel::serial());
        repeated(lean.particles(), move || lean.sweep(&parallel))
    });
    sweeps::<T, D>(all, prefix, cells);
}

/// Steps of the fluid with one physics each.
fn options<const D: usize>(all: &mut Vec<Entry>, prefix: &str, cells: [usize; D]) {
    let mut step =
        |name: &str, recipe| add(all, format!("{prefix}/{name}"), move || fluid::<f64, D>(cells, recipe));
    for physics in Physics::ALL.iter().filter(|physics| **physics != Physics::Structure) {
        step(physics.name(), Recipe(core::slice::from_ref(physics)));
    }
    step("walls+laminar-viscosity", Recipe(&[Physics::Walls, Physics::Laminar]));
}

/// Steps of a fluid with the viscosity of the recipe.
fn fluid<T: Real, const D: usize>(cells: [usize; D], recipe: Recipe) -> Subject {
    if recipe.has(Physics::Artificial) {
        stepping(cells, recipe, tank::<T, D, _>(cells, recipe, artificial))
    } else if recipe.has(Physics::Laminar) || recipe.has(Physics::NoSlip) {
        let laminar = |_: &_, lattice: &_| LaminarViscosity::new::<D>(T::of(1e-6), lattice);
        stepping(cells, recipe, tank::<T, D, _>(cells, recipe, laminar))
    } else {
        stepping(cells, recipe, tank::<T, D, _>(cells, recipe, |_, _| ()))
    }
}

fn tank<T: Real, const D: usize, V: Viscosity<T, D>>(
    cells: [usize; D],
    recipe: Recipe,
    viscosity: impl FnOnce(&FluidConfig<T, D>, &ReferenceDensity<T>) -> V,
) -> Fluid<T, D, Rational, V> {
    tank_with(cells, recipe.walls(), |config| recipe.configure(config), viscosity)
}

/// What a fluid gets once it is there, and then its steps.
fn stepping<T: Real, const D: usize, V: Viscosity<T, D> + 'static>(
    cells: [usize; D],
    recipe: Recipe,
    mut fluid: Fluid<T, D, Rational, V>,
) -> Subject {
    if recipe.has(Physics::Openings) {
        let upper = Vector::from_fn(|axis, _| T::of(cells[axis] as f64 * SPACING));
        let at = |at: T| Opening { axis: 0, at, forward: true, lower: Vector::zeros(), upper };
        fluid.add_inlet(Inlet::new(at(T::zero()), |_, _| T::of(0.1))).expect("an inlet");
        fluid.add_outlet(Outlet::absorbing(at(upper[0]))).expect("an outlet");
    }
    if recipe.has(Physics::Books) {
        fluid.keep_books();
    }
    let parallel = Parallel::serial();
    repeated(fluid.particles().position.len(), move || {
        fluid.begin_step(&parallel).expect("a finite state");
        fluid.finish_step(&parallel, T::of(NO_TIME));
        assert_eq!(fluid.rebuilds(), 1, "the steps were meant to leave the rows alone");
    })
}

/// Two steps done: what belongs to the length of the last step begins with the second.
fn repeated(particles: usize, mut step: impl FnMut() + 'static) -> Subject {
    step();
    step();
    Subject { particles, step: Box::new(step) }
}

/// The sweeps of the fluid with what the elastic gate has besides collisions, and what finds the rows.
fn sweeps<T: Real, const D: usize>(all: &mut Vec<Entry>, prefix: &str, cells: [usize; D]) {
    let recipe = Recipe(&[Physics::Walls, Physics::Artificial, Physics::Filter]);
    let tank = move || tank::<T, D, _>(cells, recipe, artificial);
    let particles: usize = cells.iter().product();
    add(all, format!("{prefix}/sweep/momentum"), move || {
        let (mut fluid, parallel) = (tank(), Parallel::serial());
        repeated(particles, move || {
            fluid.begin_step(&parallel).expect("a finite state");
        })
    });
    // The density half has its turn only behind the momentum half.
    add(all, format!("{prefix}/sweep/halves"), move || {
        let (mut fluid, parallel) = (tank(), Parallel::serial());
        repeated(particles, move || {
            fluid.begin_step(&parallel).expect("a finite state");
            fluid.finish_step(&parallel, T::of(NO_TIME));
        })
    });
    add(all, format!("{prefix}/sweep/packing"), move || {
        let (mut fluid, parallel) = (tank(), Parallel::serial());
        repeated(particles, move || fluid.measure_packing(&parallel).expect("a finite state"))
    });
    let reach = T::of((RADIUS_RATIO + SKIN_RATIO) * SPACING);
    add(all, format!("{prefix}/search/sort"), move || {
        let mut particles = FluidParticles::at_rest(disordered::<T, D>(cells));
        let (mut grid, mut permutation, parallel) =
            (Cells::new(), Permutation::default(), Parallel::serial());
        repeated(particles.position.len(), move || {
            grid.build(&parallel, &Open, &particles.position, reach).expect("finite positions");
            permutation.apply(&mut particles, grid.order()).expect("an order");
        })
    });
    add(all, format!("{prefix}/search/rows"), move || {
        let points = disordered::<T, D>(cells);
        let (mut grid, mut rows, parallel) = (Cells::new(), Rows::default(), Parallel::serial());
        grid.build(&parallel, &Open, &points, reach).expect("finite positions");
        repeated(points.len(), move || {
            rows.build_within(&parallel, &Open, &grid, &points, reach).expect("finite positions");
        })
    });
}

/// Steps of a scene without a body and with one, and those of the body alone.
fn coupled<const D: usize>(all: &mut Vec<Entry>, prefix: &str, cells: [usize; D]) {
    let tank = move || tank::<f64, D, _>(cells, Recipe(&[]), |_, _| ());
    add(all, format!("{prefix}/scene"), move || scene(Scene::new(tank())));
    add(all, format!("{prefix}/structure"), move || {
        let (parallel, body) = (Parallel::serial(), Box::new(ElasticBody::new(beside(cells))));
        let mut wet = Scene::new(tank());
        wet.add_structure(&parallel, body, Slip::Free).expect("a valid body");
        scene(wet)
    });
    add(all, format!("{prefix}/solid/force"), move || {
        let (parallel, mut body) = (Parallel::serial(), beside(cells));
        repeated(body.len(), move || body.refresh(&parallel).expect("a finite state"))
    });
    add(all, format!("{prefix}/solid/sub-step"), move || {
        let (parallel, mut body) = (Parallel::serial(), beside(cells));
        let (no_load, gravity) = (vec![Vector::zeros(); body.len()], Vector::zeros());
        let dt = body.max_step(&parallel);
        repeated(body.len(), move || {
            body.advance(&parallel, &no_load, &gravity, dt, 1).expect("a stable step");
        })
    });
}

/// A rubber plate beside the water, clamped at its top.
fn beside<const D: usize>(cells: [usize; D]) -> crate::Rubber<D> {
    let (mut lower, mut upper) = ([0.0; D], cells.map(|n| n as f64 * SPACING));
    lower[0] = upper[0];
    upper[0] += ACROSS as f64 * SPACING;
    let mut particles = cells;
    particles[0] = ACROSS;
    rubber(lower, upper, particles)
}

fn scene<const D: usize>(mut scene: Scene<f64, D>) -> Subject {
    let parallel = Parallel::serial();
    // The audit is done every hundredth step: none of it is in the price of the others.
    scene.audit_interval = 0;
    repeated(scene.fluid().particles().position.len(), move || {
        scene.step(&parallel, NO_TIME).expect("a stable step");
    })
}
