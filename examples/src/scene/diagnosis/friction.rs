//! Walls and bodies to which the fluid is to stick, and the viscosity that it sticks by.

use super::Diagnosis;
use mps_io::scene_file::{SceneFile, Slip, Source, Viscosity};

/// No slip is as much as the viscosity makes of it: nothing without one, and with the artificial one a friction that belongs to the spacing.
pub(super) fn friction<const D: usize>(scene: &SceneFile, source: &Source, found: &mut Diagnosis) {
    let Some(fluid) = &scene.fluid else { return };
    let what = match fluid.viscosity {
        Viscosity::Artificial(alpha) if alpha > 0.0 => {
            let nu = alpha * fluid.sound() * fluid.spacing / (2.0 * (D as f64 + 2.0));
            format!("drags by the artificial viscosity, here {nu:.1e} m2/s, which goes with the spacing")
        }
        Viscosity::None | Viscosity::Artificial(_) => "does nothing: the fluid has no viscosity".to_owned(),
        Viscosity::Laminar(_) | Viscosity::Compact(_) => return,
    };
    let remedy = "give `fluid.viscosity` the one of the fluid, `laminar` or `compact`, or let the fluid slip";
    let of = |name: &'static str| move |(k, slip): (usize, Slip)| (format!("{name}[{k}].slip"), slip);
    let walls = scene.walls.iter().map(|wall| wall.slip).enumerate().map(of("walls"));
    let fixed = scene.fixed.iter().map(|body| body.slip).enumerate().map(of("fixed"));
    let solids = scene.solids.iter().map(|solid| solid.slip).enumerate().map(of("solids"));
    for (key, _) in walls.chain(fixed).chain(solids).filter(|(_, slip)| *slip == Slip::None) {
        found.warnings.push(source.problem(&key, what.clone(), remedy));
    }
}
