//! Speeds that a fluid may reach, and the sound that has to be faster.

use super::super::lattice::Place;
use super::super::{Layout, vector};
use super::Diagnosis;
use mps_io::scene_file::{InitialVelocity, Motion, Oscillation, SceneFile, Source, Steady};

/// Mach number from which the density varies by more than four percent.
const MACH: f64 = 0.2;

/// From what falls, is thrown, enters, and is pushed by walls and bodies.
pub(super) fn speeds<const D: usize>(
    scene: &SceneFile,
    source: &Source,
    layout: &Layout<D>,
    found: &mut Diagnosis,
) {
    let Some(fluid) = &scene.fluid else { return };
    let gravity = vector::<f64, D>(&scene.gravity);
    let g = gravity.norm();
    // How far fluid can fall: from its highest place to the lowest of fluid and wall surfaces.
    let height = |place: &Place<D>| if g > 0.0 { -gravity.dot(&vector(place)) / g } else { 0.0 };
    let walls = layout.walls.iter().flatten().flat_map(|points| &points.places);
    let depth = fluid.numerics.radius * fluid.spacing;
    let lowest_wall = walls.map(height).fold(f64::INFINITY, f64::min) + depth;
    let heights = || layout.fluid.iter().flatten().map(height);
    let lowest = heights().fold(f64::INFINITY, f64::min).min(lowest_wall);
    let fall = heights().fold(f64::NEG_INFINITY, f64::max) - lowest;
    let falling = (2.0 * g * fall.max(0.0)).sqrt();
    let thrown = fluid.bodies.iter().map(|body| vector::<f64, D>(&body.velocity).norm());
    let entering = fluid.inlets.iter().map(|inlet| inlet.mean_speed * inlet.profile.largest());
    let pushed = scene.walls.iter().filter_map(|wall| wall.motion.as_ref()).map(fastest::<D>);
    let flying = scene.solids.iter().filter_map(|solid| match solid.velocity.as_ref()? {
        InitialVelocity::Uniform(velocity) => Some(vector::<f64, D>(velocity).norm()),
        InitialVelocity::FirstMode(tip) => Some(tip.abs()),
    });
    let given = thrown.chain(entering).chain(pushed).chain(flying);
    let speed = given.fold(0.0, f64::max).hypot(falling);
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

/// Largest speed of a wall \[m/s\].
fn fastest<const D: usize>(motion: &Motion) -> f64 {
    match motion {
        Motion::Steady(Steady { velocity, .. }) => vector::<f64, D>(velocity).norm(),
        Motion::Oscillation(Oscillation { amplitude, period }) => {
            core::f64::consts::PI * vector::<f64, D>(amplitude).norm() / period
        }
    }
}
