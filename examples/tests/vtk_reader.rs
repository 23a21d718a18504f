//! Fields of a scene in three dimensions are read back by VTK's own reader, and are the same in every form: `MPS_PYTHON` is a Python that has
//! it (`pip install vtk`).
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{execute, fresh, root, words};
use mps_io::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

const MPS: &str = env!("CARGO_BIN_EXE_mps");
const TANK: &str = include_str!("../scenes/hydrostatic-tank-3d.toml");

/// What VTK finds in the files of fields of a run with this ending, in the order of their names.
fn read(run: &Path, ending: &str) -> Vec<Value> {
    let entries = std::fs::read_dir(run.join("fields")).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<PathBuf> =
        entries.filter(|path| path.extension().is_some_and(|found| found == ending)).collect();
    files.sort();
    let python = std::env::var("MPS_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let script = root().join("mps-io/tests/vtk_reader.py");
    let output = Command::new(python).arg(script).args(&files).output().unwrap();
    assert!(output.status.success(), "{}", words(&output.stderr));
    words(&output.stdout).lines().map(|line| line.parse().unwrap()).collect()
}

#[test]
#[ignore = "needs a Python with vtk, named by MPS_PYTHON"]
fn every_form_of_a_scene_in_three_dimensions_comes_back_the_same() {
    let coarse = TANK.replace("spacing = 1e-2", "spacing = 2e-2");
    assert_ne!(coarse, TANK);
    let frames = ["vtu", "vtp", "vtkhdf"].map(|form| {
        let dir = fresh("vtk-reader", form);
        std::fs::create_dir_all(&dir).unwrap();
        let scene = dir.join("tank.toml");
        let output = format!(
            "\n[output]\nfield_form = \"{form}\"\nfield_precision = \"f64\"\nfield_interval = 5e-3\n"
        );
        std::fs::write(&scene, format!("{coarse}{output}")).unwrap();
        let (run, flags) = (dir.join("run"), ["--quiet", "--threads", "1", "--end-time", "0.01"]);
        let done = execute(MPS, &run, &[&["run", scene.to_str().unwrap()], flags.as_slice()].concat());
        assert!(done.status.success(), "{form}: {}", words(&done.stderr));
        read(&run, form)
    });
    let [vtu, vtp, hdf] = &frames;
    // Walls, and water at the start and after each interval.
    assert_eq!(vtu.len(), 4);
    for frame in &vtu[1..] {
        assert_eq!([&frame["points"], &frame["vertices"]], [125, 125]);
        assert_eq!(frame["arrays"]["velocity"]["components"], 3);
        assert_eq!(frame["arrays"]["velocity"]["type"], "double");
    }
    assert_ne!(vtu[1]["arrays"]["Points"], vtu[3]["arrays"]["Points"], "the water moves");
    assert!(vtu == vtp && vtu == hdf);
}
