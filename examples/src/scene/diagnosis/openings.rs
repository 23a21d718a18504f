//! Inlets and outlets: what is before and behind them.

use super::super::clearance::nearest;
use super::super::lattice::Place;
use super::part::{GAP, Part, overlap, words};
use super::{Diagnosis, Subject};
use crate::Failure;
use mps_io::scene_file::{SceneFile, Source};

/// An opening has fluid on its inner side, and walls beside what lies behind it.
pub(super) fn openings<const D: usize>(
    subject: &Subject<'_, D>,
    found: &mut Diagnosis,
) -> Result<(), Failure> {
    let Subject { scene, source, layout, parallel } = *subject;
    let Some(fluid) = &scene.fluid else { return Ok(()) };
    let l0 = fluid.spacing;
    let water: Vec<Place<D>> = layout.fluid.iter().flatten().copied().collect();
    let walls: Vec<Part<D>> = Part::walls(scene, layout, l0).collect();
    for behind in &layout.behind {
        if nearest(&water, &behind.places, GAP * l0, parallel)?.is_none() {
            let remedy = "let a body of fluid begin at its plane, on the side where the fluid comes from (outlet) or goes to (inlet)";
            found.refusals.push(source.problem(&behind.key, "has no fluid before it", remedy));
        }
        for wall in &walls {
            let unit = 0.5 * (wall.spacing + l0);
            if let Some(near) = nearest(&behind.places, &wall.places, overlap::<D>() * unit, parallel)? {
                let place = words(&near.place);
                let what = format!("has a wall behind it near {place}");
                found.refusals.push(source.problem(
                    &behind.key,
                    what,
                    "leave what lies behind the plane free of walls",
                ));
            }
        }
        for end in &behind.ends {
            if !walls.iter().any(|wall| wall.is_near(end, l0)) {
                let what = format!("has no wall beside it near {}", words(end));
                let remedy =
                    format!("let the walls on both sides go on {:.3e} m behind its plane", behind.depth);
                found.warnings.push(source.problem(&behind.key, what, remedy));
            }
        }
    }
    throttles(scene, subject.source, found);
    Ok(())
}

/// Outlets that let sound out also let through no more and no less than the inlets bring.
fn throttles(scene: &SceneFile, source: &Source, found: &mut Diagnosis) {
    let Some(fluid) = &scene.fluid else { return };
    let what = match (fluid.inlets.len(), fluid.outlets.len()) {
        (0, _) => "lets hardly anything out: it is for the flow that inlets bring, and there are none",
        (_, 2..) => "shares what the inlets bring with the other outlets by area, whatever their pressures",
        _ => return,
    };
    for (k, _) in fluid.outlets.iter().enumerate().filter(|(_, outlet)| outlet.absorbing) {
        let remedy = "give `absorbing = false` where the flow is to follow from the pressures";
        found.warnings.push(source.problem(&format!("fluid.outlets[{k}].absorbing"), what, remedy));
    }
}
