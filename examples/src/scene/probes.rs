//! Probes: from their description to numbers.

use super::interface_probes::{WallPart, handed};
use super::lattice::Place;
use super::water_probes::{front, level, mean_around};
use super::{World, vector};
use crate::Failure;
use mps_io::scene_file::{LineQuantity, Measure, Probe as Description, SceneFile, Way};
use mps_kernel::{Kernel, Real, Transfer, Vector};
use mps_solid::MaterialPoint;

/// A probe in a scene that runs.
pub(super) struct Probe<T: Real> {
    name: String,
    sense: Sense<T>,
}

enum Sense<T: Real> {
    Pressure(Vec<Vector<T, 2>>),
    Velocity(Vec<Vector<T, 2>>),
    Front {
        start: [f64; 2],
        height: f64,
        sign: f64,
    },
    Level([f64; 2]),
    Displacement {
        solid: usize,
        point: MaterialPoint<T, 2>,
    },
    /// Mean force on structures since the row before, of which it keeps impulse and time.
    Force {
        bodies: Vec<usize>,
        impulse: [f64; 2],
        time: f64,
    },
    Wall(WallPart),
    /// What structures have been handed.
    Budget(Vec<usize>),
}

impl<T: Real> Probe<T> {
    /// All probes of a scene.
    ///
    /// # Errors
    /// If a point is not of its body.
    pub(super) fn all<K: Kernel<T>>(scene: &SceneFile, world: &World<T, K>) -> Result<Vec<Self>, Failure> {
        scene.probes.iter().map(|probe| Self::new(probe, scene, world)).collect()
    }

    fn new<K: Kernel<T>>(
        probe: &Description,
        scene: &SceneFile,
        world: &World<T, K>,
    ) -> Result<Self, Failure> {
        let place = |point: &[f64]| Place::from(vector::<f64>(point));
        let sense = match &probe.measure {
            Measure::Pressure(pressure) => Sense::Pressure(vec![vector(&pressure.at)]),
            Measure::Velocity(velocity) => Sense::Velocity(vec![vector(&velocity.at)]),
            Measure::Line(line) => {
                let (from, to) = (vector::<T>(&line.from), vector::<T>(&line.to));
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
                Sense::Force { bodies, impulse: [0.0; 2], time: f64::NEG_INFINITY }
            }
            Measure::WallPressure(wall) => {
                let body = structures(scene, std::slice::from_ref(&wall.on))?[0];
                Sense::Wall(WallPart::new(world, body, place(&wall.from), place(&wall.to))?)
            }
            Measure::Budget(budget) => Sense::Budget(structures(scene, &budget.on)?),
        };
        Ok(Self { name: probe.name.clone(), sense })
    }

    /// Names of its columns.
    pub(super) fn columns(&self) -> Vec<String> {
        let name = &self.name;
        let both = |name: &str, unit: &str| ["x", "y"].map(|axis| format!("{name} {axis} [{unit}]"));
        // A place alone needs no number.
        let numbered = |places: &[Vector<T, 2>]| -> Vec<String> {
            match places.len() {
                1 => vec![name.clone()],
                count => (1..=count).map(|k| format!("{name} {k}")).collect(),
            }
        };
        match &self.sense {
            Sense::Pressure(places) => numbered(places).iter().map(|name| format!("{name} [Pa]")).collect(),
            Sense::Velocity(places) => numbered(places).iter().flat_map(|name| both(name, "m/s")).collect(),
            Sense::Wall(_) => vec![format!("{name} [Pa]")],
            Sense::Front { .. } | Sense::Level(_) => vec![format!("{name} [m]")],
            Sense::Displacement { .. } => both(name, "m").into(),
            Sense::Force { .. } => both(name, "N/m").into(),
            Sense::Budget(_) => {
                let rest = [format!("{name} angular impulse [N s]"), format!("{name} work [J/m]")];
                both(&format!("{name} impulse"), "N s/m").into_iter().chain(rest).collect()
            }
        }
    }

    /// Saves or restores what it remembers of the row before.
    pub(super) fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        if let Sense::Force { bodies: _, impulse, time } = &mut self.sense {
            transfer.array("impulse", impulse);
            transfer.value("time", time);
        }
    }

    /// Appends its present values to a row.
    pub(super) fn measure<K: Kernel<T>>(&mut self, world: &World<T, K>, row: &mut Vec<f64>) {
        match &mut self.sense {
            Sense::Force { bodies, impulse, time } => {
                let since = world.time() - *time;
                let [x, y, ..] = handed(world, bodies);
                row.extend([(x - impulse[0]) / since, (y - impulse[1]) / since]);
                (*impulse, *time) = ([x, y], world.time());
            }
            Sense::Budget(bodies) => row.extend(handed(world, bodies)),
            Sense::Wall(part) => row.push(part.pressure(world)),
            Sense::Displacement { solid, point } => {
                let moved =
                    world.solid(*solid).map(|solid| point.value(solid.positions()) - point.reference());
                row.extend(moved.unwrap_or_default().iter().map(|x| x.to_double()));
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
                            places.iter().flat_map(|at| -> [f64; 2] { mean_around(at, l0, r, velocity) }),
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
