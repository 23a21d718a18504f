//! Fluid that is inside something else, or does not reach it.

use super::super::clearance::nearest;
use super::part::{GAP, Part, overlap, words};
use super::{Diagnosis, Subject};
use crate::Failure;
use mps_io::scene_file::Filling;

/// How far a gap is looked for, over half the sum of the spacings.
const FAR: f64 = 4.0;

pub(super) fn contacts<const D: usize>(
    subject: &Subject<'_, D>,
    found: &mut Diagnosis,
) -> Result<(), Failure> {
    let Subject { scene, source, layout, parallel } = *subject;
    let Some(fluid) = &scene.fluid else { return Ok(()) };
    let l0 = fluid.spacing;
    let bodies = layout.fluid.iter().enumerate();
    let bodies: Vec<Part<D>> = bodies
        .map(|(k, places)| Part {
            key: format!("fluid.bodies[{k}].region"),
            places: places.clone(),
            spacing: l0,
            name: "another body of fluid",
            fitted: fluid.bodies[k].packing == Filling::Fitted,
        })
        .collect();
    let solids = scene.solids.iter().zip(&layout.solids).enumerate().map(|(k, (solid, points))| Part {
        key: format!("solids[{k}].region"),
        places: points.iter().map(|(place, _)| *place).collect(),
        spacing: solid.spacing,
        name: &solid.name,
        fitted: solid.packing == Filling::Fitted,
    });
    let behind = layout.behind.iter().map(|behind| Part {
        key: behind.key.clone(),
        places: behind.places.clone(),
        spacing: l0,
        name: "what lies behind an opening",
        fitted: false,
    });
    let rigid: Vec<Part<D>> = Part::walls(scene, layout, l0)
        .chain(solids)
        .chain(Part::fixed(scene, layout))
        .chain(behind)
        .collect();
    for (k, body) in bodies.iter().enumerate() {
        for other in bodies[k + 1..].iter().chain(&rigid) {
            let unit = 0.5 * (body.spacing + other.spacing);
            let Some(near) = nearest(&body.places, &other.places, FAR * unit, parallel)? else { continue };
            let place = words(&near.place);
            let (apart, name) = (near.distance, other.name);
            if apart < overlap::<D>() * unit {
                let what = format!(
                    "overlaps {name} ({}): two particles near {place} are {apart:.2e} m apart",
                    other.key
                );
                let remedy = if other.fitted && !body.fitted {
                    "take it from the fluid (difference), and give this fluid packing = \"fitted\" too: the cells of a lattice do \
                     not end half a spacing before a surface that follows no lattice"
                } else {
                    "move one of them, take one from the other (difference), give the line of a wall the other \
                     direction (fluid is on its left), or a spacing of which the lengths are multiples"
                };
                found.refusals.push(source.problem(&body.key, what, remedy));
            } else if apart > GAP * unit && !rigid.iter().any(|third| third.is_near(&near.place, l0)) {
                let gap = apart - unit;
                let what = format!("leaves a gap of {gap:.2e} m to {name} ({}) near {place}", other.key);
                let remedy = "fluid will fall through it at once: close it, or make it wider if it is meant";
                found.warnings.push(source.problem(&body.key, what, remedy));
            }
        }
    }
    Ok(())
}
