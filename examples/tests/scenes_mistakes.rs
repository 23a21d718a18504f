//! Mistakes of a new user in a scene file, and what the program says to each.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::words;
use std::process::{Command, Output};

const SCENE: &str = include_str!("../scenes/two-reservoirs.toml");

/// Checks a text in a directory of its own, so that messages name it `scene.toml`.
fn check(name: &str, text: &str) -> Output {
    let dir = common::fresh("scene-mistakes", name);
    std::fs::create_dir_all(&dir).unwrap();
    std::fs::write(dir.join("scene.toml"), text).unwrap();
    Command::new(env!("CARGO_BIN_EXE_mps")).args(["check", "scene.toml"]).current_dir(dir).output().unwrap()
}

/// What is changed in the scene, and the message.
const MISTAKES: &[(&str, &str, &str, &str)] = &[
    (
        "a typing error in a key",
        "spacing = 4e-3",
        "spcing = 4e-3",
        "scene.toml:7:1: spcing is no key here: did you mean `spacing`?",
    ),
    (
        "a typing error in a choice",
        "neo_hookean",
        "neohookean",
        "scene.toml:27:14: neohookean is no choice here in solids[0].material: did you mean `neo_hookean`?",
    ),
    (
        "a text for a number",
        "density = 1100",
        "density = \"heavy\"",
        "scene.toml:26:11: solids[0].density is the string \"heavy\": give a number",
    ),
    (
        "not a number",
        "end_time = 1.0",
        "end_time = nan",
        "scene.toml:3:12: end_time is nan: give a finite number",
    ),
    (
        "a number for a vector",
        "gravity = [0.0, -9.81]",
        "gravity = -9.81",
        "scene.toml:4:11: gravity is the floating point `-9.81`: give a list, a point as [0.0, 1.0]",
    ),
    (
        "a negative thickness",
        "lower = [0.212, 0.0], upper = [0.412, 0.06]",
        "lower = [0.412, 0.0], upper = [0.212, 0.06]",
        "scene.toml:15:18: fluid.bodies[1].region.box has the thickness -2.000e-1 m along x: let every number of `upper` be \
         larger than that of `lower`",
    ),
    (
        "no such material",
        "poissons_ratio = 0.4",
        "poissons_ratio = 0.5",
        "scene.toml:27:69: solids[0].material.neo_hookean.poissons_ratio is 0.5: give a ratio between -1 and 0.5, both \
         excluded: nearly incompressible is 0.49",
    ),
    (
        "a clamp outside the body",
        "clamp = { sides = [\"bottom\"] }",
        "clamp = { region = { box = { lower = [0.5, 0.0], upper = [0.6, 0.1] } } }",
        "scene.toml:28:20: solids[0].clamp.region is outside the body: let it cover the part of the body that is held",
    ),
    (
        "a body nobody has",
        "solid = \"gate\"",
        "solid = \"gat\"",
        "scene.toml:32:38: probes[0].measure.displacement.solid is \"gat\", and no solid has this name: did you mean `gate`?",
    ),
    (
        "a probe outside",
        "at = [0.206, 0.16]",
        "at = [0.206, 1.6]",
        "scene.toml:32:51: probes[0].measure.displacement.at is [0.206, 1.6], outside the body \"gate\": give a point of the \
         undeformed body",
    ),
    (
        "sound slower than the water",
        "expected_speed = 1.6",
        "expected_speed = 0.1",
        "scene.toml:9:18: fluid.expected_speed makes the sound 1.000 m/s fast, and fluid may reach 1.515 m/s: Mach 1.52, \
         the density would vary by 230 %: give about 1.515",
    ),
    (
        "no speed at all",
        "expected_speed = 1.6",
        "",
        "scene.toml:6:1: fluid has no speed: add `expected_speed`, the largest speed of the flow in m/s, e.g. sqrt(2 g H) for \
         water of the height H",
    ),
    (
        "water in the gate",
        "upper = [0.2, 0.12]",
        "upper = [0.21, 0.12]",
        "scene.toml:12:10: fluid.bodies[0].region overlaps gate (solids[0].region): two particles near (0.2020, 0.0060) are \
         5.00e-4 m apart: move one of them, take one from the other (difference), give the line of a wall the other direction \
         (fluid is on its left), or a spacing of which the lengths are multiples",
    ),
    (
        "a gate too thin for the water",
        "upper = [0.212, 0.16]",
        "upper = [0.207, 0.16]",
        "scene.toml:24:10: solids[0].region is 1.75 particles of the fluid thick and needs at least 2: make it thicker, or give \
         fluid.spacing at most 3.500e-3",
    ),
    (
        "a corner too sharp for a wall",
        "[0.412, 0.0], [0.412, 0.2]]",
        "[0.412, 0.0], [0.2, 0.2]]",
        "scene.toml:19:43: walls[0].shape.line[2] turns the line by 137 degrees: cut the corner with one more point: at most \
         135 degrees",
    ),
    (
        "two bodies in one place",
        "[[probes]]\nname = \"top of the gate\"",
        "[[solids]]\nname = \"post\"\nregion = { box = { lower = [0.203, 0.13], upper = [0.215, 0.15] } }\nspacing = 3e-3\n\
         density = 1100\nmaterial = { corotational = { youngs_modulus = 2e6, poissons_ratio = 0.3 } }\n\n\
         [[probes]]\nname = \"top of the gate\"",
        "scene.toml:24:10: solids[0].region overlaps the body post near (0.2045, 0.1316): move one of them, or make one body of \
         both (union)",
    ),
];

#[test]
fn every_mistake_has_a_message_with_place_and_remedy() {
    assert!(SCENE.len() > 500 && MISTAKES.len() >= 10);
    for (name, from, to, message) in MISTAKES {
        assert_eq!(SCENE.matches(from).count(), 1, "{name}: {from}");
        let output = check(&name.replace(' ', "-"), &SCENE.replace(from, to));
        assert_eq!(output.status.code(), Some(1), "{name}");
        let said = words(&output.stderr);
        let refused: Vec<&str> = said.lines().filter(|line| !line.starts_with("warning: ")).collect();
        assert_eq!(refused, [format!("error: {message}")], "{name}");
    }
}

/// What can be run but is most likely not meant is said, and not refused.
#[test]
fn what_is_doubtful_is_a_warning() {
    for (name, from, to, message) in [
        (
            "a gap beside the gate",
            "lower = [0.212, 0.0]",
            "lower = [0.22, 0.0]",
            "fluid.bodies[1].region leaves a gap of 8.00e-3 m to gate",
        ),
        (
            "few particles across",
            "spacing = 3e-3",
            "spacing = 6e-3",
            "solids[0].spacing makes 2.0 particles across",
        ),
        (
            "a slow sound",
            "expected_speed = 1.6",
            "expected_speed = 0.6",
            "fluid.expected_speed makes the sound 6.000 m/s fast",
        ),
        (
            "no floor",
            "[[0.0, 0.2], [0.0, 0.0], [0.412, 0.0], [0.412, 0.2]]",
            "[[0.0, 0.2], [0.0, 0.0], [0.212, 0.0]]",
            "fluid.bodies[1].region has 735 of 750 particles with no wall below",
        ),
    ] {
        let output = check(&name.replace(' ', "-"), &SCENE.replace(from, to));
        let said = words(&output.stderr);
        assert!(output.status.success(), "{name}: {said}");
        assert!(said.starts_with("warning: scene.toml:") && said.contains(message), "{name}: {said}");
    }
}
