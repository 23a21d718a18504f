//! The command line of the dam break: what it refuses, and what a run leaves behind.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{execute, words};
use mps_io::{CsvTable, Summary};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn fresh(name: &str) -> PathBuf {
    common::fresh("dam-break-cli", name)
}

fn dam(out: &Path, arguments: &[&str]) -> Output {
    execute(env!("CARGO_BIN_EXE_dam-break"), out, arguments)
}

/// A run of the coarsest column that must succeed.
fn run(out: &Path, arguments: &[&str]) -> Output {
    let output = dam(out, &[&["--spacing", "0.03"], arguments].concat());
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
        ("--spacing", "0.05", "give at most 3e-2 m"),
        ("--spacing", "1e-9", "give at least"),
        ("--spacing", "0.0225", "the nearest are 2.222e-2 and 2.308e-2"),
        ("--radius", "1", "e.g. 4"),
        ("--radius", "nan", "e.g. 4"),
        ("--end-time", "0", "seconds"),
        ("--end-time", "-0.1", "seconds"),
        ("--end-time", "nan", "seconds"),
        ("--end-time", "1e3", "at most 60 s"),
        ("--threads", "0", "give at least 1"),
        ("--threads", "100000", "at most 1024"),
        ("--cfl", "0", "0.5"),
        ("--cfl", "3", "0.5"),
        ("--cfl", "nan", "0.5"),
        ("--sound-ratio", "0.5", "usual is 10"),
        ("--sound-ratio", "inf", "usual is 10"),
        ("--diffusion", "-0.1", "0.5"),
        ("--diffusion", "nan", "0.5"),
        ("--alpha", "-0.1", "0.02"),
        ("--alpha", "nan", "0.02"),
        ("--shifting", "101", "usual is 5"),
    ] {
        let dir = fresh("refused");
        let output = dam(&dir, &[flag, value]);
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
        (&["--release", "slow"][..], "instant, lifted"),
        (&["--weight", "gaussian"], "smooth, rational"),
        (&["--precision", "f16"], "f32, f64"),
        (&["--shifting", "-1"], "--shifting"),
        (&["--no-dcp"], "--no-dpc"),
        (&["--spacing"], "--spacing"),
    ] {
        let dir = fresh("misread");
        let output = dam(&dir, arguments);
        let message = words(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        assert!(message.contains(words_of_help), "{arguments:?}: {message}");
        assert!(!dir.exists(), "{arguments:?} has left something");
    }
}

#[test]
fn help_names_every_flag() {
    let output = Command::new(env!("CARGO_BIN_EXE_dam-break")).arg("--help").output().unwrap();
    let help = words(&output.stdout);
    for flag in [
        "--spacing",
        "--end-time",
        "--release",
        "--walls",
        "--preset",
        "--sound-ratio",
        "--cfl",
        "--diffusion",
        "--alpha",
        "--keep-tension",
        "--no-dpc",
        "--shifting",
        "--corrected",
        "--weight",
        "--radius",
        "--hydrostatic-diffusion",
        "--no-books",
        "--stabilisers",
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
    let output = run(&dir, &["--end-time", "0.01"]);
    assert!(words(&output.stdout).contains("energy_closure"), "the closing words name the results");

    for file in [
        "probes.csv",
        "energy.png",
        "front.png",
        "pressure_1.png",
        "pressure_2.png",
        "pressure_3.png",
        "pressure_4.png",
        "film.png",
        "snapshot_t0.0.png",
        "summary.json",
        "fields/water.pvd",
        "fields/water_00000.vtu",
        "fields/walls.pvd",
    ] {
        let path = dir.join(file);
        assert!(std::fs::metadata(&path).is_ok_and(|data| data.len() > 0), "{file} is missing or empty");
    }

    let summary = Summary::read(dir.join("summary.json")).unwrap();
    assert_eq!(summary.status, "completed");
    for name in [
        "energy_closure",
        "energy_dissipated",
        "volume_drift",
        "leaked_particles",
        "wall_seconds_per_simulated_second",
        "particle_steps_per_second",
    ] {
        let metric = summary.metrics.get(name).unwrap_or_else(|| panic!("no {name}"));
        assert!(metric.value.is_finite(), "{name} is {}", metric.value);
    }
    // Nothing is claimed about an impact the run has not come to.
    for name in ["arrival_sensor1", "peak_sensor1", "band_fraction_sensor4", "front_rms", "pressure_noise"] {
        assert!(!summary.metrics.contains_key(name), "{name} after 10 ms");
        assert!(summary.notes.iter().any(|note| note.starts_with(name)), "{name}: {:?}", summary.notes);
    }
    assert_eq!(summary.particles["fluid"], 40 * 20);
    assert!(summary.steps > 0 && summary.particles["wall"] > 0);

    let probes = CsvTable::read(dir.join("probes.csv")).unwrap();
    let time = probes.column("time [s]").unwrap();
    assert_eq!(time.first(), Some(&0.0));
    assert!(*time.last().unwrap() >= 0.01 * (1.0 - 1e-6));
    let level = probes.column("level 1 h/H [-]").unwrap();
    assert!((level[0] - 1.0).abs() < 1e-6, "the column is {} H high", level[0]);
}

#[test]
fn quiet_prints_nothing_and_without_fields_there_are_none() {
    let dir = fresh("quiet");
    let output = run(&dir, &["--end-time", "0.005", "--quiet", "--no-fields"]);
    assert_eq!((words(&output.stdout), words(&output.stderr)), (String::new(), String::new()));
    let mut left: Vec<_> = std::fs::read_dir(&dir)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    left.sort_unstable();
    let plots =
        ["energy.png", "front.png", "pressure_1.png", "pressure_2.png", "pressure_3.png", "pressure_4.png"];
    assert_eq!(left, [&plots[..], &["probes.csv", "run.log", "summary.json"]].concat());
}

/// What was not asked for is not said to lie behind the end of the run.
#[test]
fn results_of_books_that_are_switched_off_are_told_so() {
    let dir = fresh("no-books");
    run(&dir, &["--end-time", "0.005", "--quiet", "--no-fields", "--no-books"]);
    let summary = Summary::read(dir.join("summary.json")).unwrap();
    for name in ["energy_closure", "energy_by_viscosity", "energy_by_walls"] {
        assert!(!summary.metrics.contains_key(name));
        let note = format!("{name}: switched off by --no-books");
        assert!(summary.notes.contains(&note), "{:?}", summary.notes);
    }
    assert!(summary.notes.contains(&"front_rms: the run ended before".to_owned()), "{:?}", summary.notes);
}

#[test]
fn watching_and_threads_do_not_change_a_bit_of_the_run() {
    let probes = |name: &str, arguments: &[&str]| {
        let dir = fresh(name);
        run(&dir, &[&["--end-time", "0.05", "--release", "lifted", "--quiet"], arguments].concat());
        std::fs::read_to_string(dir.join("probes.csv")).unwrap()
    };
    let alone = probes("unwatched", &["--no-fields", "--threads", "1"]);
    assert!(alone.lines().count() > 50);
    assert!(alone == probes("watched", &["--threads", "1"]), "fields and pictures have changed the run");
    assert!(alone == probes("threads", &["--no-fields", "--threads", "3"]), "threads have changed the run");
}

#[test]
fn single_precision_agrees_with_double() {
    let front = |precision: &str| {
        let dir = fresh(precision);
        run(&dir, &["--end-time", "0.2", "--no-fields", "--quiet", "--precision", precision]);
        assert_eq!(Summary::read(dir.join("summary.json")).unwrap().precision, precision);
        let probes = CsvTable::read(dir.join("probes.csv")).unwrap();
        *probes.column("front x/H [-]").unwrap().last().unwrap()
    };
    let (single, double) = (front("f32"), front("f64"));
    assert!(double > 0.3 && (single - double).abs() < 0.01, "{single} H in f32, {double} H in f64");
}

#[test]
fn the_table_of_stabilisers_has_a_row_for_each() {
    let dir = fresh("stabilisers");
    run(&dir, &["--stabilisers", "--end-time", "0.02", "--quiet"]);
    let table = std::fs::read_to_string(dir.join("stabilisers.md")).unwrap();
    for name in [
        "as given",
        "no density diffusion",
        "hydrostatic diffusion",
        "no collisions",
        "shifting, k = 5",
        "f32",
    ] {
        let row = table.lines().find(|line| line.starts_with(&format!("| {name} |"))).unwrap();
        // What a run this short has not reached is left open.
        assert!(row.contains("| - |") && !row.contains("failed"), "{row}");
    }
    assert!(dir.join("no-collisions/summary.json").is_file());
}
