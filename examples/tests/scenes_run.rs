//! The scenes of examples/scenes: each is good, runs, and those of the programs run as the programs do.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{assert_same, assert_same_plate, execute, fresh, results, words};
use mps_io::{CsvTable, Summary};
use std::path::{Path, PathBuf};
use std::process::Command;

const MPS: &str = env!("CARGO_BIN_EXE_mps");

fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes")
}

/// Runs a scene of the gallery after some changes of its text.
fn scene(name: &str, changes: &[(&str, &str)], arguments: &[&str]) -> (CsvTable, Summary) {
    let mut text = std::fs::read_to_string(scenes().join(name)).unwrap();
    for (from, to) in changes {
        assert_eq!(text.matches(from).count(), 1, "{name} has {from}");
        text = text.replace(from, to);
    }
    let dir = fresh("scene-files", name);
    std::fs::create_dir_all(&dir).unwrap();
    let file = dir.join(name);
    std::fs::write(&file, text).unwrap();
    results(MPS, name, &[&["run", file.to_str().unwrap()], arguments].concat())
}

#[test]
fn every_scene_is_good_without_a_warning_and_runs() {
    let mut count = 0;
    for entry in std::fs::read_dir(scenes()).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            continue; // The shapes of some.
        }
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let output = Command::new(MPS).arg("check").arg(&path).output().unwrap();
        assert!(output.status.success() && output.stderr.is_empty(), "{name}: {}", words(&output.stderr));
        // Other tests of this file run some of them at the same time, in directories of the names.
        let arguments = ["run", path.to_str().unwrap(), "--end-time", "2e-3"];
        let (table, summary) = results(MPS, &format!("gallery-{name}"), &arguments);
        assert!(table.columns[0].last().unwrap() >= &2e-3, "{name}");
        assert_eq!(summary.status, "completed");
        count += 1;
    }
    assert!(count >= 10, "{count} scenes");
}

#[test]
fn the_scene_of_the_elastic_gate_is_that_of_the_program() {
    // The floor as long as the program makes it for this end.
    let (mine, ours) =
        scene("elastic-gate.toml", &[("[1.4307, 0.0]", "[0.155, 0.0]")], &["--end-time", "4e-3"]);
    let (theirs, program) = results(env!("CARGO_BIN_EXE_elastic-gate"), "gate", &["--end-time", "4e-3"]);
    assert_eq!(ours.particles, program.particles);
    let same = ["time [s]", "energy [J/m]", "fluid kinetic [J/m]", "fluid compression [J/m]"];
    assert_same(&mine, &theirs, &same.map(|name| (name, name)), 1e-9);
    let gate = [
        ("solid kinetic [J/m]", "gate kinetic [J/m]"),
        ("solid strain [J/m]", "gate strain [J/m]"),
        ("work on solids [J/m]", "work on gate [J/m]"),
    ];
    assert_same(&mine, &theirs, &gate, 1e-9);
    // The corner is read off the particles by another formula.
    assert_same(&mine, &theirs, &[("gate corner x [m]", "gate corner x [m]")], 1e-4);
}

/// The walls of the scene lie along a line, on which whole cells are fitted; those of the program begin at the far
/// wall and go on beyond the near one. So the walls differ by 0.1 mm, and water and front by a little.
#[test]
fn the_scene_of_the_dam_break_has_the_front_of_the_program() {
    let coarse = [("spacing = 5e-3", "spacing = 2e-2")];
    let (mine, ours) = scene("dam-break.toml", &coarse, &["--end-time", "0.4"]);
    let arguments = ["--spacing", "2e-2", "--end-time", "0.4", "--no-books"];
    let (theirs, program) = results(env!("CARGO_BIN_EXE_dam-break"), "dam", &arguments);
    assert_eq!(ours.particles["fluid"], program.particles["fluid"]);
    const HEIGHT: f64 = 0.6;
    let (front, published) = (mine.column("front [m]").unwrap(), theirs.column("front x/H [-]").unwrap());
    assert!(front.last().unwrap() > &1.0, "{front:?}");
    for (x, y) in front.iter().zip(published) {
        assert!((x - HEIGHT * y).abs() < 0.02 * 2e-2, "{x} m and {} m", HEIGHT * y);
    }
    assert_same(&mine, &theirs, &[("fluid kinetic [J/m]", "kinetic [J/m]")], 1e-3);
}

#[test]
fn the_scene_of_the_cantilever_is_that_of_the_program() {
    let (mine, ours) = scene("cantilever.toml", &[], &["--end-time", "0.3"]);
    let (theirs, program) = results(env!("CARGO_BIN_EXE_cantilever"), "plate", &["--end-time", "0.3"]);
    assert_eq!(ours.particles["structure"], program.particles["solid"]);
    assert_same_plate(&mine, &theirs);
}

/// The channel, with the elastic flag and the rigid one: forces, motion and steps.
#[test]
fn the_scenes_of_the_channel_are_those_of_the_program() {
    const PROGRAM: &str = env!("CARGO_BIN_EXE_turek-hron");
    let shape = ["--spacing", "0.01", "--length", "1.5"];
    let force = [("drag and lift x [N/m]", "drag [N/m]"), ("drag and lift y [N/m]", "lift [N/m]")];
    let step = ["time [s]", "time step [s]"].map(|name| (name, name));

    let (mine, ours) = scene("turek-hron.toml", &[], &["--end-time", "0.03"]);
    let elastic = ["--test", "fsi3", "--across", "4", "--end-time", "0.03"];
    let (theirs, program) = results(PROGRAM, "fsi3", &[elastic.as_slice(), &shape].concat());
    let flag = [
        ("end x [m]", "end x [m]"),
        ("end y [m]", "end y [m]"),
        ("solid kinetic [J/m]", "flag kinetic [J/m]"),
        ("solid strain [J/m]", "flag strain [J/m]"),
        ("work on solids [J/m]", "work on flag [J/m]"),
    ];
    assert_same(&mine, &theirs, &[force.as_slice(), &step, &flag].concat(), 1e-9);
    assert_eq!(ours.steps, program.steps);

    let (mine, _) = scene("turek-hron-rigid.toml", &[], &["--end-time", "0.3"]);
    let rigid = ["--test", "cfd1", "--end-time", "0.3"];
    let (theirs, _) = results(PROGRAM, "cfd1", &[rigid.as_slice(), &shape].concat());
    assert_same(&mine, &theirs, &[force.as_slice(), &step].concat(), 1e-9);
}

#[test]
fn a_plan_says_what_a_run_will_be_and_a_run_keeps_its_scene() {
    let file = scenes().join("two-reservoirs.toml");
    let output = Command::new(MPS).args(["plan", "--threads", "1"]).arg(&file).output().unwrap();
    let plan = words(&output.stdout);
    assert!(output.status.success(), "{}", words(&output.stderr));
    for line in [
        "particles      2250 of fluid, 3376 of walls, 216 of bodies\n",
        "               4.0 across the thinnest side of gate\n",
        "Mach number    0.09 expected",
        "limited by sound\n",
        "sub-steps      ",
        "price          by the table",
        " bytes: collisions (DPC)\n",
        " bytes: elastic bodies\n",
        " ns a particle of fluid, measured here with 1 threads\n",
        "wall time      about ",
        "contact of bodies, surface tension",
    ] {
        assert!(plan.contains(line), "{line}: {plan}");
    }
    let dir = fresh("scenes", "kept");
    let run = ["run", file.to_str().unwrap(), "--end-time", "0.02", "--quiet", "--threads", "3"];
    assert!(execute(MPS, &dir, &run).status.success());
    for left in [
        "scene.toml",
        "probes.csv",
        "energies.png",
        "summary.json",
        "film.png",
        "fields/water.pvd",
        "fields/solid gate.pvd",
    ] {
        assert!(dir.join(left).exists(), "{left}");
    }
    // What was run can be run again, to the last bit and with any number of threads.
    let again = fresh("scenes", "again");
    let kept = dir.join("scene.toml");
    assert!(
        execute(MPS, &again, &["run", kept.to_str().unwrap(), "--quiet", "--no-fields", "--threads", "1"])
            .status
            .success()
    );
    let [first, second] = [&dir, &again].map(|dir| std::fs::read(dir.join("probes.csv")).unwrap());
    assert_eq!(first, second);
}
