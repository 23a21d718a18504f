//! Geometry and numerics of case 2: a column of water let go in a closed tank.

use mps_examples::{Failure, released_column};
use mps_fluid::{
    ArtificialViscosity, Boundary, Diffusion, Dpc, EquationOfState, Fluid, FluidConfig, FluidError,
    FluidParticles, PressureForm, Shifting, Slip, Tension,
};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Open, Parallel};
use std::ops::Range;

/// Height `H` of the column \[m\] (paper, section 3.2). The experiment had half of it, and all its other
/// lengths as well, so that results agree where they are compared: in `x/H`, `t sqrt(g/H)` and `p/(rho g H)`.
pub(crate) const HEIGHT: f64 = 0.6;
/// Length of the column, from the back wall to the gate \[m\].
pub(crate) const LENGTH: f64 = 2.0 * HEIGHT;
/// Length of the tank \[m\].
pub(crate) const TANK: f64 = 5.366 * HEIGHT;
/// Height of the walls \[m\]: nothing splashes that high.
pub(crate) const WALL_HEIGHT: f64 = 4.0 * HEIGHT;
/// Acceleration of gravity \[m/s^2\].
pub(crate) const GRAVITY: f64 = 9.81;
/// Density \[kg/m^3\].
pub(crate) const DENSITY: f64 = 1000.0;
/// Unit of time `sqrt(H/g)` \[s\]; the root is written out because a constant cannot take it.
pub(crate) const TIME: f64 = 0.247_309_683_4;
/// Unit of pressure `rho g H` \[Pa\].
pub(crate) const PRESSURE: f64 = DENSITY * GRAVITY * HEIGHT;
/// Speed of the lifted gate \[m/s\]: the median 3.46 m/s of the experiment, at this scale.
const GATE_SPEED: f64 = 3.46 * std::f64::consts::SQRT_2;
/// Until the gate of the experiment is clear of the water, over `sqrt(H/g)`.
pub(crate) const OPENING_TIME: f64 = HEIGHT / GATE_SPEED / TIME;

/// Spacing of the points of the walls, over that of the particles: smooth to water that slides by.
pub(crate) const WALL_SPACING: f64 = 0.5;

/// Kinematic viscosity \[m^2/s\] with which the friction of the walls is that of the experiment: water at twice its size has the Reynolds
/// number `H sqrt(g H)/nu` of the experiment with `2^(3/2)` times the viscosity.
pub(crate) const WALL_VISCOSITY: f64 = 1e-6 * 2.0 * std::f64::consts::SQRT_2;

/// The water.
pub(crate) type Water<T, K> = Fluid<T, 2, K, ArtificialViscosity<T>>;

/// How the column is let go.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Release {
    /// The gate is gone at `t = 0`
    Instant,
    /// The gate is lifted from `t = 0` on with the median speed of the experiment
    Lifted,
}

/// How the water moves along the tank.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Walls {
    /// Freely
    Free,
    /// Held back by their turbulent boundary layer, as in the experiment
    Law,
}

/// Diffusion of the density.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Smoothing {
    /// The filter of the paper with this strength; 0 for none.
    Filter(f64),
    /// The one with the hydrostatic part removed.
    Hydrostatic,
}

/// Everything the command line can change.
#[derive(Clone, Debug)]
pub(crate) struct Settings {
    /// Spacing of the particles \[m\].
    pub(crate) spacing: f64,
    /// Effective radius over the spacing.
    pub(crate) radius: f64,
    /// Simulated time \[s\].
    pub(crate) end_time: f64,
    /// How the column is let go.
    pub(crate) release: Release,
    /// How the water moves along bed and walls.
    pub(crate) walls: Walls,
    /// Numerical sound speed over `sqrt(2 g H)`.
    pub(crate) sound_ratio: f64,
    /// Courant number.
    pub(crate) cfl: f64,
    /// Strength of the density diffusion.
    pub(crate) diffusion: Smoothing,
    /// Strength of the artificial viscosity.
    pub(crate) alpha: f64,
    /// What becomes of pressures below zero.
    pub(crate) tension: Tension,
    /// Whether close particles collide.
    pub(crate) collisions: bool,
    /// Sub-shifts a step; 0 for none.
    pub(crate) shifting: u32,
    /// Form of pressure gradient and divergence.
    pub(crate) pressure_form: PressureForm,
}

/// Numerical sound speed \[m/s\].
pub(crate) fn sound_speed(settings: &Settings) -> f64 {
    settings.sound_ratio * (2.0 * GRAVITY * HEIGHT).sqrt()
}

/// The water in its tank, and the gate while it is there.
pub(crate) struct DamBreak<T: Real, K: Kernel<T>> {
    fluid: Water<T, K>,
    /// Points of the boundary that make up the gate; empty without one.
    gate: Range<usize>,
}

impl<T: Real, K: Kernel<T>> DamBreak<T, K> {
    /// The column at rest, under the pressure it has behind the gate or at the moment the gate is gone.
    pub(crate) fn new(settings: &Settings, weight: K) -> Result<Self, Failure> {
        let l0 = settings.spacing;
        let mut config = FluidConfig::<T, 2>::water(T::of(l0), T::of(sound_speed(settings)));
        config.density = T::of(DENSITY);
        config.radius_ratio = T::of(settings.radius);
        config.gravity = Vector::from([T::zero(), T::of(-GRAVITY)]);
        config.cfl = T::of(settings.cfl);
        config.pressure_form = settings.pressure_form;
        config.diffusion = match settings.diffusion {
            Smoothing::Hydrostatic => Diffusion::Hydrostatic,
            Smoothing::Filter(delta) => Diffusion::filter(delta),
        };
        config.tension = settings.tension;
        config.wall_viscosity = T::of(WALL_VISCOSITY);
        config.collisions = settings.collisions.then(Dpc::default);
        config.shifting = (settings.shifting > 0)
            .then(|| Shifting { iterations: settings.shifting, ..Shifting::default() });

        let mut particles = FluidParticles::at_rest(fill([0.0, 0.0], [LENGTH, HEIGHT], l0));
        let eos = config.equation_of_state();
        for (n, r) in particles.density.iter_mut().zip(&particles.position) {
            let [x, y] = [r[0], r[1]].map(Real::to_double);
            *n = eos.density(T::of(match settings.release {
                Release::Instant => pressure_when_released(x, y),
                Release::Lifted => DENSITY * GRAVITY * (HEIGHT - y),
            }));
        }
        let mut boundary = Boundary::default();
        // A quarter of a particle each.
        let volume = T::of(WALL_SPACING * WALL_SPACING);
        let depth = wall_depth(settings);
        let slip = match settings.walls {
            Walls::Law => Slip::Law,
            Walls::Free => Slip::Free,
        };
        boundary.add_fine_wall(&tank(l0, depth), volume, slip);
        let gate = match settings.release {
            Release::Instant => 0..0,
            Release::Lifted => {
                boundary.add_fine_wall(&gate(l0, depth), volume, Slip::Free).unwrap_or_default()
            }
        };
        let wall = far_wall(l0, depth);
        // A structure, because only of those the load is kept.
        boundary.add_structure(&wall, wall.iter().map(|_| volume), slip);
        let (c, alpha) = (config.sound_speed, T::of(settings.alpha));
        let viscosity = |reference: &_| ArtificialViscosity::new::<2>(alpha, c, reference);
        let fluid = Fluid::new(config, weight, viscosity, Open, particles, boundary)?;
        Ok(Self { fluid, gate })
    }

    /// One step; returns its length \[s\].
    pub(crate) fn step(&mut self, parallel: &Parallel) -> Result<T, FluidError> {
        let dt = self.fluid.begin_step(parallel)?;
        let speed = Vector::from([T::zero(), T::of(GATE_SPEED)]);
        self.fluid.boundary_mut().velocity[self.gate.clone()].fill(speed);
        self.fluid.finish_step(parallel, dt);
        self.lift(speed * dt);
        Ok(dt)
    }

    /// Moves the gate; once it is above the water it is put away.
    fn lift(&mut self, by: Vector<T, 2>) {
        let Some(lowest) = self.gate.clone().next() else { return };
        let boundary = self.fluid.boundary_mut();
        let gone = boundary.position[lowest][1] > T::of(1.5 * HEIGHT);
        let by = if gone { Vector::from([T::zero(), T::of(2.0 * WALL_HEIGHT)]) } else { by };
        boundary.position[self.gate.clone()].iter_mut().for_each(|r| *r += by);
        if gone {
            boundary.velocity[self.gate.clone()].fill(Vector::zeros());
            self.gate = 0..0;
        }
    }

    pub(crate) fn fluid(&self) -> &Water<T, K> {
        &self.fluid
    }

    pub(crate) fn fluid_mut(&mut self) -> &mut Water<T, K> {
        &mut self.fluid
    }
}

/// Pressure \[Pa\] in the column at the moment the gate is gone.
fn pressure_when_released(x: f64, y: f64) -> f64 {
    DENSITY * GRAVITY * released_column(HEIGHT, LENGTH, x, y)
}

/// Thickness of the walls \[m\]: whole layers of points, at least as deep as the effective radius. With less than a whole layer left over the
/// rows, which are counted from the far side, would begin before or behind the surface they stand for.
pub(crate) fn wall_depth(settings: &Settings) -> f64 {
    layers_of(settings.radius) * settings.spacing
}

/// The radius in spacings, rounded up to whole layers.
fn layers_of(radius: f64) -> f64 {
    (radius / WALL_SPACING).ceil() * WALL_SPACING
}

/// Bed and back wall: layers of points as deep as the effective radius.
fn tank<T: Real>(l0: f64, depth: f64) -> Vec<Vector<T, 2>> {
    let spacing = WALL_SPACING * l0;
    let mut points = fill([-depth, 0.0], [0.0, WALL_HEIGHT], spacing);
    // From the far wall backwards, so that its points go on in those of the wall.
    let length = bed_length(l0, depth);
    points.extend(fill([TANK - length, -depth], [TANK, 0.0], spacing));
    points
}

/// Length of the bed \[m\], in whole points, from the far wall to beyond the back wall, which is `depth` \[m\] thick.
pub(crate) fn bed_length(l0: f64, depth: f64) -> f64 {
    let spacing = WALL_SPACING * l0;
    ((TANK + depth) / spacing).ceil() * spacing
}

/// The wall with the sensors, down to the lowest layer of the bed. Its surface is where the tank ends,
/// whether or not that is a whole number of spacings.
fn far_wall<T: Real>(l0: f64, depth: f64) -> Vec<Vector<T, 2>> {
    fill([TANK, -depth], [TANK + depth, WALL_HEIGHT], WALL_SPACING * l0)
}

/// The gate in its place, the lowest row first.
fn gate<T: Real>(l0: f64, depth: f64) -> Vec<Vector<T, 2>> {
    fill([LENGTH, 0.0], [LENGTH + depth, 1.5 * HEIGHT], WALL_SPACING * l0)
}

/// Cell centres of a lattice that fills the box from `lower` with whole cells.
fn fill<T: Real>(lower: [f64; 2], upper: [f64; 2], l0: f64) -> Vec<Vector<T, 2>> {
    let count = |axis: usize| ((upper[axis] - lower[axis]) / l0).round().max(0.0) as usize;
    let (nx, ny) = (count(0), count(1));
    let place = |axis: usize, k: usize| T::of(lower[axis] + (k as f64 + 0.5) * l0);
    (0..nx * ny).map(|k| Vector::from([place(0, k % nx), place(1, k / nx)])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows at half a spacing begin a quarter of the water's spacing behind the surface, whatever the radius.
    #[test]
    fn bed_and_back_wall_begin_a_quarter_of_a_spacing_behind_their_surface() {
        let l0 = 0.02;
        for (radius, layers) in [(3.0, 6.0), (3.2, 7.0), (3.25, 7.0), (3.5, 7.0), (3.75, 8.0), (4.0, 8.0)] {
            let depth = layers_of(radius) * l0;
            assert_eq!(depth, layers * WALL_SPACING * l0);
            let points = tank::<f64>(l0, depth);
            // The bed is what lies under the water, the back wall what stands above the bed.
            let largest = |axis: usize, beside: usize| {
                let inside = points.iter().filter(|r| r[beside] > l0);
                inside.map(|r| r[axis]).fold(f64::NEG_INFINITY, f64::max) / l0
            };
            assert!((largest(1, 0) + 0.25).abs() < 1e-9, "bed with radius {radius}: {}", largest(1, 0));
            assert!((largest(0, 1) + 0.25).abs() < 1e-9, "wall with radius {radius}: {}", largest(0, 1));
        }
    }

    #[test]
    fn the_unit_of_time_is_the_root_it_stands_for() {
        assert!((TIME * TIME - HEIGHT / GRAVITY).abs() < 1e-10);
    }
}
