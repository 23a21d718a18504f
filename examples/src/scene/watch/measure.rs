//! What is looked at after every step, in one visit of all particles.

use super::super::World;
use super::particle::Particle;
use mps_io::scene_file::Corners;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::Parallel;

/// What the particles of a state are like.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measures {
    /// Kinetic energy of fluid and bodies \[J, in two dimensions J/m\].
    pub(super) kinetic: f64,
    /// The fastest particle and its speed \[m/s\].
    pub(super) fastest: (Particle, f64),
    /// The fluid particle with the largest pressure, and that \[Pa\].
    pub(super) pressure: (u32, f64),
    /// The fastest particle of the fluid, and its speed over that of sound \[-\].
    pub(super) mach: (Particle, f64),
    /// The first particle with a value that is no number.
    pub(super) broken: Option<Particle>,
    /// The first particle outside the region of the scene.
    pub(super) outside: Option<Particle>,
}

/// Nobody.
const NONE: u32 = u32::MAX;

/// What one fluid particle adds, or several together; particles by their places in the arrays.
#[derive(Clone, Copy)]
struct Part<T> {
    square: T,
    fastest: (T, u32),
    pressure: (T, u32),
    broken: u32,
    outside: u32,
}

impl<T: Real> Part<T> {
    fn nothing() -> Self {
        let least = (-T::of(f64::INFINITY), NONE);
        Self { square: T::zero(), fastest: least, pressure: least, broken: NONE, outside: NONE }
    }

    fn with(self, other: Self) -> Self {
        let larger = |a: (T, u32), b: (T, u32)| if b.0 > a.0 { b } else { a };
        Self {
            square: self.square + other.square,
            fastest: larger(self.fastest, other.fastest),
            pressure: larger(self.pressure, other.pressure),
            broken: self.broken.min(other.broken),
            outside: self.outside.min(other.outside),
        }
    }
}

/// Whether a place lies in the region, if there is one.
fn is_inside<T: Real, const D: usize>(region: Option<&Corners>, r: &Vector<T, D>) -> bool {
    region.is_none_or(|Corners { lower, upper }| {
        r.iter().zip(lower.iter().zip(upper)).all(|(x, (low, high))| {
            let x = x.to_double();
            x >= *low && x <= *high
        })
    })
}

impl Measures {
    pub(super) fn of<T: Real, const D: usize, K: Kernel<T>>(
        world: &World<T, D, K>,
        region: Option<&Corners>,
        parallel: &Parallel,
    ) -> Self {
        let mut found = Self::of_fluid(world, region, parallel);
        for body in 0.. {
            let Some(solid) = world.solid(body) else { break };
            let particles = solid.particles();
            for (i, (r, u)) in particles.positions().iter().zip(particles.velocities()).enumerate() {
                let (speed, particle) =
                    (u.norm().to_double(), Particle::Solid { body, id: particles.ids()[i] });
                found.kinetic += 0.5 * particles.masses()[i].to_double() * speed * speed;
                if speed > found.fastest.1 {
                    found.fastest = (particle, speed);
                }
                if !(speed.is_finite() && r.iter().all(|x| x.is_finite())) {
                    found.broken.get_or_insert(particle);
                } else if !is_inside(region, r) {
                    found.outside.get_or_insert(particle);
                }
            }
        }
        found
    }

    fn of_fluid<T: Real, const D: usize, K: Kernel<T>>(
        world: &World<T, D, K>,
        region: Option<&Corners>,
        parallel: &Parallel,
    ) -> Self {
        let Some(fluid) = world.fluid() else {
            return Self::from_parts(&Part::<T>::nothing(), &[], 0.0, 1.0);
        };
        let particles = fluid.particles();
        let one = |i: usize| {
            let (r, square) = (&particles.position[i], particles.velocity[i].norm_squared());
            let (n, p, place) = (particles.density[i], particles.pressure[i], i as u32);
            let good =
                square.is_finite() && n.is_finite() && p.is_finite() && r.iter().all(|x| x.is_finite());
            Part {
                square,
                fastest: (square, place),
                pressure: (p, place),
                broken: if good { NONE } else { place },
                outside: if is_inside(region, r) { NONE } else { place },
            }
        };
        let sum = parallel.fold(particles.id.len(), Part::nothing(), &one, &Part::with);
        let config = fluid.config();
        let (mass, sound) = (config.particle_mass().to_double(), config.sound_speed.to_double());
        Self::from_parts(&sum, &particles.id, mass, sound)
    }

    fn from_parts<T: Real>(part: &Part<T>, id: &[u32], mass: f64, sound: f64) -> Self {
        let number = |place: u32| id.get(place as usize).copied();
        let particle = |place: u32| number(place).map(Particle::Fluid);
        let (fastest, pressure) = (part.fastest, part.pressure);
        let swift = particle(fastest.1).unwrap_or(Particle::Fluid(0));
        let speed = particle(fastest.1).map_or(0.0, |_| fastest.0.to_double().sqrt());
        Self {
            kinetic: 0.5 * mass * part.square.to_double(),
            fastest: (swift, speed),
            mach: (swift, speed / sound),
            pressure: (
                number(pressure.1).unwrap_or(0),
                number(pressure.1).map_or(0.0, |_| pressure.0.to_double()),
            ),
            broken: particle(part.broken),
            outside: particle(part.outside),
        }
    }
}
