//! `--print-scene`: what a program prints is a good scene, and running it gives the numbers of the program. That it can be stopped and
//! resumed is in `restart_matrix.rs`.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{assert_same, assert_same_plate, print, printed, results, words};
use mps_io::CsvTable;
use std::process::Command;

const MPS: &str = env!("CARGO_BIN_EXE_mps");
const GATE: &str = env!("CARGO_BIN_EXE_elastic-gate");
const DAM: &str = env!("CARGO_BIN_EXE_dam-break");
const PLATE: &str = env!("CARGO_BIN_EXE_cantilever");
const CHANNEL: &str = env!("CARGO_BIN_EXE_turek-hron");
const FLAG: &str = env!("CARGO_BIN_EXE_flag-structure");
const BEAM: &str = env!("CARGO_BIN_EXE_submerged-beam");

/// The tables of a program and of the scene that it prints.
fn both(program: &str, name: &str, arguments: &[&str]) -> [CsvTable; 2] {
    let file = printed(program, name, arguments);
    let checked = Command::new(MPS).arg("check").arg(&file).output().unwrap();
    assert!(checked.status.success(), "{name}: {}", words(&checked.stderr));
    let (mine, _) = results(MPS, &format!("{name}-printed"), &["run", file.to_str().unwrap()]);
    let (theirs, _) = results(program, &format!("{name}-program"), arguments);
    assert!(mine.columns[0].len() > 5, "{name}: too few rows");
    [mine, theirs]
}

#[test]
fn the_gate_prints_its_scene() {
    let options = ["--spacing", "2.5e-3", "--end-time", "5e-3", "--material", "e12-nu40", "--cfl", "0.4"];
    let [mine, theirs] = both(GATE, "gate", &options);
    let same = ["time [s]", "energy [J/m]", "fluid kinetic [J/m]", "time step [s]"].map(|name| (name, name));
    assert_same(&mine, &theirs, &same, 1e-9);
    let gate = [("solid kinetic [J/m]", "gate kinetic [J/m]"), ("solid strain [J/m]", "gate strain [J/m]")];
    assert_same(&mine, &theirs, &gate, 1e-9);
}

#[test]
fn the_dam_break_prints_its_scene() {
    let columns = [
        ("time [s]", "time [s]"),
        ("fluid kinetic [J/m]", "kinetic [J/m]"),
        ("fluid compression [J/m]", "compression [J/m]"),
        ("time step [s]", "time step [s]"),
    ];
    for walls in ["law", "free"] {
        let options = ["--spacing", "3e-2", "--end-time", "0.1", "--walls", walls, "--hydrostatic-diffusion"];
        let [mine, theirs] =
            both(DAM, &format!("dam-{walls}"), &[&options[..], &["--alpha", "0.05"]].concat());
        assert_same(&mine, &theirs, &columns, 1e-9);
    }
}

/// With a radius that is no whole number of layers of points the walls are a layer thicker, and begin where they do otherwise.
#[test]
fn the_dam_break_prints_walls_of_whole_layers() {
    for (radius, depth) in [("3", 0.09), ("3.2", 0.105), ("3.25", 0.105), ("3.75", 0.12)] {
        let file = printed(DAM, &format!("dam-radius-{radius}"), &["--spacing", "3e-2", "--radius", radius]);
        let scene: toml::Table = std::fs::read_to_string(&file).unwrap().parse().unwrap();
        let lowest = |wall: &toml::Value| wall["shape"]["region"]["box"]["lower"][1].as_float();
        let bed = scene["walls"]
            .as_array()
            .unwrap()
            .iter()
            .find_map(|wall| (wall["name"].as_str() == Some("bed")).then(|| lowest(wall)).flatten());
        assert!(bed.is_some_and(|y| (y + depth).abs() < 1e-9), "radius {radius}: {bed:?}");
        let checked = Command::new(MPS).arg("check").arg(&file).output().unwrap();
        assert!(checked.status.success(), "{}", words(&checked.stderr));
    }
}

#[test]
fn the_plate_prints_its_scene() {
    let options = ["--across", "6", "--material", "saint-venant", "--end-time", "0.1"];
    let [mine, theirs] = both(PLATE, "plate", &options);
    assert_same_plate(&mine, &theirs);
}

#[test]
fn the_channel_prints_its_scenes() {
    let shape = ["--spacing", "0.01", "--length", "1.2", "--radius", "3.5"];
    let force = [("drag and lift x [N/m]", "drag [N/m]"), ("drag and lift y [N/m]", "lift [N/m]")];
    let step = ["time [s]", "time step [s]"].map(|name| (name, name));
    // Long enough for the end of the flag to move by much more than the rounding of its place.
    let elastic = ["--test", "fsi3", "--across", "4", "--level", "3", "--end-time", "0.03"];
    let [mine, theirs] = both(CHANNEL, "fsi3", &[elastic.as_slice(), &shape].concat());
    let end = ["end x [m]", "end y [m]"].map(|name| (name, name));
    assert_same(&mine, &theirs, &[force.as_slice(), &step, &end].concat(), 1e-9);
    let rigid = ["--test", "cfd1", "--end-time", "0.1"];
    let [mine, theirs] = both(CHANNEL, "cfd1", &[rigid.as_slice(), &shape].concat());
    assert_same(&mine, &theirs, &[force.as_slice(), &step].concat(), 1e-9);
}

#[test]
fn the_flag_prints_its_scenes() {
    for clamp in ["arc", "plane"] {
        let options = ["--across", "4", "--clamp", clamp, "--end-time", "0.05"];
        let [mine, theirs] = both(FLAG, &format!("flag-{clamp}"), &options);
        assert_same_plate(&mine, &theirs);
    }
}

#[test]
fn the_beam_in_water_prints_its_scene() {
    let options = ["--density", "800", "--cfl", "0.4", "--end-time", "0.3"];
    let [mine, theirs] = both(BEAM, "beam", &options);
    let columns = [
        ("time [s]", "time [s]"),
        ("end y [m]", "deflection [m]"),
        ("solid kinetic [J/m]", "beam kinetic [J/m]"),
        ("solid strain [J/m]", "beam strain [J/m]"),
        ("fluid kinetic [J/m]", "fluid kinetic [J/m]"),
        ("time step [s]", "time step [s]"),
    ];
    assert_same(&mine, &theirs, &columns, 1e-9);
}

/// What the flags of every run say about the output is in the scene.
#[test]
fn output_and_precision_are_told() {
    let options = ["--precision", "f32", "--no-fields", "--out", "somewhere/else"];
    let text = words(&print(PLATE, &options).stdout);
    for line in [
        "--precision f32",
        "directory = \"somewhere/else\"",
        "frame_interval = 0.0",
        "picture_interval = 0.0",
    ] {
        assert!(text.contains(line), "{line}: {text}");
    }
    assert!(!std::path::Path::new("somewhere").exists());
}

/// What a scene cannot say is refused, with the reason; so is what `mps check` would refuse.
#[test]
fn what_no_scene_can_say_is_refused() {
    for (program, arguments, message) in [
        (GATE, ["--beside", "out"], "error: --beside is given: a scene knows nothing of other runs"),
        (GATE, ["--alpha", "20"], "fluid.viscosity.artificial is 20: give a strength from 0 to 10"),
        (DAM, ["--release", "lifted"], "error: --release is lifted: a scene cannot put the gate away"),
        (DAM, ["--stabilisers", "--no-books"], "error: --stabilisers is given: a scene is one run"),
        (PLATE, ["--convergence", "--quiet"], "error: --convergence is given: a scene is one run"),
        (FLAG, ["--test", "csm1"], "error: --test is csm1: a scene moves and does not look for rest"),
        (CHANNEL, ["--spacing", "0.006"], "error: --spacing is 0.006: "),
    ] {
        let output = print(program, &arguments);
        let said = words(&output.stderr);
        assert!(!output.status.success() && output.stdout.is_empty(), "{arguments:?}");
        assert!(said.contains(message), "{arguments:?}: {said}");
    }
}
