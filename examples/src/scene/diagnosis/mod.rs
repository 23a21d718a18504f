//! What can be seen to be wrong with a scene before it runs.

mod bodies;
mod coarseness;
mod contacts;
mod friction;
mod openings;
mod part;
mod probes;
mod rigid;
mod speeds;
mod thickness;

use super::Layout;
use super::lattice::Place;
use crate::Failure;
use bodies::bodies_apart;
use coarseness::coarseness;
use contacts::contacts;
use mps_io::scene_file::{Clamp, Problem, SceneFile, Source};
use mps_neighbors::Parallel;
use openings::openings;
use probes::probes;
use rigid::rigid_apart;
use speeds::speeds;
use thickness::thickness;

/// What was found.
#[derive(Clone, Debug, Default)]
pub struct Diagnosis {
    /// The scene cannot be run.
    pub refusals: Vec<Problem>,
    /// It can, but the result may not be what was wanted.
    pub warnings: Vec<Problem>,
    /// Largest speed over the sound speed that is to be expected, of a scene with fluid.
    pub mach: Option<f64>,
    /// Particles across the thinnest side of each body.
    pub across: Vec<f64>,
}

/// Looks for parts that overlap, gaps, parts that are too thin, and flows that are too fast.
///
/// # Errors
/// If places are not finite, which a scene that was read never has.
pub(in crate::scene) fn diagnose<const D: usize>(
    scene: &SceneFile,
    source: &Source,
    layout: &Layout<D>,
    parallel: &Parallel,
) -> Result<Diagnosis, Failure> {
    let mut found = Diagnosis::default();
    thickness(scene, source, layout, &mut found);
    coarseness(scene, source, &mut found);
    speeds(scene, source, layout, &mut found);
    clamps(scene, source, layout, &mut found);
    support(scene, source, layout, &mut found);
    let subject = Subject { scene, source, layout, parallel };
    contacts(&subject, &mut found)?;
    openings(&subject, &mut found)?;
    friction::friction::<D>(scene, source, &mut found);
    bodies_apart(&subject, &mut found)?;
    rigid_apart(&subject, &mut found)?;
    probes(&subject, &mut found);
    Ok(found)
}

/// A scene, where its keys stand in the text, and the places that were made of it.
#[derive(Clone, Copy)]
struct Subject<'a, const D: usize> {
    scene: &'a SceneFile,
    source: &'a Source,
    layout: &'a Layout<D>,
    parallel: &'a Parallel,
}

/// Number of particles of a body that are held.
fn held<const D: usize>(points: &[(Place<D>, bool)]) -> usize {
    points.iter().filter(|(_, held)| *held).count()
}

/// A region that holds nothing leaves its body as free as none, whatever pulls at it.
fn clamps<const D: usize>(scene: &SceneFile, source: &Source, layout: &Layout<D>, found: &mut Diagnosis) {
    for (k, (solid, points)) in scene.solids.iter().zip(&layout.solids).enumerate() {
        if held(points) == 0 && matches!(solid.clamp, Some(Clamp::Region(_))) {
            let remedy =
                "let the region cover the middle of at least one row of particles, or hold a side of a box";
            let key = format!("solids[{k}].clamp.region");
            found.refusals.push(source.problem(&key, "holds no particle", remedy));
        }
    }
}

/// Fluid and bodies that nothing keeps from falling out of the scene.
fn support<const D: usize>(scene: &SceneFile, source: &Source, layout: &Layout<D>, found: &mut Diagnosis) {
    if !matches!(scene.gravity.as_slice(), [0.0, down] | [0.0, down, 0.0] if *down < 0.0) {
        return;
    }
    if let Some(fluid) = &scene.fluid {
        // Columns of space along y.
        let bin = |place: &Place<D>| {
            let mut bin = place.map(|x| (x / (2.0 * fluid.spacing)).floor() as i64);
            bin[1] = 0;
            bin
        };
        let mut lowest = std::collections::BTreeMap::new();
        let walls = layout.walls.iter().flatten().flat_map(|points| &points.places);
        let solids = layout.solids.iter().flatten().map(|(place, _)| place);
        let fixed = layout.fixed.iter().flat_map(|points| &points.places);
        for place in walls.chain(solids).chain(fixed) {
            let y = place[1];
            lowest.entry(bin(place)).and_modify(|low: &mut f64| *low = low.min(y)).or_insert(y);
        }
        for (k, body) in layout.fluid.iter().enumerate() {
            let falls = |place: &&Place<D>| lowest.get(&bin(place)).is_none_or(|low| *low > place[1]);
            let count = body.iter().filter(falls).count();
            if count > 0 {
                let what = format!("has {count} of {} particles with no wall below", body.len());
                let remedy = "they will fall out of the scene: let a wall reach under them";
                found.warnings.push(source.problem(&format!("fluid.bodies[{k}].region"), what, remedy));
            }
        }
    }
    for (k, (solid, points)) in scene.solids.iter().zip(&layout.solids).enumerate() {
        let refused = matches!(solid.clamp, Some(Clamp::Region(_)));
        if held(points) == 0 && !refused && scene.fluid.is_none() {
            let remedy = "it falls: add a clamp, or leave gravity out";
            found.warnings.push(source.problem(&format!("solids[{k}]"), "is held nowhere", remedy));
        }
    }
}
