//! Mistakes in scenes of three dimensions, what exists in two only, and what the program says to each.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{fresh, words};
use std::process::Command;

const DAM: &str = include_str!("../scenes/dam-break-3d.toml");
const BEAM: &str = include_str!("../scenes/cantilever-3d.toml");
const POST: &str = "{ cylinder = { from = [0.21, 0.0, 0.05], to = [0.21, 0.2, 0.05], radius = 0.02 } }";
const FRONT: &str = "{ front = { start = [0.1, 0.0, 0.05], height = 0.03 } }";

/// A name, the scene, what is changed in it, and what is said.
type Mistake = (&'static str, &'static str, &'static str, &'static str, &'static str);

const MISTAKES: &[Mistake] = &[
    ("dimensions", DAM, "dimension = 3", "dimension = 4", "scene.toml:3:13: dimension is 4: give 2 or 3"),
    (
        "points of two dimensions",
        DAM,
        "gravity = [0.0, -9.81, 0.0]",
        "gravity = [0.0, -9.81]",
        "scene.toml:5:11: gravity has 2 of 3 numbers: give one number per dimension",
    ),
    (
        "rings",
        DAM,
        "radius = 0.02 } }",
        "radius = 0.02 } }\npacking = \"rings\"",
        "scene.toml:23:11: fixed[0].packing exists in 2 dimensions only, and the scene has 3: give \"lattice\" or \"fitted\"",
    ),
    (
        "a cylinder without length",
        DAM,
        "to = [0.21, 0.2, 0.05]",
        "to = [0.21, 0.0, 0.05]",
        "scene.toml:22:23: fixed[0].region.cylinder has no length: give its ends different places",
    ),
    (
        "a circle",
        DAM,
        POST,
        "{ circle = { center = [0.2, 0.1], radius = 0.05 } }",
        "scene.toml:22:21: fixed[0].region.circle exists in 2 dimensions only, and the scene has 3: give a ball, or a cylinder",
    ),
    (
        "a polygon",
        DAM,
        POST,
        "{ polygon = [[0.2, 0.0], [0.22, 0.0], [0.2, 0.1]] }",
        "scene.toml:22:22: fixed[0].region.polygon exists in 2 dimensions only, and the scene has 3: put boxes, balls and \
         cylinders together, or cut with half-spaces",
    ),
    (
        "half of everything",
        DAM,
        POST,
        "{ half_space = { through = [0.2, 0.0, 0.0], toward = [1.0, 0.0, 0.0] } }",
        "scene.toml:22:25: fixed[0].region.half_space has no end: take it away from a shape: { difference = [ shape, { half_space \
         = ... } ] }",
    ),
    (
        "a plane without a side",
        DAM,
        POST,
        "{ difference = [{ ball = { center = [0.21, 0.1, 0.05], radius = 0.04 } }, { half_space = { through = [0.2, 0.0, 0.0], \
         toward = [0.0, 0.0, 0.0] } }] }",
        "scene.toml:22:137: fixed[0].region.difference[1].half_space.toward points nowhere: give a vector across the plane",
    ),
    (
        "a tank without walls",
        DAM,
        "open = [\"top\"]",
        "open = [\"top\", \"bottom\", \"left\", \"right\", \"front\", \"back\"]",
        "scene.toml:18:77: walls[0].shape.tank.open is all sides: leave at least one closed",
    ),
    (
        "a wall along a line",
        DAM,
        "{ tank = { lower = [0.0, 0.0, 0.0], upper = [0.3, 0.2, 0.1], open = [\"top\"] } }",
        "{ line = [[0.0, 0.2], [0.0, 0.0], [0.3, 0.0]] }",
        "scene.toml:18:18: walls[0].shape.line exists in 2 dimensions only, and the scene has 3: give a tank, or a region",
    ),
    (
        "a load on a line",
        DAM,
        FRONT,
        "{ wall_pressure = { on = \"post\", from = [0.2, 0.0, 0.0], to = [0.2, 0.1, 0.0] } }",
        "scene.toml:26:29: probes[0].measure.wall_pressure exists in 2 dimensions only, and the scene has 3: give a probe of force \
         on the fixed body",
    ),
    (
        "an inlet",
        DAM,
        "[[walls]]",
        "[[fluid.inlets]]\nopening = { lower = [0.0, 0.0, 0.0], upper = [0.0, 0.1, 0.1] }\ntoward = \"right\"\nmean_speed = \
         1.0\n\n[[walls]]",
        "scene.toml:16:1: fluid.inlets[0] exists in 2 dimensions only, and the scene has 3: leave it out, or let a moved wall push \
         the fluid",
    ),
    (
        "a body held on a disc",
        BEAM,
        "clamp = { sides = [\"left\"] }",
        "clamp = { disc = { center = [0.0, 0.0], radius = 0.1 } }",
        "scene.toml:13:18: solids[0].clamp.disc exists in 2 dimensions only, and the scene has 3: hold a region of the body, or give \
         \"lattice\"",
    ),
    (
        "a post in the water",
        DAM,
        "from = [0.21, 0.0, 0.05], to = [0.21, 0.2, 0.05]",
        "from = [0.1, 0.0, 0.05], to = [0.1, 0.2, 0.05]",
        "scene.toml:13:10: fluid.bodies[0].region overlaps post (fixed[0].region): two particles near (0.0950, 0.0050, 0.0350) are",
    ),
];

fn check(name: &str, text: &str) -> (bool, String) {
    let dir = fresh("scenes-3d-mistakes", &name.replace(' ', "-"));
    std::fs::create_dir_all(&dir).unwrap();
    std::fs::write(dir.join("scene.toml"), text).unwrap();
    let output =
        Command::new(env!("CARGO_BIN_EXE_mps")).args(["check", "scene.toml"]).current_dir(dir).output();
    let output = output.unwrap();
    (output.status.success(), words(&output.stderr))
}

#[test]
fn every_mistake_has_a_message_with_place_and_remedy() {
    for (name, scene, from, to, message) in MISTAKES {
        assert_eq!(scene.matches(from).count(), 1, "{name}: {from}");
        let (good, said) = check(name, &scene.replace(from, to));
        assert!(!good && said.starts_with(&format!("error: {message}")), "{name}: {said}");
    }
}

/// What exists in three dimensions only.
#[test]
fn a_plane_scene_has_no_balls_and_no_sides_along_z() {
    let plate = include_str!("../scenes/cantilever.toml");
    for (name, from, to, message) in [
        (
            "a ball in the plane",
            "region = { box = { lower = [0.0, 0.0], upper = [0.2, 0.02] } }",
            "region = { ball = { center = [0.0, 0.0, 0.0], radius = 0.1 } }",
            "scene.toml:8:19: solids[0].region.ball exists in 3 dimensions only, and the scene has 2: give a circle",
        ),
        (
            "the front of a plate",
            "\"left\"",
            "\"front\"",
            "scene.toml:12:19: solids[0].clamp.sides is a side along z: in two dimensions there are \"left\", \"right\", \"bottom\" \
             and \"top\"",
        ),
    ] {
        let (good, said) = check(name, &plate.replace(from, to));
        assert!(!good && said.contains(message), "{name}: {said}");
    }
}

/// Water beside which no wall stands along z falls out there.
#[test]
fn water_that_reaches_beyond_its_floor_is_a_warning() {
    let (good, said) = check("no floor", &DAM.replace("upper = [0.1, 0.1, 0.1]", "upper = [0.1, 0.1, 0.2]"));
    assert!(!good && said.contains("overlaps tank"), "{said}");
    let open = "open = [\"top\", \"front\"]";
    let wide =
        DAM.replace("upper = [0.1, 0.1, 0.1]", "upper = [0.1, 0.1, 0.2]").replace("open = [\"top\"]", open);
    let (good, said) = check("no floor in front", &wide);
    assert!(good, "{said}");
    assert!(said.contains("fluid.bodies[0].region has 1000 of 2000 particles with no wall below"), "{said}");
}
