//! Bodies whose points are farther apart than the particles of the fluid.

use super::Diagnosis;
use mps_io::scene_file::{SceneFile, Source};

/// Spacings of the fluid that the points of an elastic body may be apart. Beyond that the fluid finds its way between them.
const COARSEST: f64 = 1.5;
/// Rounding.
const SAME: f64 = 1.0 + 1e-9;

/// Walls are as fine as the fluid or finer; so have bodies to be that it may not enter.
pub(super) fn coarseness(scene: &SceneFile, source: &Source, found: &mut Diagnosis) {
    let Some(fluid) = &scene.fluid else { return };
    let l0 = fluid.spacing;
    let what = |spacing: f64| format!("is {:.2} spacings of the fluid", spacing / l0);
    let remedy = |most: f64, why: &str| format!("give at most {:e}: {why}", most * l0);
    for (k, body) in scene.fixed.iter().enumerate() {
        let spacing = body.spacing.unwrap_or(l0);
        if spacing > SAME * l0 {
            let remedy = remedy(1.0, "fluid would pass between the points");
            found.refusals.push(source.problem(&format!("fixed[{k}].spacing"), what(spacing), remedy));
        }
    }
    for (k, solid) in scene.solids.iter().enumerate() {
        let key = format!("solids[{k}].spacing");
        if solid.spacing > SAME * COARSEST * l0 {
            let remedy = remedy(COARSEST, "fluid would pass between the particles");
            found.refusals.push(source.problem(&key, what(solid.spacing), remedy));
        } else if solid.spacing > SAME * l0 {
            let remedy =
                remedy(1.0, "what is coarser feels the fluid roughly, and lets it in where it is stretched");
            found.warnings.push(source.problem(&key, what(solid.spacing), remedy));
        }
    }
}
