//! Probes: from their description to numbers.

use super::columns::columns;
use super::interface_probes::{WallPart, handed};
use super::lattice::Place;
use super::water_probes::{front, level, mean_around};
use super::{World, vector};
use crate::Failure;
use mps_io::scene_file::{LineQuantity, Measure, Probe as Description, SceneFile, Way};
use mps_kernel::{Kernel, Real, Transfer, Vector};
use mps_solid::MaterialPoint;

/// A probe in a scene that runs.
pub(super) struct Probe<T: Real, const D: usize> {
    columns: Vec<String>,
    sense: Sense<T, D>,
}

enum Sense<T: Real, const D: usize> {
    Pressure(Vec<Vector<T, D>>),
    Velocity(Vec<Vector<T, D>>),
    Front {
        start: Place<D>,
        height: f64,
        sign: f64,
    },
    Level(Place<D>),
    Displacement {
        solid: usize,
        point: MaterialPoint<T, D>,
    },
    /// Mean force on structures since the row before, of which it keeps impulse and time.
    Force {
        bodies: Vec<usize>,
        impulse: [f64; D],
        time: f64,
    },
    Wall(WallPart),
    /// What structures have been handed.
    Budget(Vec<usize>),
}

impl<T: Real, const D: usize> Probe<T, D> {
    /// All probes of a scene.
    ///
    /// # Errors
    /// If a point is not of its body.
    pub(super) fn all<K: Kernel<T>>(scene: &SceneFile, world: &World<T, D, K>) -> Result<Vec<Self>, Failure> {
        scene.probes.iter().map(|probe| Self::new(probe, scene, world)).collect()
    }

    fn new<K: Kernel<T>>(
        probe: &Description,
        scene: &SceneFile,
        world: &World<T, D, K>,
    ) -> Result<Self, Failure> {
        let place = |point: &[f64]| Place::<D>::from(vector::<f64, D>(point));
        let sense = match &probe.measure {
            Measure::Pressure(pressure) => Sense::Pressure(vec![vector(&pressure.at)]),
            Measure::Velocity(velocity) => Sense::Velocity(vec![vector(&velocity.at)]),
            Measure::Line(line) => {
                let (from, to) = (vector::<T, D>(&line.from), vector::<T, D>(&line.to));
                let share = |k: usize| T::of(k as f64 / (line.points - 1) as f64);
                let places = (0..line.points).map(|k| from + (to - from) * share(k)).collect();
                match line.of {
                    LineQuantity::Pressure => Sense::Pressure(places),
                    LineQuantity::Velocity => Sense::Velocity(places),
                }
            }
            Measure::Level(level) => Sense::Level(place(&level.foot)),
            Measure::Front(front) => {
                let sign = if front.toward == Way::Right { 1.0 } else { -1.0 };
                Sense::Front { start: place(&front.start), height: front.height, sign }
            }
            Measure::Displacement(displacement) => {
                let named = |solid: &mps_io::scene_file::Solid| solid.name == displacement.solid;
                let number = scene.solids.iter().position(named).unwrap_or(0);
                let solid = world.solid(number).ok_or("a probe names a body that is not there")?;
                Sense::Displacement { solid: number, point: solid.point(vector(&displacement.at))? }
            }
            Measure::Force(force) => {
                let bodies = structures(scene, &force.on)?;
                Sense::Force { bodies, impulse: [0.0; D], time: f64::NEG_INFINITY }
            }
            Measure::WallPressure(wall) => {
                let body = structures(scene, std::slice::from_ref(&wall.on))?[0];
                let [from, to] = [&wall.from, &wall.to].map(|end| vector::<f64, 2>(end).into());
                Sense::Wall(WallPart::new(world, body, from, to)?)
            }
            Measure::Budget(budget) => Sense::Budget(structures(scene, &budget.on)?),
        };
        Ok(Self { columns: columns::<D>(probe), sense })
    }

    /// Headings of its columns.
    pub(super) fn columns(&self) -> &[String] {
        &self.columns
    }

    /// Saves or restores what it remembers of the row before.
    pub(super) fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        if let Sense::Force { bodies: _, impulse, time } = &mut self.sense {
            transfer.array("impulse", impulse);
            transfer.value("time", time);
        }
    }

    /// Appends its present values to a row.
    pub(super) fn measure<K: Kernel<T>>(&mut self, world: &World<T, D, K>, row: &mut Vec<f64>) {
        match &mut self.sense {
            Sense::Force { bodies, impulse, time } => {
                let since = world.time() - *time;
                let all = handed(world, bodies);
                row.extend(all.iter().zip(&*impulse).map(|(now, before)| (now - before) / since));
                impulse.iter_mut().zip(all).for_each(|(impulse, now)| *impulse = now);
                *time = world.time();
            }
            Sense::Budget(bodies) => row.extend(handed(world, bodies)),
            Sense::Wall(part) => row.push(part.pressure(world)),
            Sense::Displacement { solid, point } => {
                let moved =
                    world.solid(*solid).map(|solid| point.value(solid.positions()) - point.reference());
                row.extend(moved.unwrap_or_else(Vector::zeros).iter().map(|x| x.to_double()));
            }
            of_fluid => {
                let Some(fluid) = world.fluid() else { return };
                let particles = fluid.particles();
                let (r, l0) = (&particles.position, fluid.config().spacing.to_double());
                match of_fluid {
                    Sense::Pressure(places) => {
                        let pressure = |k: usize| [particles.pressure[k].to_double()];
                        row.extend(places.iter().flat_map(|at| mean_around(at, l0, r, pressure)));
                    }
                    Sense::Velocity(places) => {
                        let velocity = |k: usize| particles.velocity[k].map(Real::to_double).into();
                        row.extend(
                            places.iter().flat_map(|at| -> [f64; D] { mean_around(at, l0, r, velocity) }),
                        );
                    }
                    Sense::Front { start, height, sign } => row.push(front(r, l0, *start, *height, *sign)),
                    Sense::Level(foot) => row.push(level(r, l0, *foot)),
                    _ => {}
                }
            }
        }
    }
}

/// Numbers of structures with these names, in the order in which a world has them.
fn structures(scene: &SceneFile, on: &[String]) -> Result<Vec<usize>, Failure> {
    let solids = scene.solids.iter().map(|solid| &solid.name);
    let names: Vec<_> = solids.chain(scene.fixed.iter().map(|body| &body.name)).collect();
    let number = |name| names.iter().position(|known| *known == name);
    let numbers: Option<Vec<usize>> = on.iter().map(number).collect();
    Ok(numbers.ok_or("a probe names a body that is not there")?)
}
