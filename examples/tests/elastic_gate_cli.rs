//! The command line of the elastic gate: what it refuses, and what a run leaves behind.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{execute, words};
use mps_io::{CsvTable, Summary};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn fresh(name: &str) -> PathBuf {
    common::fresh("elastic-gate-cli", name)
}

fn gate(out: &Path, arguments: &[&str]) -> Output {
    execute(env!("CARGO_BIN_EXE_elastic-gate"), out, arguments)
}

/// A run of the coarsest gate that must succeed.
fn run(out: &Path, arguments: &[&str]) -> Output {
    let output = gate(out, &[&["--spacing", "2.5e-3"], arguments].concat());
    assert!(output.status.success(), "{arguments:?}: {}", words(&output.stderr));
    output
}

#[test]
fn what_cannot_be_run_is_refused_with_the_flag_and_a_remedy() {
    for (flag, value, remedy) in [
        ("--spacing", "-1", "metres"),
        ("--spacing", "0", "metres"),
        ("--spacing", "nan", "metres"),
        ("--spacing", "inf", "metres"),
        ("--spacing", "5e-3", "give at most 2.5e-3 m"),
        ("--spacing", "1e-9", "give at least"),
        ("--spacing", "1.8e-3", "the nearest are 1.786e-3 and 1.818e-3"),
        ("--end-time", "0", "seconds"),
        ("--end-time", "-0.1", "seconds"),
        ("--end-time", "nan", "seconds"),
        ("--end-time", "inf", "seconds"),
        ("--end-time", "100", "at most 10 s"),
        ("--threads", "0", "give at least 1"),
        ("--threads", "100000", "at most 1024"),
        ("--across", "1", "at least 2"),
        ("--across", "100000", "at most 200"),
        ("--cfl", "0", "0.5"),
        ("--cfl", "3", "0.5"),
        ("--cfl", "nan", "0.5"),
        ("--sound-ratio", "0.5", "usual is 10"),
        ("--sound-ratio", "nan", "usual is 10"),
        ("--alpha", "-0.1", "0.02"),
        ("--alpha", "nan", "0.02"),
        ("--shifting", "101", "usual is 5"),
        ("--beside", "nowhere", "an earlier run"),
    ] {
        let dir = fresh("refused");
        let output = gate(&dir, &[flag, value]);
        let message = words(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{flag} {value}: {message}");
        assert!(message.starts_with(&format!("error: {flag} is ")), "{flag} {value}: {message}");
        assert!(message.contains(remedy), "{flag} {value}: {message}");
        assert_eq!(message.lines().count(), 1, "{flag} {value}: {message}");
        assert!(output.stdout.is_empty() && !dir.exists(), "{flag} {value} has left something");
    }
}

#[test]
fn what_is_no_value_of_a_flag_is_refused_with_those_that_are() {
    for (arguments, words_of_help) in [
        (&["--material", "steel"][..], "e7.8-nu47"),
        (&["--precision", "f16"], "f32, f64"),
        (&["--spacing", "wide"], "--spacing"),
        (&["--threads", "-1"], "--threads"),
        (&["--thread", "1"], "--threads"),
        (&["--spacing"], "--spacing"),
    ] {
        let dir = fresh("misread");
        let output = gate(&dir, arguments);
        let message = words(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        assert!(message.contains(words_of_help), "{arguments:?}: {message}");
        assert!(!dir.exists(), "{arguments:?} has left something");
    }
}

#[test]
fn a_directory_that_cannot_be_made_is_refused_before_the_first_step() {
    let dir = fresh("blocked");
    std::fs::create_dir_all(&dir).unwrap();
    let file = dir.join("file");
    std::fs::write(&file, "in the way").unwrap();
    for out in [file.clone(), file.join("below")] {
        let output = gate(&out, &["--spacing", "2.5e-3"]);
        let message = words(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(message.contains(out.to_str().unwrap()) && message.contains("hoose another"), "{message}");
        assert_eq!(std::fs::read_to_string(&file).unwrap(), "in the way");
    }
}

#[test]
fn help_names_every_flag() {
    let output = Command::new(env!("CARGO_BIN_EXE_elastic-gate")).arg("--help").output().unwrap();
    let help = words(&output.stdout);
    for flag in [
        "--spacing",
        "--end-time",
        "--material",
        "--across",
        "--sound-ratio",
        "--cfl",
        "--alpha",
        "--shifting",
        "--corrected",
        "--beside",
        "--threads",
        "--precision",
        "--out",
        "--no-fields",
        "--quiet",
        "--help",
        "--version",
    ] {
        assert!(help.contains(flag), "{flag} is missing in:\n{help}");
    }
    assert_eq!(output.status.code(), Some(0));
}

#[test]
fn a_run_leaves_tables_pictures_fields_and_a_summary() {
    let dir = fresh("all");
    let output = run(&dir, &["--end-time", "0.002"]);
    assert!(words(&output.stdout).contains("energy_rise"), "the closing words name the results");

    for file in [
        "probes.csv",
        "gate.png",
        "film.png",
        "snapshot_000ms.png",
        "snapshot_002ms.png",
        "summary.json",
        "fields/water.pvd",
        "fields/water_00000.vtu",
        "fields/gate.pvd",
        "fields/gate_00000.vtu",
        "fields/walls.pvd",
    ] {
        let path = dir.join(file);
        assert!(std::fs::metadata(&path).is_ok_and(|data| data.len() > 0), "{file} is missing or empty");
    }

    let summary = Summary::read(dir.join("summary.json")).unwrap();
    assert_eq!(summary.status, "completed");
    for name in [
        "interface_momentum_residual",
        "leaked_particles",
        "energy_rise",
        "wall_seconds_per_simulated_second",
        "particle_steps_per_second",
    ] {
        let metric = summary.metrics.get(name).unwrap_or_else(|| panic!("no {name}"));
        assert!(metric.value.is_finite() && metric.value >= 0.0, "{name} is {}", metric.value);
    }
    // Nothing is claimed of a gate that is still opening, and nothing of points of the experiment that were not reached.
    for name in ["gate_x_max", "gate_y_max", "gate_x_max_time", "gate_x_rms_experiment"] {
        assert!(!summary.metrics.contains_key(name), "{name} after 2 ms");
        assert!(summary.notes.iter().any(|note| note.starts_with(name)), "{name}: {:?}", summary.notes);
    }
    assert_eq!(summary.particles["fluid"], 40 * 56);
    assert!(summary.steps > 0 && summary.particles["wall"] > 0 && summary.particles["structure"] > 0);

    let probes = CsvTable::read(dir.join("probes.csv")).unwrap();
    let time = probes.column("time [s]").unwrap();
    assert_eq!(time.first(), Some(&0.0));
    let last = *time.last().unwrap();
    assert!((0.002 * (1.0 - 1e-6)..0.0022).contains(&last), "the run ends with a whole step, at {last} s");
}

#[test]
fn quiet_prints_nothing_and_without_fields_there_are_none() {
    let dir = fresh("quiet");
    let output = run(&dir, &["--end-time", "0.002", "--quiet", "--no-fields"]);
    assert_eq!((words(&output.stdout), words(&output.stderr)), (String::new(), String::new()));
    let mut left: Vec<_> = std::fs::read_dir(&dir)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    left.sort_unstable();
    assert_eq!(left, ["gate.png", "probes.csv", "run.log", "summary.json"]);
}

#[test]
fn the_curve_of_an_earlier_run_is_drawn_beside_and_shifting_changes_the_run() {
    let short = ["--end-time", "0.004", "--no-fields", "--quiet"];
    let plain = fresh("plain");
    run(&plain, &short);
    let shifted = fresh("shifted");
    run(&shifted, &[&short[..], &["--shifting", "2", "--beside", plain.to_str().unwrap()]].concat());
    let file = |dir: &std::path::Path, name: &str| std::fs::read(dir.join(name)).unwrap();
    assert_ne!(file(&plain, "probes.csv"), file(&shifted, "probes.csv"));
    let alone = fresh("shifted-alone");
    run(&alone, &[&short[..], &["--shifting", "2"]].concat());
    assert_eq!(file(&alone, "probes.csv"), file(&shifted, "probes.csv"));
    assert_ne!(file(&alone, "gate.png"), file(&shifted, "gate.png"), "no further curve");
}

/// Fields once asked for neighbours before the first step had found any.
#[test]
fn watching_and_threads_do_not_change_a_bit_of_the_run() {
    let probes = |name: &str, arguments: &[&str]| {
        let dir = fresh(name);
        run(&dir, &[&["--end-time", "0.004", "--quiet"], arguments].concat());
        std::fs::read_to_string(dir.join("probes.csv")).unwrap()
    };
    let alone = probes("unwatched", &["--no-fields", "--threads", "1"]);
    assert!(alone.lines().count() > 5);
    assert!(alone == probes("watched", &["--threads", "1"]), "fields and pictures have changed the run");
    assert!(alone == probes("threads", &["--no-fields", "--threads", "3"]), "threads have changed the run");
}

#[test]
fn single_precision_agrees_with_double() {
    let run_in = |precision: &str| {
        let dir = fresh(precision);
        run(&dir, &["--end-time", "0.01", "--no-fields", "--quiet", "--precision", precision]);
        let summary = Summary::read(dir.join("summary.json")).unwrap();
        (summary.precision, CsvTable::read(dir.join("probes.csv")).unwrap())
    };
    let (single, double) = (run_in("f32"), run_in("f64"));
    assert_eq!((single.0.as_str(), double.0.as_str()), ("f32", "f64"));
    for name in ["gate corner x [m]", "gate corner y [m]"] {
        let [s, d] = [&single, &double].map(|(_, table)| *table.column(name).unwrap().last().unwrap());
        assert!(d > 0.0 && (s - d).abs() <= 0.01 * d, "{name}: {s:e} m in f32, {d:e} m in f64");
    }
}
