//! Probes: from their description to numbers.

use super::{World, vector};
use crate::{Failure, GAP, connected};
use mps_io::scene_file::{Measure, Probe as Description, SceneFile, Way};
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Kernel, Real, Transfer, Vector};
use mps_solid::MaterialPoint;

/// How far around a place the pressure is taken from, in spacings.
const REACH: f64 = 2.0;

/// A probe in a scene that runs.
pub(super) struct Probe<T: Real> {
    name: String,
    sense: Sense<T>,
}

enum Sense<T: Real> {
    Pressure(Vector<T, 2>),
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
        let place = |point: &[f64]| <[f64; 2]>::from(vector::<f64>(point));
        let sense = match &probe.measure {
            Measure::Pressure(pressure) => Sense::Pressure(vector(&pressure.at)),
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
                // The order in which a world has its structures.
                let solids = scene.solids.iter().map(|solid| &solid.name);
                let names: Vec<_> = solids.chain(scene.fixed.iter().map(|body| &body.name)).collect();
                let number = |name| names.iter().position(|known| *known == name);
                let bodies: Option<Vec<usize>> = force.on.iter().map(number).collect();
                let bodies = bodies.ok_or("a probe names a body that is not there")?;
                Sense::Force { bodies, impulse: [0.0; 2], time: f64::NEG_INFINITY }
            }
        };
        Ok(Self { name: probe.name.clone(), sense })
    }

    /// Names of its columns.
    pub(super) fn columns(&self) -> Vec<String> {
        let name = &self.name;
        match self.sense {
            Sense::Pressure(_) => vec![format!("{name} [Pa]")],
            Sense::Front { .. } | Sense::Level(_) => vec![format!("{name} [m]")],
            Sense::Displacement { .. } => vec![format!("{name} x [m]"), format!("{name} y [m]")],
            Sense::Force { .. } => vec![format!("{name} x [N/m]"), format!("{name} y [N/m]")],
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
        if let Sense::Force { bodies, impulse, time } = &mut self.sense {
            let since = world.time() - *time;
            let all = bodies.iter().filter_map(|body| world.coupled()?.budget().handed.get(*body));
            let sum = all.fold(Vector::zeros(), |sum, handed| sum + handed.push.force.map(Real::to_double));
            let now: [f64; 2] = sum.into();
            row.extend([0, 1].map(|axis| (now[axis] - impulse[axis]) / since));
            (*impulse, *time) = (now, world.time());
            return;
        }
        if let Sense::Displacement { solid, point } = &self.sense {
            let moved = world.solid(*solid).map(|solid| point.value(solid.positions()) - point.reference());
            row.extend(moved.unwrap_or_default().iter().map(|x| x.to_double()));
            return;
        }
        let Some(fluid) = world.fluid() else { return };
        let (positions, l0) = (&fluid.particles().position, fluid.config().spacing.to_double());
        row.push(match &self.sense {
            Sense::Pressure(at) => mean_around(at, l0, positions, &fluid.particles().pressure),
            Sense::Front { start, height, sign } => front(positions, l0, *start, *height, *sign),
            Sense::Level(foot) => level(positions, l0, *foot),
            Sense::Displacement { .. } | Sense::Force { .. } => 0.0,
        });
    }
}

/// Mean of the values around a place, weighted by nearness; zero where there are none.
fn mean_around<T: Real>(at: &Vector<T, 2>, l0: f64, positions: &[Vector<T, 2>], values: &[T]) -> f64 {
    let reach = REACH * l0;
    let (mut sum, mut weights) = (0.0, 0.0);
    for (r, value) in positions.iter().zip(values) {
        let distance = (r - at).norm().to_double();
        if distance < reach {
            let weight = WendlandC2.weight(distance.max(1e-6 * l0), reach);
            sum += weight * value.to_double();
            weights += weight;
        }
    }
    if weights > 0.0 { sum / weights } else { 0.0 }
}

fn front<T: Real>(positions: &[Vector<T, 2>], l0: f64, start: [f64; 2], height: f64, sign: f64) -> f64 {
    let low = positions.iter().filter(|r| {
        let y = r[1].to_double() - start[1];
        y < height && y > -l0
    });
    let ahead = low.map(|r| sign * (r[0].to_double() - start[0]));
    connected(ahead.filter(|x| *x > -GAP * l0).collect(), -0.5 * l0, l0)
}

fn level<T: Real>(positions: &[Vector<T, 2>], l0: f64, foot: [f64; 2]) -> f64 {
    let near = positions.iter().filter(|r| (r[0].to_double() - foot[0]).abs() < 2.0 * l0);
    let above = near.map(|r| r[1].to_double() - foot[1]);
    connected(above.filter(|y| *y > -l0).collect(), -0.5 * l0, l0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn front_level_and_pressure_of_a_block_of_water_with_spray() {
        let l0 = 0.01;
        let mut water: Vec<Vector<f64, 2>> = (0..140 * 30)
            .map(|k| Vector::from([(0.5 + f64::from(k % 140)) * l0, (0.5 + f64::from(k / 140)) * l0]))
            .collect();
        water.push(Vector::from([1.5, 0.02]));
        water.push(Vector::from([0.6, 0.4]));
        assert!((front(&water, l0, [1.2, 0.0], 0.06, 1.0) - 0.2).abs() < 1e-9);
        assert!((front(&water, l0, [0.3, 0.0], 0.06, -1.0) - 0.3).abs() < 1e-9);
        assert!((level(&water, l0, [0.6, 0.0]) - 0.3).abs() < 1e-9);
        assert!(level(&water, l0, [1.6, 0.0]).abs() < 1e-9, "dry");
        let pressure: Vec<f64> = water.iter().map(|r| 7.0 - r.y).collect();
        assert!((mean_around(&Vector::from([0.5, 0.1]), l0, &water, &pressure) - 6.9).abs() < 1e-9);
        assert_eq!(mean_around(&Vector::from([3.0, 0.1]), l0, &water, &pressure), 0.0);
    }
}
