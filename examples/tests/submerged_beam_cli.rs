//! The command line of the beam in water: what it refuses, and what a run leaves behind.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{execute, fresh, words};
use mps_io::{CsvTable, Summary};
use std::path::Path;

const BEAM: &str = env!("CARGO_BIN_EXE_submerged-beam");

#[test]
fn what_cannot_be_run_is_refused_with_the_flag_and_a_remedy() {
    for (flag, value, remedy) in [
        ("--density", "0", "50 to 5000"),
        ("--across", "1", "2 to 64"),
        ("--spacing", "nan", "metres"),
        ("--spacing", "0.006", "whole number of it"),
        ("--spacing", "1e-6", "metres"),
        ("--end-time", "0", "seconds"),
        ("--radius", "5", "thickness of the beam"),
        ("--diffusion", "3", "between 0 and 2"),
        ("--viscosity", "-1", "m2/s"),
        ("--damping", "-1", "0 for none"),
        ("--sound-ratio", "0.5", "usual is 10"),
        ("--cfl", "3", "0.5"),
        ("--threads", "0", "give at least 1"),
    ] {
        let dir = fresh("submerged-beam-cli", "refused");
        let output = execute(BEAM, &dir, &[flag, value]);
        let message = words(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{flag} {value}: {message}");
        assert!(message.starts_with(&format!("error: {flag} is ")), "{flag} {value}: {message}");
        assert!(message.contains(remedy), "{flag} {value}: {message}");
        assert!(output.stdout.is_empty() && !dir.exists(), "{flag} {value} has left something");
    }
}

/// As heavy as water the beam stays straight, in water and without.
#[test]
fn a_beam_that_floats_has_a_reference_without_load() {
    let dir = fresh("submerged-beam-cli", "floating");
    let floating = ["--density", "1000", "--across", "2", "--end-time", "0.05", "--no-fields", "--quiet"];
    let output = execute(BEAM, &dir, &floating);
    assert!(output.status.success(), "{}", words(&output.stderr));
    let summary = Summary::read(dir.join("summary.json")).unwrap();
    assert_eq!(summary.metrics["tip_deflection_dry"].value, 0.0);
}

/// The search for the reference comes after the run and may take longer: what was computed is there before, and it can be ended.
#[test]
fn the_run_is_kept_while_its_reference_is_looked_for() {
    let dir = fresh("submerged-beam-cli", "reference");
    let mut command = std::process::Command::new(BEAM);
    // A coarse tank for a moment, and a beam whose rest takes seconds to find.
    command.args([
        "--across",
        "8",
        "--spacing",
        "0.01",
        "--end-time",
        "1e-6",
        "--no-fields",
        "--quiet",
        "--out",
    ]);
    let child = command.arg(&dir).stderr(std::process::Stdio::piped()).spawn().unwrap();
    let begun = std::time::Instant::now();
    let before = loop {
        if let Ok(summary) = Summary::read(dir.join("summary.json")) {
            break summary;
        }
        assert!(begun.elapsed().as_secs() < 100, "no summary");
        std::thread::sleep(std::time::Duration::from_millis(5));
    };
    std::fs::write(dir.join("stop"), "").unwrap();
    let output = child.wait_with_output().unwrap();
    let said = words(&output.stderr);
    let noted = |summary: &Summary, words: &str| summary.notes.iter().any(|note| note.contains(words));
    assert!(before.status == "completed" && before.metrics.contains_key("lift"), "{before:?}");
    assert!(noted(&before, "tip_deflection_dry: the program was ended before"), "{:?}", before.notes);
    assert!(!output.status.success() && said.contains("the run is completed and kept"), "{said}");
    let after = Summary::read(dir.join("summary.json")).unwrap();
    assert!(noted(&after, "tip_deflection_dry: stopped by the file"), "{:?}", after.notes);
}

/// Twice, with other threads, with and without pictures: the same to the last bit.
#[test]
fn a_run_leaves_its_results_and_does_not_depend_on_the_threads() {
    let short = ["--across", "2", "--end-time", "0.1", "--quiet"];
    let run = |name: &str, more: &[&str]| {
        let dir = fresh("submerged-beam-cli", name);
        let output = execute(BEAM, &dir, &[&short, more].concat());
        assert!(output.status.success(), "{}", words(&output.stderr));
        dir
    };
    let (whole, bare) = (run("whole", &["--threads", "1"]), run("bare", &["--threads", "2", "--no-fields"]));
    for file in ["deflection.png", "snapshot.png", "fields/water.pvd", "fields/beam.pvd"] {
        assert!(whole.join(file).exists(), "{file}");
    }
    assert!(!bare.join("fields").exists());
    let read = |dir: &Path| std::fs::read(dir.join("probes.csv")).unwrap();
    assert!(read(&whole) == read(&bare), "threads or watching have changed the run");
    let table = CsvTable::read(whole.join("probes.csv")).unwrap();
    let deflection = table.column("deflection [m]").unwrap();
    assert!(deflection.last().is_some_and(|d| *d > 1e-5), "a light beam rises: {deflection:?}");
    let summary = Summary::read(whole.join("summary.json")).unwrap();
    assert!(summary.metrics["interface_momentum_residual"].value < 1e-12);
}
