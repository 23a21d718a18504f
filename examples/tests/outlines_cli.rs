//! Scenes with shapes from files of their own: they run as with the shape itself, and are resumed with the same file only.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{execute, fresh, words};
use std::path::{Path, PathBuf};
use std::process::Command;

const MPS: &str = env!("CARGO_BIN_EXE_mps");
const SCENE: &str = r#"title = "Water that falls on a hill"
end_time = 0.1
gravity = [0.0, -9.81]

[fluid]
spacing = 1e-2
expected_speed = 2.0

[[fluid.bodies]]
region = { box = { lower = [0.05, 0.1], upper = [0.15, 0.15] } }

[[walls]]
name = "tank"
shape = { line = [[0.0, 0.3], [0.0, 0.0], [0.3, 0.0], [0.3, 0.3]] }

[[fixed]]
name = "hill"
region = { polygon = [[0.0625, 0.0], [0.25, 0.0], [0.125, 0.0625]] }

[[probes]]
name = "load"
measure = { force = { on = ["hill"] } }

[output]
probe_interval = 2e-3
"#;
const POLYGON: &str = "{ polygon = [[0.0625, 0.0], [0.25, 0.0], [0.125, 0.0625]] }";
/// The same, twice as large.
const FILE: &str = "# x y\n0.125 0\n0.5 0\n0.25 0.125\n";
const OUTLINE: &str = "{ outline = { file = \"hill.txt\", scale = 0.5 } }";

fn written(name: &str, region: &str) -> PathBuf {
    let dir = fresh("outlines", name);
    std::fs::create_dir_all(&dir).unwrap();
    std::fs::write(dir.join("hill.txt"), FILE).unwrap();
    std::fs::write(dir.join("scene.toml"), SCENE.replace(POLYGON, region)).unwrap();
    dir
}

fn run(dir: &Path, flags: &[&str]) -> PathBuf {
    let (scene, out) = (dir.join("scene.toml"), dir.join("run"));
    let run = ["run", scene.to_str().unwrap(), "--quiet", "--no-fields"];
    let output = execute(MPS, &out, &[&run, flags].concat());
    assert!(output.status.success(), "{}", words(&output.stderr));
    out
}

fn resume(run: &Path, end: &str) -> (bool, String) {
    let output =
        Command::new(MPS).arg("resume").arg(run).args(["--quiet", "--end-time", end]).output().unwrap();
    (output.status.success(), words(&output.stderr))
}

#[test]
fn a_run_with_a_file_is_that_with_its_shape_and_goes_on_where_the_file_has_gone_along() {
    let plain = run(&written("plain", POLYGON), &[]);
    let dir = written("file", OUTLINE);
    let read = run(&dir, &["--end-time", "0.06"]);
    // The run has a copy.
    std::fs::remove_file(dir.join("hill.txt")).unwrap();
    let (good, said) = resume(&read, "0.1");
    assert!(good, "{said}");
    let [mine, theirs] = [&read, &plain].map(|dir| std::fs::read(dir.join("probes.csv")).unwrap());
    assert!(mine == theirs);
    let text = words(&mine);
    let last = text.lines().last().unwrap().split(',').nth(2).unwrap();
    assert!(last.parse::<f64>().unwrap().abs() > 1.0, "the hill is hit: {last}");

    let copies = std::fs::read_dir(read.join("outlines")).unwrap().map(|entry| entry.unwrap().path());
    let copy: Vec<PathBuf> = copies.collect();
    std::fs::write(&copy[0], FILE.replace("0.25 0.125", "0.25 0.12")).unwrap();
    let (good, said) = resume(&read, "0.12");
    assert!(
        !good && said.contains("fixed[0].region.outline.file") && said.contains("has the checksum "),
        "{said}"
    );
}
