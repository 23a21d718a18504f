//! Fluid and walls from their description.

use super::layout::Layout;
use super::movers::Mover;
use super::openings::{inlet, outlet};
use super::start::pressures;
use super::{Viscous, vector, vectors};
use crate::Failure;
use mps_fluid as physics;
use mps_fluid::{Boundary, Dpc, EquationOfState, FluidConfig, FluidParticles, Shifting};
use mps_io::scene_file::{Diffusion, Fluid, PressureForm, SceneFile, Slip, Tension};
use mps_kernel::{Kernel, Real};
use mps_neighbors::Open;

/// The fluid of a scene.
pub(super) type Water<T, const D: usize, K> = physics::Fluid<T, D, K, Viscous<T>>;

/// A fluid with its walls, and those of them that move.
type Filled<T, const D: usize, K> = (Water<T, D, K>, Vec<Mover<T, D>>);

/// The parameters of the fluid.
pub(super) fn config<T: Real, const D: usize>(fluid: &Fluid, gravity: &[f64]) -> FluidConfig<T, D> {
    let numerics = &fluid.numerics;
    FluidConfig {
        density: T::of(fluid.density),
        radius_ratio: T::of(numerics.radius),
        gravity: vector(gravity),
        diffusion: match numerics.diffusion {
            Diffusion::Filter(delta) => physics::Diffusion::filter(delta),
            Diffusion::None => physics::Diffusion::None,
            Diffusion::Hydrostatic => physics::Diffusion::Hydrostatic,
        },
        cfl: T::of(numerics.cfl),
        tension: match numerics.tension {
            Tension::Clip => physics::Tension::Clip,
            Tension::Keep => physics::Tension::Keep,
        },
        background_pressure: T::of(numerics.background_pressure),
        pressure_form: match numerics.pressure_form {
            PressureForm::Plain => physics::PressureForm::Plain,
            PressureForm::Corrected => physics::PressureForm::Corrected,
        },
        collisions: numerics.collisions.then(Dpc::default),
        density_relaxation: T::of(numerics.density_relaxation),
        wall_viscosity: T::of(fluid.wall_viscosity),
        shifting: (numerics.shifting > 0)
            .then(|| Shifting { iterations: numerics.shifting, ..Shifting::default() }),
        ..FluidConfig::water(T::of(fluid.spacing), T::of(fluid.sound()))
    }
}

pub(super) fn slip(slip: Slip) -> physics::Slip {
    match slip {
        Slip::Free => physics::Slip::Free,
        Slip::None => physics::Slip::None,
        Slip::Law => physics::Slip::Law,
    }
}

/// The fluid with its walls, and the walls that move.
pub(super) fn water<T: Real, const D: usize, K: Kernel<T>>(
    scene: &SceneFile,
    fluid: &Fluid,
    layout: &Layout<D>,
    weight: K,
) -> Result<Filled<T, D, K>, Failure> {
    let config = config::<T, D>(fluid, &scene.gravity);
    let places: Vec<_> = layout.fluid.iter().flat_map(|body| vectors(body)).collect();
    let mut particles = FluidParticles::at_rest(places);
    let eos = config.equation_of_state();
    let mut first = 0;
    for (body, places) in fluid.bodies.iter().zip(&layout.fluid) {
        let here = first..first + places.len();
        let at_rest = pressures(body, &config, &particles.position[here.clone()]);
        for (i, above) in here.zip(at_rest) {
            particles.density[i] = eos.density(config.background_pressure + above);
            particles.velocity[i] = vector(&body.velocity);
        }
        first += places.len();
    }
    let mut boundary = Boundary::default();
    let mut movers = Vec::new();
    for (wall, parts) in scene.walls.iter().zip(&layout.walls) {
        let start = boundary.len();
        for part in parts {
            boundary.add_fine_wall(&vectors(&part.places), T::of(part.volume), slip(wall.slip));
        }
        if let Some(motion) = &wall.motion {
            movers.push(Mover::new(motion, &boundary, start..boundary.len()));
        }
    }
    let sound = config.sound_speed;
    let viscosity = |reference: &_| Viscous::new::<D>(&fluid.viscosity, sound, reference);
    let mut filled = physics::Fluid::new(config, weight, viscosity, Open, particles, boundary)?;
    for described in &fluid.inlets {
        filled.add_inlet(inlet(described))?;
    }
    for described in &fluid.outlets {
        filled.add_outlet(outlet(described, fluid.numerics.background_pressure))?;
    }
    Ok((filled, movers))
}
