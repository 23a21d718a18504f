//! Mistakes of a new user in a scene file, and what the program says to each.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

#[path = "../common/mod.rs"]
mod common;
mod doubtful;

use common::words;
use std::process::{Command, Output};

const SCENE: &str = include_str!("../../scenes/two-reservoirs.toml");
const WAVES: &str = include_str!("../../scenes/wave-maker.toml");
const BEAM: &str = include_str!("../../scenes/heavy-beam.toml");
const CHANNEL: &str = include_str!("../../scenes/turek-hron.toml");

/// Checks a text in a directory of its own, so that messages name it `scene.toml`.
fn check(name: &str, text: &str) -> Output {
    let dir = common::fresh("scene-mistakes", name);
    std::fs::create_dir_all(&dir).unwrap();
    std::fs::write(dir.join("scene.toml"), text).unwrap();
    Command::new(env!("CARGO_BIN_EXE_mps")).args(["check", "scene.toml"]).current_dir(dir).output().unwrap()
}

/// A name, what is changed in the scene, and the message.
type Mistake = (&'static str, &'static str, &'static str, &'static str);

const INLET: &str = "opening = { lower = [0.0, 0.0], upper = [0.0, 0.41] }";
const INLET_WHOLE: &str = "[[fluid.inlets]]\nopening = { lower = [0.0, 0.0], upper = [0.0, 0.41] }\ntoward = \"right\"\nmean_speed = 2.0\n\
     profile = \"parabola\"\nramp = 2.0\n";
const OUTLET: &str = "opening = { lower = [1.5, 0.0], upper = [1.5, 0.41] }";

/// Mistakes in openings, fixed bodies and the numerics of fluid that fills its domain.
const IN_THE_CHANNEL: &[Mistake] = &[
    (
        "an inlet that is a box",
        INLET,
        "opening = { lower = [0.0, 0.0], upper = [0.1, 0.41] }",
        "scene.toml:32:11: fluid.inlets[0].opening is 1.000e-1 m thick along x, where the fluid goes: give both corners the same \
         number there, or another `toward`",
    ),
    (
        "an inlet between two spacings",
        INLET,
        "opening = { lower = [0.0, 0.0], upper = [0.0, 0.415] }",
        "scene.toml:32:11: fluid.inlets[0].opening is 41.50 spacings wide along y: give a whole number from 1 to 1e5",
    ),
    (
        "an inlet that sucks",
        "mean_speed = 2.0",
        "mean_speed = -2.0",
        "scene.toml:34:14: fluid.inlets[0].mean_speed is -2: give the mean speed in m/s, above zero: `toward` says where the \
         fluid goes",
    ),
    (
        "a ramp that falls",
        "ramp = 2.0",
        "ramp = -1.0",
        "scene.toml:36:8: fluid.inlets[0].ramp is -1: give the time in seconds, or 0 for full speed from the start on",
    ),
    (
        "a profile nobody knows",
        "\"parabola\"",
        "\"parabolic\"",
        "scene.toml:35:11: parabolic is no choice here in fluid.inlets[0].profile: did you mean `parabola`?",
    ),
    (
        "an outlet beyond the fluid",
        OUTLET,
        "opening = { lower = [1.6, 0.0], upper = [1.6, 0.41] }",
        "scene.toml:39:11: fluid.outlets[0].opening has no fluid before it: let a body of fluid begin at its plane, on the side \
         where the fluid comes from (outlet) or goes to (inlet)",
    ),
    (
        "a channel that is closed",
        "lower = [-0.05, 0.41]",
        "lower = [-0.05, 0.38]",
        "scene.toml:24:10: fluid.bodies[0].region overlaps ceiling (walls[1].shape): two particles near (0.0150, 0.3850) are \
         0.00e0 m apart: move one of them, take one from the other (difference), give the line of a wall the other direction \
         (fluid is on its left), or a spacing of which the lengths are multiples\n\
         scene.toml:32:11: fluid.inlets[0].opening has a wall behind it near (-0.0350, 0.3850): leave what lies behind the plane free of walls\n\
         scene.toml:39:11: fluid.outlets[0].opening has a wall behind it near (1.5050, 0.3850): leave what lies behind the plane free of walls",
    ),
    (
        "relaxation at a free surface",
        "tension = \"keep\"",
        "tension = \"clip\"",
        "scene.toml:21:22: fluid.numerics.density_relaxation is 0.01: give 0 with a free surface, about 0.01 with tension = \
         \"keep\", at most 0.03",
    ),
    (
        "a weight that does not go with the viscosity",
        "radius = 3.0",
        "radius = 3.0\nweight = \"wendland\"",
        "scene.toml:11:25: fluid.viscosity.compact does not go with this weight: its weight, over the square of the distance, \
         has to stay finite: give \"laminar\", or the weight \"smooth\"",
    ),
    (
        "rings in what is not round",
        "{ circle = { center = [0.2, 0.2], radius = 0.05 } }\npacking",
        "{ box = { lower = [0.15, 0.15], upper = [0.24, 0.25] } }\npacking",
        "scene.toml:55:11: fixed[0].packing is \"rings\", but the body is no circle: rings fill circles: give such a region, or \
         \"fitted\" for any other",
    ),
    (
        "a clamp beside the flag",
        "clamp = { disc = { center = [0.2, 0.2]",
        "clamp = { disc = { center = [0.2, 0.3]",
        "scene.toml:64:18: solids[0].clamp.disc does not reach all rows of the box: let the disc reach above and below the box",
    ),
    (
        "a clamp far from the flag",
        "clamp = { disc = { center = [0.2, 0.2]",
        "clamp = { disc = { center = [0.1, 0.2]",
        "scene.toml:64:18: solids[0].clamp.disc is 1.010e-1 m from the left end of the box, which is 3.500e-1 m long: let the box \
         begin where it touches the disc: rows are stretched by a fifth at most",
    ),
    (
        "a clamp between two rows",
        "clamp = { disc = { center = [0.2, 0.2], radius = 0.05 } }",
        "clamp = { region = { box = { lower = [0.25, 0.19], upper = [0.2505, 0.21] } } }",
        "scene.toml:64:20: solids[0].clamp.region holds no particle: let the region cover the middle of at least one row of \
         particles, or hold a side of a box",
    ),
    (
        "a flag that moves in the cylinder",
        "clamp = { disc = { center = [0.2, 0.2], radius = 0.05 } }",
        "clamp = { disc = { center = [0.2, 0.2], radius = 0.045 } }",
        "scene.toml:60:10: solids[0].region overlaps the fixed body cylinder near (0.2494, 0.1925): move one of them: only particles \
         that are held may be in a fixed body",
    ),
    (
        "a force on nobody",
        "on = [\"cylinder\", \"flag\"]",
        "on = [\"cylinder\", \"flagg\"]",
        "scene.toml:73:41: probes[1].measure.force.on[1] is \"flagg\", and no body has this name: did you mean `flag`?",
    ),
    (
        "a force counted twice",
        "on = [\"cylinder\", \"flag\"]",
        "on = [\"flag\", \"flag\"]",
        "scene.toml:73:37: probes[1].measure.force.on[1] is \"flag\" again: name each body once",
    ),
    (
        "sound slower than what enters",
        "sound_speed = 40.0",
        "sound_speed = 2.5",
        "scene.toml:10:15: fluid.sound_speed makes the sound 2.500 m/s fast, and fluid may reach 3.000 m/s: Mach 1.20, the density \
         would vary by 144 %: give about 30.000",
    ),
];

/// Mistakes in everything else.
const MISTAKES: &[Mistake] = &[
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
        "a probe between the body and what is too far",
        "at = [0.206, 0.16]",
        "at = [0.206, 0.1622]",
        "scene.toml:32:51: probes[0].measure.displacement.at is [0.206, 0.1622], where \"gate\" has too few particles around: give a \
         point in the undeformed body or on its surface",
    ),
    (
        "two probes with one plot",
        "name = \"right level\"",
        "name = \"left_level\"",
        "scene.toml:39:8: probes[2].name makes a column \"left_level [m]\", whose plot has the name of one of \"left level\": \
         change one: units and what spaces become do not tell them apart",
    ),
    (
        "two probes with one column",
        "name = \"right level\"",
        "name = \"top of the gate y\"",
        "scene.toml:39:8: probes[2].name makes a column \"top of the gate y [m]\", whose plot has the name of one of \
         \"top of the gate\": change one: units and what spaces become do not tell them apart",
    ),
    (
        "a name that is no name of a file",
        "name = \"left level\"",
        "name = \"left: level\"",
        "scene.toml:35:8: probes[1].name is \"left: level\": give it letters, digits, spaces or dashes, at most 200",
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
        "scene.toml:24:10: solids[0].region is 1.75 particles of the fluid thick and needs at least 3: make it thicker, or give \
         fluid.spacing at most 2.333e-3",
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
    assert!(SCENE.len() > 500 && MISTAKES.len() >= 10 && IN_THE_CHANNEL.len() >= 10);
    let in_the_tank = MISTAKES.iter().map(|mistake| (SCENE, mistake));
    for (scene, (name, from, to, message)) in in_the_tank.chain(IN_THE_CHANNEL.iter().map(|m| (CHANNEL, m))) {
        assert_eq!(scene.matches(from).count(), 1, "{name}: {from}");
        let output = check(&name.replace(' ', "-"), &scene.replace(from, to));
        assert_eq!(output.status.code(), Some(1), "{name}");
        let said = words(&output.stderr);
        let refused: Vec<&str> = said.lines().filter(|line| !line.starts_with("warning: ")).collect();
        assert_eq!(refused.join("\n"), format!("error: {message}"), "{name}");
    }
}

/// Points near what was cut out of a body are points of it.
#[test]
fn a_point_beside_a_hole_can_be_measured() {
    for at in ["[0.2, 0.032]", "[0.2, 0.03]", "[0.185, 0.02]"] {
        let scene = BEAM.replace("at = [0.2, 0.0]", &format!("at = {at}"));
        assert_ne!(scene, BEAM);
        let output = check(&format!("beside-a-hole-{at}"), &scene);
        assert!(output.status.success() && output.stderr.is_empty(), "{at}: {}", words(&output.stderr));
    }
    let output = check("in-a-hole", &BEAM.replace("at = [0.2, 0.0]", "at = [0.2, 0.02]"));
    assert!(words(&output.stderr).contains("outside the body"), "{}", words(&output.stderr));
}

/// A clamp only says which particles are held: it need not end where the body does.
#[test]
fn a_clamp_may_be_larger_than_its_body() {
    let large = "clamp = { region = { box = { lower = [-10.0, -10.0], upper = [10.0, 0.01] } } }";
    let output = check("a-large-clamp", &SCENE.replace("clamp = { sides = [\"bottom\"] }", large));
    assert!(output.status.success() && output.stderr.is_empty(), "{}", words(&output.stderr));
}
