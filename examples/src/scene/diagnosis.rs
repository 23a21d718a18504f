//! What can be seen to be wrong with a scene before it runs.

use super::Layout;
use super::clearance::nearest;
use super::lattice::Place;
use crate::Failure;
use mps_io::scene_file::{Clamp, Corners, Problem, Region, SceneFile, Shape, Source};
use mps_neighbors::Parallel;

/// Points of two parts in contact are half the sum of their spacings apart. Less than this share of it, and one is
/// inside the other: a square lattice leaves no place that is farther from its points than 0.71 of its spacing.
const OVERLAP: f64 = 0.72;
/// More than this multiple, and there is a gap; rounding to whole cells makes up to 1.5.
const GAP: f64 = 1.55;
/// How far a gap is looked for, in the same unit.
const FAR: f64 = 4.0;
/// Mach number from which the density varies by more than four percent.
const MACH: f64 = 0.2;
/// Particles across a body that give its bending stiffness to some percent.
const ACROSS: f64 = 3.5;
/// Something thinner than this many spacings of the fluid does not part the fluid on its two sides.
const THIN: f64 = 2.0;

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
pub fn diagnose(
    scene: &SceneFile,
    source: &Source,
    layout: &Layout,
    parallel: &Parallel,
) -> Result<Diagnosis, Failure> {
    let mut found = Diagnosis::default();
    thickness(scene, source, &mut found);
    speeds(scene, source, layout, &mut found);
    support(scene, source, layout, &mut found);
    contacts(scene, source, layout, parallel, &mut found)?;
    openings(scene, source, layout, parallel, &mut found)?;
    bodies_apart(scene, source, layout, parallel, &mut found)?;
    Ok(found)
}

/// A part of the scene with its key, points and spacing.
struct Part<'a> {
    key: String,
    places: Vec<Place>,
    spacing: f64,
    name: &'a str,
}

impl Part<'_> {
    /// Whether it touches fluid at this place.
    fn is_near(&self, [x, y]: Place, l0: f64) -> bool {
        let reach = GAP * 0.5 * (self.spacing + l0);
        self.places.iter().any(|[a, b]| (a - x).hypot(b - y) < reach)
    }
}

fn contacts(
    scene: &SceneFile,
    source: &Source,
    layout: &Layout,
    parallel: &Parallel,
    found: &mut Diagnosis,
) -> Result<(), Failure> {
    let Some(fluid) = &scene.fluid else { return Ok(()) };
    let l0 = fluid.spacing;
    let bodies = layout.fluid.iter().enumerate();
    let bodies: Vec<Part> = bodies
        .map(|(k, places)| Part {
            key: format!("fluid.bodies[{k}].region"),
            places: places.clone(),
            spacing: l0,
            name: "another body of fluid",
        })
        .collect();
    let walls = scene.walls.iter().zip(&layout.walls).enumerate().map(|(k, (wall, points))| Part {
        key: format!("walls[{k}].shape"),
        places: points.iter().flat_map(|part| part.places.iter().copied()).collect(),
        spacing: wall.fineness * l0,
        name: &wall.name,
    });
    let solids = scene.solids.iter().zip(&layout.solids).enumerate().map(|(k, (solid, points))| Part {
        key: format!("solids[{k}].region"),
        places: points.iter().map(|(place, _)| *place).collect(),
        spacing: solid.spacing,
        name: &solid.name,
    });
    let fixed = scene.fixed.iter().zip(&layout.fixed).enumerate().map(|(k, (body, points))| Part {
        key: format!("fixed[{k}].region"),
        places: points.places.clone(),
        spacing: points.spacing,
        name: &body.name,
    });
    let behind = layout.behind.iter().map(|behind| Part {
        key: behind.key.clone(),
        places: behind.places.clone(),
        spacing: l0,
        name: "what lies behind an opening",
    });
    let rigid: Vec<Part> = walls.chain(solids).chain(fixed).chain(behind).collect();
    for (k, body) in bodies.iter().enumerate() {
        for other in bodies[k + 1..].iter().chain(&rigid) {
            let unit = 0.5 * (body.spacing + other.spacing);
            let Some(near) = nearest(&body.places, &other.places, FAR * unit, parallel)? else { continue };
            let [x, y] = near.place;
            let (apart, name) = (near.distance, other.name);
            if apart < OVERLAP * unit {
                let what = format!(
                    "overlaps {name} ({}): two particles near ({x:.4}, {y:.4}) are {apart:.2e} m apart",
                    other.key
                );
                let remedy = "move one of them, take one from the other (difference), give the line of a wall the other \
                              direction (fluid is on its left), or a spacing of which the lengths are multiples";
                found.refusals.push(source.problem(&body.key, what, remedy));
            } else if apart > GAP * unit && !rigid.iter().any(|third| third.is_near(near.place, l0)) {
                let gap = apart - unit;
                let what =
                    format!("leaves a gap of {gap:.2e} m to {name} ({}) near ({x:.4}, {y:.4})", other.key);
                let remedy = "fluid will fall through it at once: close it, or make it wider if it is meant";
                found.warnings.push(source.problem(&body.key, what, remedy));
            }
        }
    }
    Ok(())
}

/// An opening has fluid on its inner side, and walls beside what lies behind it.
fn openings(
    scene: &SceneFile,
    source: &Source,
    layout: &Layout,
    parallel: &Parallel,
    found: &mut Diagnosis,
) -> Result<(), Failure> {
    let Some(fluid) = &scene.fluid else { return Ok(()) };
    let l0 = fluid.spacing;
    let water: Vec<Place> = layout.fluid.iter().flatten().copied().collect();
    let points = || {
        layout
            .walls
            .iter()
            .zip(&scene.walls)
            .flat_map(|(parts, wall)| parts.iter().map(|part| (part, wall.fineness * l0)))
    };
    for behind in &layout.behind {
        if nearest(&water, &behind.places, GAP * l0, parallel)?.is_none() {
            let remedy = "let a body of fluid begin at its plane, on the side where the fluid comes from (outlet) or goes to (inlet)";
            found.refusals.push(source.problem(&behind.key, "has no fluid before it", remedy));
        }
        for (part, spacing) in points() {
            let unit = 0.5 * (spacing + l0);
            if let Some(near) = nearest(&behind.places, &part.places, OVERLAP * unit, parallel)? {
                let [x, y] = near.place;
                let what = format!("has a wall behind it near ({x:.4}, {y:.4})");
                found.refusals.push(source.problem(
                    &behind.key,
                    what,
                    "leave what lies behind the plane free of walls",
                ));
            }
        }
        for [x, y] in behind.ends {
            let beside = points().any(|(part, spacing)| {
                let reach = GAP * 0.5 * (spacing + l0);
                part.places.iter().any(|[a, b]| (a - x).hypot(b - y) < reach)
            });
            if !beside {
                let what = format!("has no wall beside it near ({x:.4}, {y:.4})");
                let remedy =
                    format!("let the walls on both sides go on {:.3e} m behind its plane", behind.depth);
                found.warnings.push(source.problem(&behind.key, what, remedy));
            }
        }
    }
    Ok(())
}

/// Bodies know nothing of each other: they would pass through one another.
fn bodies_apart(
    scene: &SceneFile,
    source: &Source,
    layout: &Layout,
    parallel: &Parallel,
    found: &mut Diagnosis,
) -> Result<(), Failure> {
    let bodies: Vec<_> = scene.solids.iter().zip(&layout.solids).enumerate().collect();
    let places = |points: &[(Place, bool)]| points.iter().map(|(place, _)| *place).collect::<Vec<_>>();
    for (k, (solid, points)) in &bodies {
        for (other, other_points) in bodies[k + 1..].iter().map(|(_, body)| body) {
            let reach = OVERLAP * 0.5 * (solid.spacing + other.spacing);
            if let Some(near) = nearest(&places(points), &places(other_points), reach, parallel)? {
                let [x, y] = near.place;
                let what = format!("overlaps the body {} near ({x:.4}, {y:.4})", other.name);
                let remedy = "move one of them, or make one body of both (union)";
                found.refusals.push(source.problem(&format!("solids[{k}].region"), what, remedy));
            }
        }
    }
    // What is held may be held in a fixed body; what moves would pass through it.
    for (k, (solid, points)) in &bodies {
        let moving: Vec<Place> = points.iter().filter(|(_, held)| !held).map(|(place, _)| *place).collect();
        for (other, fixed) in scene.fixed.iter().zip(&layout.fixed) {
            let reach = OVERLAP * 0.5 * (solid.spacing + fixed.spacing);
            if let Some(near) = nearest(&moving, &fixed.places, reach, parallel)? {
                let [x, y] = near.place;
                let what = format!("overlaps the fixed body {} near ({x:.4}, {y:.4})", other.name);
                let remedy = "move one of them: only particles that are held may be in a fixed body";
                found.refusals.push(source.problem(&format!("solids[{k}].region"), what, remedy));
            }
        }
    }
    Ok(())
}

/// Length of the shortest side of the box around a region \[m\].
fn thinnest(region: &Region) -> f64 {
    let Some(Corners { lower, upper }) = region.bounds() else { return 0.0 };
    lower.iter().zip(&upper).map(|(low, high)| high - low).fold(f64::INFINITY, f64::min)
}

fn thickness(scene: &SceneFile, source: &Source, found: &mut Diagnosis) {
    let l0 = scene.fluid.as_ref().map_or(0.0, |fluid| fluid.spacing);
    let mut parting = |thin: f64, key: &str| {
        if thin < THIN * l0 * (1.0 - 1e-9) {
            let what = format!("is {:.2} particles of the fluid thick and needs at least {THIN}", thin / l0);
            let remedy = format!("make it thicker, or give fluid.spacing at most {:.3e}", thin / THIN);
            found.refusals.push(source.problem(key, what, remedy));
        }
    };
    for (k, wall) in scene.walls.iter().enumerate() {
        if let Shape::Region(region) = &wall.shape {
            parting(thinnest(region), &format!("walls[{k}].shape.region"));
        }
    }
    for (k, solid) in scene.solids.iter().enumerate() {
        parting(thinnest(&solid.region), &format!("solids[{k}].region"));
    }
    for (k, body) in scene.fixed.iter().enumerate() {
        parting(thinnest(&body.region), &format!("fixed[{k}].region"));
    }
    for (k, solid) in scene.solids.iter().enumerate() {
        let across = thinnest(&solid.region) / solid.spacing;
        found.across.push(across);
        if across < ACROSS {
            let what = format!("makes {across:.1} particles across the thinnest side");
            let remedy = format!(
                "give at most {:.3e}: 4 across are usual, 8 for errors below a percent",
                solid.spacing * across / 4.0
            );
            found.warnings.push(source.problem(&format!("solids[{k}].spacing"), what, remedy));
        }
    }
}

fn speeds(scene: &SceneFile, source: &Source, layout: &Layout, found: &mut Diagnosis) {
    let Some(fluid) = &scene.fluid else { return };
    let gravity = super::vector::<f64>(&scene.gravity);
    let g = gravity.norm();
    // How far fluid can fall: from its highest place to the lowest of fluid and wall surfaces.
    let height = |place: &Place| if g > 0.0 { -gravity.dot(&super::vector(place)) / g } else { 0.0 };
    let walls = layout.walls.iter().flatten().flat_map(|points| &points.places);
    let depth = fluid.numerics.radius * fluid.spacing;
    let lowest_wall = walls.map(height).fold(f64::INFINITY, f64::min) + depth;
    let heights = || layout.fluid.iter().flatten().map(height);
    let lowest = heights().fold(f64::INFINITY, f64::min).min(lowest_wall);
    let fall = heights().fold(f64::NEG_INFINITY, f64::max) - lowest;
    let falling = (2.0 * g * fall.max(0.0)).sqrt();
    let thrown = fluid.bodies.iter().map(|body| super::vector::<f64>(&body.velocity).norm());
    let entering = fluid.inlets.iter().map(|inlet| inlet.mean_speed * inlet.profile.largest());
    let speed = thrown.chain(entering).fold(0.0, f64::max).hypot(falling);
    let (sound, mach) = (fluid.sound(), speed / fluid.sound());
    found.mach = Some(mach);
    let key = if fluid.sound_speed.is_some() { "fluid.sound_speed" } else { "fluid.expected_speed" };
    let what = format!(
        "makes the sound {sound:.3} m/s fast, and fluid may reach {speed:.3} m/s: Mach {mach:.2}, \
         the density would vary by {:.0} %",
        100.0 * mach * mach
    );
    let remedy = if fluid.sound_speed.is_some() {
        format!("give about {:.3}", 10.0 * speed)
    } else {
        format!("give about {speed:.3}")
    };
    if mach > 1.0 {
        found.refusals.push(source.problem(key, what, remedy));
    } else if mach > MACH {
        found.warnings.push(source.problem(key, what, remedy));
    }
}

/// Fluid and bodies that nothing keeps from falling out of the scene.
fn support(scene: &SceneFile, source: &Source, layout: &Layout, found: &mut Diagnosis) {
    let &[across, down] = scene.gravity.as_slice() else { return };
    if across != 0.0 || down >= 0.0 {
        return;
    }
    if let Some(fluid) = &scene.fluid {
        let bin = |x: f64| (x / (2.0 * fluid.spacing)).floor() as i64;
        let mut lowest = std::collections::BTreeMap::new();
        let walls = layout.walls.iter().flatten().flat_map(|points| &points.places);
        let solids = layout.solids.iter().flatten().map(|(place, _)| place);
        let fixed = layout.fixed.iter().flat_map(|points| &points.places);
        for [x, y] in walls.chain(solids).chain(fixed) {
            lowest.entry(bin(*x)).and_modify(|low: &mut f64| *low = low.min(*y)).or_insert(*y);
        }
        for (k, body) in layout.fluid.iter().enumerate() {
            let falls = |place: &&Place| lowest.get(&bin(place[0])).is_none_or(|low| *low > place[1]);
            let count = body.iter().filter(falls).count();
            if count > 0 {
                let what = format!("has {count} of {} particles with no wall below", body.len());
                let remedy = "they will fall out of the scene: let a wall reach under them";
                found.warnings.push(source.problem(&format!("fluid.bodies[{k}].region"), what, remedy));
            }
        }
    }
    for (k, (solid, points)) in scene.solids.iter().zip(&layout.solids).enumerate() {
        let held = points.iter().filter(|(_, held)| *held).count();
        let key = format!("solids[{k}]");
        if held == 0 && matches!(solid.clamp, Some(Clamp::Region(_))) {
            let remedy =
                "let the region cover the middle of at least one row of particles, or hold a side of a box";
            found.refusals.push(source.problem(&format!("{key}.clamp.region"), "holds no particle", remedy));
        } else if held == 0 && scene.fluid.is_none() {
            found.warnings.push(source.problem(
                &key,
                "is held nowhere",
                "it falls: add a clamp, or leave gravity out",
            ));
        }
    }
}
