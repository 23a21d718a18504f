//! Probes that find nothing to measure where they are.

use super::super::FixedPoints;
use super::super::bodies::drawn;
use super::super::columns::twice;
use super::super::interface_probes::{NOTHING_BEHIND, ON_THE_SURFACE, behind};
use super::super::vector;
use super::{Diagnosis, Subject};
use mps_io::scene_file::{Fixed, Measure, Packing, Region, WallPressureProbe};

/// What a run would refuse after everything has been built is known before.
pub(super) fn probes<const D: usize>(subject: &Subject<'_, D>, found: &mut Diagnosis) {
    let Subject { scene, source, layout, parallel } = *subject;
    rows(subject, found);
    if let Some(([first, second], heading)) = twice::<D>(scene) {
        let other = &scene.probes[first].name;
        let what = format!("makes a column {heading:?}, whose plot has the name of one of {other:?}");
        let remedy = "change one: units and what spaces become do not tell them apart";
        found.refusals.push(source.problem(&format!("probes[{second}].name"), what, remedy));
    }
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
                let bodies = scene.fixed.iter().zip(&layout.fixed);
                for (body, points) in bodies.filter(|(body, _)| body.name == wall.on) {
                    if let Some((what, remedy)) = uneven(subject, wall, body, points) {
                        let key = format!("{key}.wall_pressure");
                        found.refusals.push(source.problem(&key, what, remedy));
                    }
                }
            }
            _ => {}
        }
    }
}

/// Bodies alone are stepped from row to row, in whole steps: the end of a run may be cut off and gone beyond, and its rows are the same.
fn rows<const D: usize>(Subject { scene, source, .. }: &Subject<'_, D>, found: &mut Diagnosis) {
    let ([interval, ..], end) = (scene.output.intervals(scene.end_time), scene.end_time);
    if scene.fluid.is_none() && interval > end * (1.0 + 1e-9) {
        let what =
            format!("is longer than the run of {end:e} s, and bodies alone are stepped from row to row");
        let remedy = format!("give at most {end:e}, or the run lasts as long as a row");
        found.warnings.push(source.problem("output.probe_interval", what, remedy));
    }
}

/// What is wrong with a wall that has not one point behind every spacing, and what to do.
fn uneven<const D: usize>(
    subject: &Subject<'_, D>,
    wall: &WallPressureProbe,
    body: &Fixed,
    points: &FixedPoints<D>,
) -> Option<(String, &'static str)> {
    let fluid = subject.scene.fluid.as_ref()?;
    let line = [&wall.from, &wall.to].map(|end| vector::<f64, 2>(end));
    let count = |depth: f64| {
        let places = points.places.iter().map(|place| [place[0], place[1]]);
        behind(places, line.map(Into::into), depth).len()
    };
    if count(fluid.numerics.radius * fluid.spacing) == 0 {
        return Some((NOTHING_BEHIND.to_owned(), ON_THE_SURFACE));
    }
    // The row at the surface: that of a box along the axes is complete or not, any other one follows its surface more or less.
    let along = line[1] - line[0];
    let (row, cells) = (count(0.999 * points.spacing), (along.norm() / points.spacing).round() as usize);
    let exact = body.packing == Packing::Lattice
        && matches!(body.region, Region::Box(_))
        && along.iter().any(|x| *x == 0.0);
    let good = if exact { row == cells } else { row + 1 >= cells };
    (!good).then(|| {
        let what = format!("has {row} points of its body at the surface for a length of {cells} spacings");
        (what, "let it begin and end on the surface of the body, between two points")
    })
}
