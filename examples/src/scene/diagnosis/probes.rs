//! Probes that find nothing to measure where they are.

use super::super::bodies::drawn;
use super::super::interface_probes::{NOTHING_BEHIND, ON_THE_SURFACE, behind};
use super::super::vector;
use super::{Diagnosis, Subject};
use mps_io::scene_file::Measure;

/// What a run would refuse after everything has been built is known before.
pub(super) fn probes<const D: usize>(subject: &Subject<'_, D>, found: &mut Diagnosis) {
    let Subject { scene, source, layout, parallel } = *subject;
    for (k, probe) in scene.probes.iter().enumerate() {
        let key = format!("probes[{k}].measure");
        match &probe.measure {
            Measure::Displacement(displacement) => {
                let solids = scene.solids.iter().zip(&layout.solids);
                let on = solids.filter(|(solid, _)| solid.name == displacement.solid);
                for (solid, points) in on {
                    // A body that cannot be made has an error of its own.
                    let Ok(body) = drawn(solid, points, parallel) else { continue };
                    if body.point(vector(&displacement.at)).is_err() {
                        let what = format!(
                            "is {:?}, where {:?} has too few particles around",
                            displacement.at, solid.name
                        );
                        let remedy = "give a point in the undeformed body or on its surface";
                        let key = format!("{key}.displacement.at");
                        found.refusals.push(source.problem(&key, what, remedy));
                    }
                }
            }
            Measure::WallPressure(wall) => {
                let depth = scene.fluid.as_ref().map_or(0.0, |fluid| fluid.numerics.radius * fluid.spacing);
                let line = [&wall.from, &wall.to].map(|end| vector::<f64, 2>(end).into());
                let bodies = scene.fixed.iter().zip(&layout.fixed);
                for (_, points) in bodies.filter(|(body, _)| body.name == wall.on) {
                    let places = points.places.iter().map(|place| [place[0], place[1]]);
                    if behind(places, line, depth).is_empty() {
                        let key = format!("{key}.wall_pressure");
                        found.refusals.push(source.problem(&key, NOTHING_BEHIND, ON_THE_SURFACE));
                    }
                }
            }
            _ => {}
        }
    }
}
