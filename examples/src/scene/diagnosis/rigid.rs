//! Walls inside each other, and fixed bodies inside of walls.

use super::super::clearance::nearest;
use super::part::{Part, overlap, words};
use super::{Diagnosis, Subject};
use crate::Failure;

/// Where two of them are, the fluid sees twice as much wall as there is, and is pushed away from it. Two fixed bodies may be joined by letting one end inside
/// the other, as a flag does in its cylinder: forces on them are told apart, so they cannot be one.
pub(super) fn rigid_apart<const D: usize>(
    subject: &Subject<'_, D>,
    found: &mut Diagnosis,
) -> Result<(), Failure> {
    let Subject { scene, source, layout, parallel } = *subject;
    let Some(fluid) = &scene.fluid else { return Ok(()) };
    let walls: Vec<_> = Part::walls(scene, layout, fluid.spacing).collect();
    let fixed: Vec<_> = Part::fixed(scene, layout).collect();
    for (k, part) in walls.iter().enumerate() {
        for other in walls[k + 1..].iter().chain(&fixed) {
            let reach = overlap::<D>() * 0.5 * (part.spacing + other.spacing);
            if let Some(near) = nearest(&part.places, &other.places, reach, parallel)? {
                let what = format!("overlaps {} ({}) near {}", other.name, other.key, words(&near.place));
                let remedy = "where both are, water is pushed away twice: let one end where the other begins";
                found.warnings.push(source.problem(&part.key, what, remedy));
            }
        }
    }
    Ok(())
}
