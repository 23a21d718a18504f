//! Scenes in three dimensions.
#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{execute, fresh, words};
use mps_io::{CsvTable, Summary};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const MPS: &str = env!("CARGO_BIN_EXE_mps");
const TANK: &str = include_str!("../scenes/hydrostatic-tank-3d.toml");
const DAM: &str = include_str!("../scenes/dam-break-3d.toml");
const BEAM: &str = include_str!("../scenes/cantilever-3d.toml");

/// The text after these changes, as a file.
fn written(name: &str, text: &str, changes: &[(&str, &str)]) -> PathBuf {
    let mut text = text.to_owned();
    for (from, to) in changes {
        assert_eq!(text.matches(from).count(), 1, "{name} has {from}");
        text = text.replace(from, to);
    }
    let dir = fresh("scenes-3d", name);
    std::fs::create_dir_all(&dir).unwrap();
    std::fs::write(dir.join("scene.toml"), text).unwrap();
    dir.join("scene.toml")
}

/// Runs a scene with everything that it writes; what became of it, and where.
fn run(name: &str, scene: &Path, flags: &[&str]) -> (Output, PathBuf) {
    let dir = fresh("scenes-3d", &format!("{name}-run"));
    let run = ["run", scene.to_str().unwrap(), "--quiet"];
    (execute(MPS, &dir, &[&run, flags].concat()), dir)
}

fn table(name: &str, scene: &Path, flags: &[&str]) -> CsvTable {
    let (output, dir) = run(name, scene, &[flags, &["--no-fields"]].concat());
    assert!(output.status.success(), "{name}: {}", words(&output.stderr));
    CsvTable::read(dir.join("probes.csv")).unwrap()
}

/// Within the bounds that `validate` has for a tank in three dimensions with fewer particles: 8 for 10 per depth.
#[test]
fn water_at_rest_keeps_its_pressure_its_level_and_its_energy() {
    let table = table("tank", &written("tank", TANK, &[]), &["--end-time", "0.3"]);
    let column = |name: &str| table.column(name).unwrap();
    let late: Vec<usize> = (0..column("time [s]").len()).filter(|k| column("time [s]")[*k] > 0.2).collect();
    for (number, depth) in [0.02, 0.04, 0.06, 0.08].into_iter().enumerate() {
        let pressure = column(&format!("depth {} [Pa]", number + 1));
        let mean = late.iter().map(|k| pressure[*k]).sum::<f64>() / late.len() as f64;
        assert!((mean / 981.0 - depth / 0.1).abs() < 0.03, "{mean} Pa at {depth} m");
    }
    assert!(column("level [m]").iter().all(|level| (level / 0.1 - 1.0).abs() < 0.05));
    // The potential energy over the floor at the start: rho g H/2 of a litre of water.
    let potential = 1000.0 * 9.81 * 0.05 * 1e-3;
    assert!(late.iter().all(|k| column("fluid kinetic [J]")[*k] < 1e-3 * potential));
}

/// Between smooth walls, water that is the same at every z moves as in two dimensions.
#[test]
fn the_front_of_a_dam_break_is_that_in_two_dimensions_and_a_post_feels_it() {
    let post = DAM.find("[[fixed]]").unwrap();
    let (probes, load) = (DAM.find("[[probes]]").unwrap(), DAM.find("[[probes]]\nname = \"load").unwrap());
    let alone = format!("{}{}", &DAM[..post], &DAM[probes..load]);
    let plane = [
        ("dimension = 3\n", ""),
        ("-9.81, 0.0]", "-9.81]"),
        ("lower = [0.0, 0.0, 0.0], upper = [0.1, 0.1, 0.1]", "lower = [0.0, 0.0], upper = [0.1, 0.1]"),
        ("lower = [0.0, 0.0, 0.0], upper = [0.3, 0.2, 0.1]", "lower = [0.0, 0.0], upper = [0.3, 0.2]"),
        ("[0.1, 0.0, 0.05]", "[0.1, 0.0]"),
    ];
    let two = table("two", &written("two", &alone, &plane), &["--end-time", "0.12"]);
    // The post is reached after 0.09 m.
    let three = table("three", &written("three", DAM, &[]), &["--end-time", "0.25"]);
    let at = |table: &CsvTable, time: f64| {
        let row = table.column("time [s]").unwrap().iter().position(|t| *t >= time).unwrap();
        table.column("front [m]").unwrap()[row]
    };
    for time in [0.05, 0.08, 0.1] {
        let (flat, deep) = (at(&two, time), at(&three, time));
        assert!(flat > 0.01 && (flat - deep).abs() < 0.01, "{flat} and {deep} after {time}");
    }
    let column = |name: &str| three.column(name).unwrap();
    let [x, z] = ["x", "z"].map(|axis| column(&format!("handed to the post impulse {axis} [N s]")));
    let (x, z) = (x.last().unwrap(), z.last().unwrap());
    assert!(*x > 1e-3 && z.abs() < 0.05 * x, "{x} N s along the flow, {z} across");
    // About the origin a push along x in the middle of the tank turns by z times as much about y.
    let y = column("handed to the post angular impulse y [N m s]").last().unwrap();
    assert!((y - 0.05 * x).abs() < 0.1 * 0.05 * x, "{y}");
    // The force is the impulse since the row before.
    let (force, time) = (column("load of the post x [N]"), column("time [s]"));
    let sum: f64 = (1..time.len()).map(|k| force[k] * (time[k] - time[k - 1])).sum();
    assert!((sum - x).abs() < 1e-9 * x.abs(), "{sum} and {x}");
}

/// Euler and Bernoulli have 0.2769 s; the beam is 4 particles thick and shorter than theirs by shear.
#[test]
fn a_beam_vibrates_with_its_period() {
    let table = table("beam", &written("beam", BEAM, &[]), &[]);
    let column = |name: &str| table.column(name).unwrap();
    let (time, tip) = (column("time [s]"), column("tip y [m]"));
    let down = (1..time.len()).find(|k| tip[k - 1] > 0.0 && tip[*k] <= 0.0).unwrap();
    let up = (down..time.len()).find(|k| tip[k - 1] < 0.0 && tip[*k] >= 0.0).unwrap();
    assert!((time[up] / 0.2769 - 1.0).abs() < 0.03, "{}", time[up]);
    let sideways = column("tip z [m]").iter().fold(0.0_f64, |largest, z| largest.max(z.abs()));
    assert!(sideways < 1e-9, "{sideways}");
    let (energy, start) = (column("energy [J]"), column("energy [J]")[0]);
    assert!(energy.iter().all(|e| (e / start - 1.0).abs() < 1e-3));
}

/// Small and short, with intervals of its own, so that the end may change.
fn small(name: &str) -> PathBuf {
    let output = "end_time = 0.04\noutput = { probe_interval = 1e-3, frame_interval = 8e-3, field_interval = 8e-3, \
                  picture_interval = 2e-2 }";
    written(name, DAM, &[("spacing = 1e-2", "spacing = 2e-2"), ("end_time = 0.4", output)])
}

#[test]
fn a_run_goes_on_with_the_same_bits_on_any_number_of_threads() {
    let scene = small("restart");
    let (output, one) = run("in-one-piece", &scene, &["--threads", "1"]);
    assert!(output.status.success(), "{}", words(&output.stderr));
    let (output, other) = run("in-two-pieces", &scene, &["--threads", "3", "--end-time", "0.02"]);
    assert!(output.status.success(), "{}", words(&output.stderr));
    let resume = ["--threads", "2", "--quiet", "--end-time", "0.04"];
    let output = Command::new(MPS).arg("resume").arg(&other).args(resume).output().unwrap();
    assert!(output.status.success(), "{}", words(&output.stderr));
    for file in ["probes.csv", "fields/water.pvd", "fields/water_00005.vtu", "picture_000040ms.png"] {
        let [a, b] = [&one, &other].map(|dir| std::fs::read(dir.join(file)).unwrap());
        assert!(a == b, "{file}");
    }
}

/// A run that fails is examined in its dimension, and passed with shorter steps where the scene says so.
#[test]
fn a_failure_is_told_with_three_components_and_can_be_tried_again() {
    let changes = [
        ("spacing = 1e-2", "spacing = 2e-2\nnumerics = { cfl = 0.5 }"),
        (
            "end_time = 0.4",
            "end_time = 0.1\nwatch = { energy_rise = 10.0, steps = 5, region = { lower = [-0.1, -0.1, -0.1], upper = [0.14, 0.3, 0.2] } }",
        ),
    ];
    let scene = written("failing", DAM, &changes);
    let (output, dir) = run("failing", &scene, &["--no-fields"]);
    let said = words(&output.stderr);
    assert!(
        !output.status.success() && said.contains("has left the region of `watch.region` in step "),
        "{said}"
    );
    let report = std::fs::read_to_string(dir.join("post-mortem/report.md")).unwrap();
    for words in ["| position z [m] |", "| acceleration by [m/s2] | x | y | z | size |", "| energy [J] |"] {
        assert!(report.contains(words), "{words} in {report}");
    }
    assert!(dir.join("post-mortem/picture.png").exists());
    let (output, dir) = run("retried", &scene, &["--no-fields", "--on-failure", "retry"]);
    assert!(!output.status.success());
    let notes = Summary::read(dir.join("summary.json")).unwrap().notes;
    assert!(notes.iter().any(|note| note.starts_with("retry 3: went back to ")), "{notes:?}");
}

#[test]
fn a_plan_names_the_plane_of_the_pictures() {
    let scene = small("plan");
    let output = Command::new(MPS).args(["plan", "--threads", "1"]).arg(&scene).output().unwrap();
    let plan = words(&output.stdout);
    assert!(output.status.success(), "{}", words(&output.stderr));
    for line in
        ["particles      125 of fluid, ", "\npictures       the particles near the plane z = 0.0500 m\n"]
    {
        assert!(plan.contains(line), "{line} in {plan}");
    }
}
