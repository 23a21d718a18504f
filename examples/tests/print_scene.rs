//! `--print-scene`: what a program prints is a good scene, running it gives the numbers of the program, and it can be stopped and resumed.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{assert_same, assert_same_plate, fresh, results, words};
use mps_io::CsvTable;
use std::path::Path;
use std::process::{Command, Output};

const MPS: &str = env!("CARGO_BIN_EXE_mps");
const GATE: &str = env!("CARGO_BIN_EXE_elastic-gate");
const DAM: &str = env!("CARGO_BIN_EXE_dam-break");
const PLATE: &str = env!("CARGO_BIN_EXE_cantilever");
const CHANNEL: &str = env!("CARGO_BIN_EXE_turek-hron");

fn print(program: &str, arguments: &[&str]) -> Output {
    Command::new(program).args(arguments).arg("--print-scene").output().unwrap()
}

/// The tables of a program and of the scene that it prints.
fn both(program: &str, name: &str, arguments: &[&str]) -> [CsvTable; 2] {
    let printed = print(program, arguments);
    assert!(printed.status.success() && printed.stderr.is_empty(), "{name}: {}", words(&printed.stderr));
    let dir = fresh("printed", name);
    std::fs::create_dir_all(&dir).unwrap();
    let file = dir.join("scene.toml");
    std::fs::write(&file, &printed.stdout).unwrap();
    let checked = Command::new(MPS).arg("check").arg(&file).output().unwrap();
    assert!(checked.status.success(), "{name}: {}", words(&checked.stderr));
    let (mine, _) = results(MPS, &format!("{name}-printed"), &["run", file.to_str().unwrap()]);
    let (theirs, _) = results(program, &format!("{name}-program"), arguments);
    assert!(mine.columns[0].len() > 5, "{name}: too few rows");
    goes_on(name, &file, &mine);
    [mine, theirs]
}

/// What is printed can be stopped and resumed, and has the numbers of the run in one piece, to the last bit.
fn goes_on(name: &str, file: &Path, whole: &CsvTable) {
    let end = *whole.columns[0].last().unwrap();
    let name = format!("{name}-stopped");
    let half = format!("{:e}", 0.45 * end);
    let begin = ["run", file.to_str().unwrap(), "--end-time", &half, "--threads", "2"];
    let (first, _) = results(MPS, &name, &begin);
    assert!(*first.columns[0].last().unwrap() < 0.6 * end);
    // The last step of the whole run ends there, whatever the rounding.
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join("scenes").join(&name);
    let resume =
        ["resume", dir.to_str().unwrap(), "--end-time", &format!("{:e}", end * (1.0 - 1e-9)), "--quiet"];
    let output = Command::new(MPS).args(resume).output().unwrap();
    assert!(output.status.success(), "{name}: {}", words(&output.stderr));
    let parts = CsvTable::read(dir.join("probes.csv")).unwrap();
    assert!(parts.names == whole.names && parts.columns == whole.columns, "{name}");
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
    let options = ["--spacing", "3e-2", "--end-time", "0.1", "--hydrostatic-diffusion", "--alpha", "0.05"];
    let [mine, theirs] = both(DAM, "dam", &options);
    let columns = [
        ("time [s]", "time [s]"),
        ("fluid kinetic [J/m]", "kinetic [J/m]"),
        ("fluid compression [J/m]", "compression [J/m]"),
        ("time step [s]", "time step [s]"),
    ];
    assert_same(&mine, &theirs, &columns, 1e-9);
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
        (CHANNEL, ["--spacing", "0.006"], "error: --spacing is 0.006: "),
    ] {
        let output = print(program, &arguments);
        let said = words(&output.stderr);
        assert!(!output.status.success() && output.stdout.is_empty(), "{arguments:?}");
        assert!(said.contains(message), "{arguments:?}: {said}");
    }
}
