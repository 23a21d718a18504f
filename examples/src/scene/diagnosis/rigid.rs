//! Walls and fixed bodies inside each other.

use super::super::clearance::nearest;
use super::part::{Part, overlap, words};
use super::{Diagnosis, Subject};
use crate::Failure;

/// Where two of them are, the fluid sees twice as much wall as there is, and is pushed away from it.
pub(super) fn rigid_apart<const D: usize>(
    subject: &Subject<'_, D>,
    found: &mut Diagnosis,
) -> Result<(), Failure> {
    let Subject { scene, source, layout, parallel } = *subject;
    let Some(fluid) = &scene.fluid else { return Ok(()) };
    let parts: Vec<_> = Part::walls(scene, layout, fluid.spacing).chain(Part::fixed(scene, layout)).collect();
    for (k, part) in parts.iter().enumerate() {
        for other in &parts[k + 1..] {
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
