//! The command line of the channel of Turek and Hron: what it refuses, and what a run leaves behind.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{execute, words};
use mps_io::{CsvTable, Summary};
use std::path::{Path, PathBuf};
use std::process::Output;

fn fresh(name: &str) -> PathBuf {
    common::fresh("turek-hron-cli", name)
}

fn channel(out: &Path, arguments: &[&str]) -> Output {
    execute(env!("CARGO_BIN_EXE_turek-hron"), out, arguments)
}

#[test]
fn what_cannot_be_run_is_refused_with_the_flag_and_a_remedy() {
    for (flag, value, remedy) in [
        ("--spacing", "nan", "metres"),
        ("--spacing", "-1", "metres"),
        ("--spacing", "0.006", "whole numbers of it"),
        ("--spacing", "1e-6", "give at least"),
        ("--end-time", "0", "seconds"),
        ("--end-time", "nan", "seconds"),
        ("--length", "0.7", "the wake needs room"),
        ("--length", "inf", "the wake needs room"),
        ("--cfl", "0", "0.5"),
        ("--sound-ratio", "0.5", "usual is 10"),
        ("--radius", "2", "3 to 6"),
        ("--level", "-1", "tears"),
        ("--across", "1", "2 to 200"),
        ("--threads", "0", "give at least 1"),
    ] {
        let dir = fresh("refused");
        let output = channel(&dir, &[flag, value]);
        let message = words(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{flag} {value}: {message}");
        assert!(message.starts_with(&format!("error: {flag} is ")), "{flag} {value}: {message}");
        assert!(message.contains(remedy), "{flag} {value}: {message}");
        assert!(output.stdout.is_empty() && !dir.exists(), "{flag} {value} has left something");
    }
}

/// Fluid that comes up to speed, with an elastic flag: twice, with other threads, the same to the last bit.
#[test]
fn a_run_leaves_its_results_and_does_not_depend_on_the_threads() {
    let short = [
        "--test",
        "fsi3",
        "--spacing",
        "0.01",
        "--length",
        "1",
        "--radius",
        "3",
        "--end-time",
        "0.05",
        "--quiet",
    ];
    let probes = |name: &str, more: &[&str]| {
        let dir = fresh(name);
        let output = channel(&dir, &[&short, more].concat());
        assert!(output.status.success(), "{}", words(&output.stderr));
        dir
    };
    let (whole, bare) =
        (probes("whole", &["--threads", "1"]), probes("bare", &["--threads", "2", "--no-fields"]));
    for file in
        ["drag.png", "lift.png", "ux.png", "uy.png", "film.png", "fields/water.pvd", "fields/flag.pvd"]
    {
        assert!(whole.join(file).exists(), "{file}");
    }
    assert!(!bare.join("fields").exists());
    let read = |dir: &Path| std::fs::read(dir.join("probes.csv")).unwrap();
    assert!(read(&whole) == read(&bare), "threads or watching have changed the run");
    let table = CsvTable::read(whole.join("probes.csv")).unwrap();
    let (time, speed) = (table.column("time [s]").unwrap(), table.column("largest speed [m/s]").unwrap());
    assert!(time.len() > 40 && time[time.len() - 1] >= 0.05, "{time:?}");
    // The lattice cut by the cylinder settles with a jolt; the inflow will have 2 m/s.
    assert!(speed.iter().all(|speed| *speed < 1.0), "a start from rest: {speed:?}");
    // Hardly anything flows yet. The level of the pressure, 2 rho u^2, pushes the end of the flag, 0.02 m wide, which the cylinder bears
    // from the other side: drag, which is that of both, does not contain it.
    let (drag, flag) =
        (table.column("drag [N/m]").unwrap(), table.column("impulse on flag x [N s/m]").unwrap());
    let both: f64 = time.windows(2).zip(&drag[1..]).map(|(t, drag)| drag * (t[1] - t[0])).sum();
    let (flag, by_level) = (flag[flag.len() - 1], -2.0 * 1000.0 * 2.0 * 2.0 * 0.02 * 0.05);
    assert!((flag / by_level - 1.0).abs() < 0.3, "{flag} N s/m on the flag, {by_level} by the level");
    assert!(both.abs() < 0.1 * flag.abs(), "{both} N s/m on both, {flag} on the flag");
    let summary = Summary::read(whole.join("summary.json")).unwrap();
    assert!(summary.metrics["interface_momentum_residual"].value < 1e-12);
}
