//! Bodies inside each other.

use super::super::clearance::nearest;
use super::super::lattice::Place;
use super::part::{overlap, words};
use super::{Diagnosis, Subject};
use crate::Failure;

/// Bodies know nothing of each other: they would pass through one another.
pub(super) fn bodies_apart<const D: usize>(
    subject: &Subject<'_, D>,
    found: &mut Diagnosis,
) -> Result<(), Failure> {
    let Subject { scene, source, layout, parallel } = *subject;
    let bodies: Vec<_> = scene.solids.iter().zip(&layout.solids).enumerate().collect();
    let places = |points: &[(Place<D>, bool)]| points.iter().map(|(place, _)| *place).collect::<Vec<_>>();
    for (k, (solid, points)) in &bodies {
        for (other, other_points) in bodies[k + 1..].iter().map(|(_, body)| body) {
            let reach = overlap::<D>() * 0.5 * (solid.spacing + other.spacing);
            if let Some(near) = nearest(&places(points), &places(other_points), reach, parallel)? {
                let place = words(&near.place);
                let what = format!("overlaps the body {} near {place}", other.name);
                let remedy = "move one of them, or make one body of both (union)";
                found.refusals.push(source.problem(&format!("solids[{k}].region"), what, remedy));
            }
        }
    }
    // What is held may be held in a fixed body; what moves would pass through it.
    for (k, (solid, points)) in &bodies {
        let moving: Vec<Place<D>> =
            points.iter().filter(|(_, held)| !held).map(|(place, _)| *place).collect();
        for (other, fixed) in scene.fixed.iter().zip(&layout.fixed) {
            let reach = overlap::<D>() * 0.5 * (solid.spacing + fixed.spacing);
            if let Some(near) = nearest(&moving, &fixed.places, reach, parallel)? {
                let place = words(&near.place);
                let what = format!("overlaps the fixed body {} near {place}", other.name);
                let remedy = "move one of them: only particles that are held may be in a fixed body";
                found.refusals.push(source.problem(&format!("solids[{k}].region"), what, remedy));
            }
        }
    }
    Ok(())
}
