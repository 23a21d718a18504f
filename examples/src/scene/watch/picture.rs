//! The place of a failure.

use super::super::World;
use super::super::slice::{Slice, pick};
use super::particle::Particle;
use crate::Failure;
use mps_io::{ColorMap, FieldPicture, View};
use mps_kernel::{Kernel, Real, Vector};
use std::path::Path;

/// Width of the picture \[pixels\].
const WIDTH: u32 = 900;
/// What is shown on each side of the particle, in spacings.
const AROUND: f64 = 12.0;
const WALL: [u8; 3] = [150, 150, 150];
const BODY: [u8; 3] = [90, 70, 60];
const MARK: [u8; 3] = [230, 30, 30];

/// Where a particle is \[m\] and the spacing there; `None` if it is not there, or nowhere.
pub(super) fn place<T: Real, const D: usize, K: Kernel<T>>(
    world: &World<T, D, K>,
    particle: Particle,
) -> Option<(Vector<T, D>, f64)> {
    let (r, spacing) = match particle {
        Particle::Fluid(id) => {
            let fluid = world.fluid()?;
            let i = fluid.particles().id.iter().position(|other| *other == id)?;
            (fluid.particles().position[i], fluid.config().spacing)
        }
        Particle::Solid { body, id } => {
            let solid = world.solid(body)?;
            let i = solid.particles().ids().iter().position(|other| *other == id)?;
            (solid.positions()[i], solid.spacing().max())
        }
    };
    r.iter().all(|x| x.is_finite()).then(|| (r, spacing.to_double()))
}

/// Draws the surroundings of a particle: the fluid by its speed, walls, bodies, and the particle red.
pub(super) fn draw<T: Real, const D: usize, K: Kernel<T>>(
    world: &World<T, D, K>,
    (center, spacing): (Vector<T, D>, f64),
    title: &str,
    path: &Path,
) -> Result<(), Failure> {
    let middle = [center[0].to_double(), center[1].to_double()];
    let reach = AROUND * spacing;
    let view = View::new(middle.map(|x| x - reach), middle.map(|x| x + reach));
    let mut drawn = FieldPicture::new(WIDTH, view).title(title).time(world.time());
    let slice = Slice { z: center.get(2).map_or(0.0, |z| z.to_double()) };
    let shown = |positions: &[Vector<T, D>], spacing: T| slice.of(positions, spacing.to_double());
    if let Some(fluid) = world.fluid() {
        let (boundary, particles) = (fluid.boundary(), fluid.particles());
        let radius = 0.5 * fluid.config().spacing.to_double();
        let speed: Vec<T> = particles.velocity.iter().map(|u| u.norm()).collect();
        let near = |r: &Vector<T, D>| (r - center).amax().to_double() < reach;
        let seen = particles.position.iter().zip(&speed).filter(|(r, _)| near(r));
        let fastest = seen.map(|(_, speed)| speed.to_double()).filter(|v| v.is_finite()).fold(0.0, f64::max);
        let (walls, spacing) = (&boundary.position[..boundary.reactive().start], fluid.config().spacing);
        let water = shown(&particles.position, spacing);
        drawn = drawn.plain(&pick(walls, &shown(walls, spacing)), radius, WALL).layer(
            &pick(&particles.position, &water),
            radius,
            &pick(&speed, &water),
            (0.0, fastest),
            ColorMap::Viridis,
            "fluid: speed [m/s]",
        );
    }
    let solids = (0..).map_while(|k| world.solid(k)).map(|body| (body.positions(), body.spacing().max()));
    for (positions, spacing) in solids.chain(world.fixed().map(|body| (body.positions(), body.spacing()))) {
        drawn = drawn.plain(&pick(positions, &shown(positions, spacing)), 0.5 * spacing.to_double(), BODY);
    }
    Ok(drawn.plain(&[center], 0.3 * spacing, MARK).render()?.write_png(path)?)
}
