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

/// A directory with this file and this scene.
fn files(name: &str, shape: (&str, &str), scene: &str) -> PathBuf {
    let dir = fresh("outlines", name);
    let file = dir.join(shape.0);
    std::fs::create_dir_all(file.parent().unwrap()).unwrap();
    std::fs::write(file, shape.1).unwrap();
    std::fs::write(dir.join("scene.toml"), scene).unwrap();
    dir
}

fn written(name: &str, region: &str) -> PathBuf {
    files(name, ("hill.txt", FILE), &SCENE.replace(POLYGON, region))
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

    is_refused_with_another_file(&read, "0.12", ("0.25 0.125", "0.25 0.12"));
}

/// A run is not resumed after its copy of the file has been changed.
fn is_refused_with_another_file(run: &Path, end: &str, (from, to): (&str, &str)) {
    let copies = std::fs::read_dir(run.join("outlines")).unwrap().map(|entry| entry.unwrap().path());
    let copies: Vec<PathBuf> = copies.collect();
    assert_eq!(copies.len(), 1, "one file, however many regions are made of it");
    let text = std::fs::read_to_string(&copies[0]).unwrap();
    assert!(text.contains(from));
    std::fs::write(&copies[0], text.replace(from, to)).unwrap();
    let (good, said) = resume(run, end);
    assert!(!good && said.contains(".outline.file") && said.contains("has the checksum "), "{said}");
}

/// The scenes of the gallery with files, in both dimensions, coarser and shorter.
#[test]
fn scenes_of_the_gallery_with_files_go_on_with_the_same_bits_and_the_same_files() {
    let gallery = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    // Rows come at the same times whatever the end.
    let rows = ("\n[[probes]]", "\n[output]\nprobe_interval = 2e-3\n\n[[probes]]");
    let pier = ("spacing = 5e-3", "spacing = 1e-2");
    let (two, three) = (("spacing = 5e-3", "spacing = 1e-2"), ("spacing = 1e-2", "spacing = 2e-2"));
    let (crest, top) = (("215 150", "210 150"), ("vertex 15 200 15", "vertex 15 190 15"));
    for (name, shape, changes, [half, end], other_file) in [
        ("breakwater", "shapes/breakwater.txt", [two, rows].as_slice(), ["0.04", "0.08"], crest),
        ("pier-3d", "shapes/pier.stl", &[three, rows, pier], ["0.02", "0.04"], top),
    ] {
        let shape = (shape, std::fs::read_to_string(gallery.join(shape)).unwrap());
        let mut scene = std::fs::read_to_string(gallery.join(name).with_extension("toml")).unwrap();
        for (from, to) in changes {
            assert!(scene.contains(from), "{name} has {from}");
            scene = scene.replacen(from, to, 1);
        }
        let old = scene.lines().find(|line| line.starts_with("end_time")).unwrap().to_owned();
        scene = scene.replace(&old, &format!("end_time = {end}"));
        let write = |part: &str| files(&format!("{name}-{part}"), (shape.0, &shape.1), &scene);
        let whole = run(&write("whole"), &["--threads", "1"]);
        let parts = run(&write("parts"), &["--threads", "2", "--end-time", half]);
        let (good, said) = resume(&parts, end);
        assert!(good, "{name}: {said}");
        let [one, other] = [&whole, &parts].map(|dir| std::fs::read(dir.join("probes.csv")).unwrap());
        assert!(one == other, "{name}");
        is_refused_with_another_file(&parts, end, other_file);
    }
}
