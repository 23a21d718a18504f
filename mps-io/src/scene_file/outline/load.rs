//! Reads the files of a scene.

use super::super::fluid::Fluid;
use super::super::region::Region;
use super::super::scene::SceneFile;
use super::super::solids::Clamp;
use super::super::source::{Problem, Source};
use super::super::walls::Shape as WallShape;
use super::line::Fault;
use super::surface::Surface;
use super::triangle::Triangle;
use super::{Loaded, Outline, Shape, line, stl};
use mps_kernel::Vector;
use std::path::Path;
use std::sync::Arc;
use xxhash_rust::xxh3::xxh3_64;

/// All outlines of a scene with their keys.
pub(super) fn outlines(scene: &mut SceneFile) -> Vec<(String, &mut Outline)> {
    let mut found = Vec::new();
    let bodies = scene.fluid.iter_mut().flat_map(|Fluid { bodies, .. }| bodies);
    for (k, body) in bodies.enumerate() {
        collect(&mut body.region, format!("fluid.bodies[{k}].region"), &mut found);
    }
    for (k, wall) in scene.walls.iter_mut().enumerate() {
        if let WallShape::Region(region) = &mut wall.shape {
            collect(region, format!("walls[{k}].shape.region"), &mut found);
        }
    }
    for (k, solid) in scene.solids.iter_mut().enumerate() {
        collect(&mut solid.region, format!("solids[{k}].region"), &mut found);
        if let Some(Clamp::Region(region)) = &mut solid.clamp {
            collect(region, format!("solids[{k}].clamp.region"), &mut found);
        }
    }
    for (k, body) in scene.fixed.iter_mut().enumerate() {
        collect(&mut body.region, format!("fixed[{k}].region"), &mut found);
    }
    if let Some(region) = &mut scene.output.field_region {
        collect(region, "output.field_region".to_owned(), &mut found);
    }
    found
}

fn collect<'a>(region: &'a mut Region, key: String, found: &mut Vec<(String, &'a mut Outline)>) {
    let (name, parts) = match region {
        Region::Outline(outline) => return found.push((format!("{key}.outline"), outline)),
        Region::Union(parts) => ("union", parts),
        Region::Difference(parts) => ("difference", parts),
        _ => return,
    };
    for (k, part) in parts.iter_mut().enumerate() {
        collect(part, format!("{key}.{name}[{k}]"), found);
    }
}

/// Reads all files of a scene, and says what is wrong with them. Scale and dimension are checked with everything else.
pub(in super::super) fn load(scene: &mut SceneFile, source: &Source) -> Vec<Problem> {
    let (dimension, mut problems) = (scene.dimension, Vec::new());
    for (key, outline) in outlines(scene) {
        let moved = outline.translate.is_empty() || outline.translate.len() == dimension;
        if outline.scale > 0.0 && outline.scale.is_finite() && moved && [2, 3].contains(&dimension) {
            let dir = Path::new(source.name()).parent().unwrap_or(Path::new(""));
            if let Err((what, remedy)) = outline.read(dir, dimension) {
                let what = format!("{:?} {what}", outline.file);
                problems.push(source.problem(&format!("{key}.file"), what, remedy));
            }
        }
    }
    problems
}

/// The checksum of a file, as text.
pub(super) fn checksum(bytes: &[u8]) -> String {
    format!("{:016x}", xxh3_64(bytes))
}

impl Outline {
    fn read(&mut self, dir: &Path, dimension: usize) -> Result<(), Fault> {
        let path = dir.join(&self.file);
        let bytes = std::fs::read(&path).map_err(|error| {
            let what = format!("cannot be read as {}: {error}", path.display());
            (what, "give the path from the directory of the scene")
        })?;
        let sum = checksum(&bytes);
        if let Some(wanted) = self.checksum.as_ref().filter(|wanted| **wanted != sum) {
            let what = format!("has the checksum {sum}, and the scene was run with {wanted}");
            return Err((what, "bring that file back, or leave the checksum out and begin a new run"));
        }
        let shift = |axis: usize| self.translate.get(axis).copied().unwrap_or(0.0);
        let place = |axis: usize, x: f64| self.scale * x + shift(axis);
        let shape = if dimension == 2 {
            Shape::Line(line::parse(&bytes, |[x, y]| [place(0, x), place(1, y)])?)
        } else {
            let moved = |r: Vector<f64, 3>| Vector::from_fn(|axis, _| place(axis, r[axis]));
            let triangles = stl::parse(&bytes)?;
            let triangles =
                triangles.into_iter().map(|Triangle { corners }| Triangle { corners: corners.map(moved) });
            Shape::Surface(Surface::new(triangles.collect())?)
        };
        self.loaded = Some(Arc::new(Loaded { bytes, shape }));
        Ok(())
    }
}
