//! All points of a scene, before any physics.

use super::bodies::{BodyError, particles};
use super::fitted::fill_as;
use super::fixed::FixedPoints;
use super::lattice::{Place, fill};
use super::line::along;
use super::openings::{Behind, behind};
use mps_io::scene_file::{Problem, Region, SceneError, SceneFile, Shape, Source, Wall};
use mps_neighbors::Parallel;
use mps_neighbors::fit::FitError;

/// Points of a scene, part by part in the order of its file.
#[derive(Clone, Debug, Default)]
pub struct Layout<const D: usize> {
    /// Particles of each body of fluid \[m\].
    pub fluid: Vec<Vec<Place<D>>>,
    /// Points of each wall.
    pub walls: Vec<Vec<Points<D>>>,
    /// Particles of each elastic body \[m\], and whether each is held.
    pub solids: Vec<Vec<(Place<D>, bool)>>,
    /// Points of each fixed body.
    pub fixed: Vec<FixedPoints<D>>,
    /// What lies behind each opening, inlets first.
    pub behind: Vec<Behind<D>>,
}

/// Points of a wall that stand for the same volume each.
#[derive(Clone, Debug)]
pub struct Points<const D: usize> {
    /// Places \[m\].
    pub places: Vec<Place<D>>,
    /// Volume of a point over that of a particle of the fluid.
    pub volume: f64,
}

impl<const D: usize> Layout<D> {
    /// Fills the regions and lines of a scene.
    ///
    /// # Errors
    /// Every part that has no particles or cannot be a body, with the key of its region.
    pub fn new(scene: &SceneFile, source: &Source, parallel: &Parallel) -> Result<Self, SceneError> {
        let mut problems = Vec::new();
        let mut layout = Self::default();
        if let Some(fluid) = &scene.fluid {
            let l0 = fluid.spacing;
            for (k, body) in fluid.bodies.iter().enumerate() {
                match fill_as(body.packing, &body.region, l0, parallel) {
                    Ok((places, _)) => layout.fluid.push(places),
                    Err(error) => problems.push(not_fitted(source, &format!("fluid.bodies[{k}]"), &error)),
                }
            }
            let depth = fluid.numerics.radius * l0;
            layout.walls = scene.walls.iter().map(|wall| wall_points(wall, l0, depth)).collect();
            layout.behind = behind(fluid);
            for (k, body) in scene.fixed.iter().enumerate() {
                match FixedPoints::new(body, fluid, parallel) {
                    Ok(points) => layout.fixed.push(points),
                    Err(error) => problems.push(no_body(source, &format!("fixed[{k}]"), &error)),
                }
            }
        }
        for (k, solid) in scene.solids.iter().enumerate() {
            match particles::<f64, D>(solid, parallel) {
                Ok((particles, _)) => layout.solids.push(
                    particles
                        .reference_positions()
                        .iter()
                        .enumerate()
                        .map(|(i, x)| ((*x).into(), particles.is_clamped(i)))
                        .collect(),
                ),
                Err(error) => problems.push(no_body(source, &format!("solids[{k}]"), &error)),
            }
        }
        // A part that failed is missing, and those behind it would have its number.
        if problems.is_empty() {
            problems = layout.empty_parts(source);
        }
        if problems.is_empty() { Ok(layout) } else { Err(SceneError::Refused(problems)) }
    }

    /// Parts of the scene without a single point.
    fn empty_parts(&self, source: &Source) -> Vec<Problem> {
        let fluid = self.fluid.iter().map(Vec::len).enumerate();
        let walls = self.walls.iter().map(|wall| wall.iter().map(|p| p.places.len()).sum()).enumerate();
        let solids = self.solids.iter().map(Vec::len).enumerate();
        let fixed = self.fixed.iter().map(|body| body.places.len()).enumerate();
        let named = |what: &'static str| move |(k, count): (usize, usize)| (format!("{what}[{k}]"), count);
        let parts = fluid
            .map(named("fluid.bodies"))
            .chain(walls.map(named("walls")))
            .chain(solids.map(named("solids")))
            .chain(fixed.map(named("fixed")));
        parts
            .filter(|(_, count)| *count == 0)
            .map(|(key, _)| {
                let remedy = "it is thinner than half a spacing, or all of it is taken away: enlarge it or give a smaller spacing";
                source.problem(&key, "has no particles", remedy)
            })
            .collect()
    }

    /// Number of particles of the fluid.
    pub fn fluid_len(&self) -> usize {
        self.fluid.iter().map(Vec::len).sum()
    }

    /// Number of points of the walls.
    pub fn walls_len(&self) -> usize {
        self.walls.iter().flatten().map(|points| points.places.len()).sum()
    }

    /// Number of points of the fixed bodies.
    pub fn fixed_len(&self) -> usize {
        self.fixed.iter().map(|body| body.places.len()).sum()
    }

    /// Number of particles of the elastic bodies.
    pub fn solids_len(&self) -> usize {
        self.solids.iter().map(Vec::len).sum()
    }
}

fn no_body(source: &Source, key: &str, error: &BodyError) -> Problem {
    match error {
        BodyError::Rows(error) => {
            source.problem(&format!("{key}.spacing"), "makes no body", error.to_string())
        }
        BodyError::Fit(error) => not_fitted(source, key, error),
    }
}

fn not_fitted(source: &Source, key: &str, error: &FitError) -> Problem {
    source.problem(
        &format!("{key}.packing"),
        "cannot be \"fitted\"",
        format!("{error}, or leave packing out"),
    )
}

fn wall_points<const D: usize>(wall: &Wall, l0: f64, depth: f64) -> Vec<Points<D>> {
    let spacing = wall.fineness * l0;
    let lattice = |region: &Region| {
        vec![Points { places: fill(region, spacing), volume: wall.fineness.powi(D as i32) }]
    };
    let (line, closed) = match &wall.shape {
        Shape::Region(region) => return lattice(region),
        Shape::Tank(tank) => {
            // Whole cells, so that the lattice begins at the lower corner of the inside.
            let depth = (depth / spacing - 1e-6).ceil() * spacing;
            return lattice(&Region::Difference(vec![
                Region::Box(tank.outside(depth)),
                // The points of the walls that stand on the rim of an opening are not inside.
                Region::Box(tank.inside()),
            ]));
        }
        Shape::Line(line) => (line, false),
        Shape::Ring(line) => (line, true),
    };
    let corners: Vec<Place<2>> = line.iter().map(|point| super::vector::<f64, 2>(point).into()).collect();
    along(&corners, closed, spacing, depth)
        .into_iter()
        .map(|side| Points {
            places: side.points.iter().map(|place| super::vector::<f64, D>(place).into()).collect(),
            volume: side.area / (l0 * l0),
        })
        .collect()
}
