//! The programs of the solid: what they write, and what they refuse.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use mps_io::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn fresh(name: &str) -> PathBuf {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join("solid").join(name);
    let _ = std::fs::remove_dir_all(&dir);
    dir
}

fn run(program: &str, out: &Path, arguments: &[&str]) -> Output {
    Command::new(program).args(arguments).arg("--quiet").arg("--out").arg(out).output().unwrap()
}

fn metric(out: &Path, name: &str) -> f64 {
    let summary: Value = std::fs::read_to_string(out.join("summary.json")).unwrap().parse().unwrap();
    summary["metrics"][name]["value"].as_f64().unwrap()
}

#[test]
fn the_cantilever_swings_with_its_period_and_leaves_everything_behind() {
    let out = fresh("cantilever");
    let output = run(env!("CARGO_BIN_EXE_cantilever"), &out, &["--across", "4"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!((metric(&out, "period") / 72.76 - 1.0).abs() < 0.015);
    assert!((metric(&out, "amplitude") / 0.1148 - 1.0).abs() < 0.012);
    assert!(metric(&out, "energy_drift") < 1e-4);
    for file in ["probes.csv", "tip.png", "energy.png", "stress_up.png", "fields", "summary.json"] {
        assert!(out.join(file).exists(), "{file}");
    }
}

#[test]
fn the_flag_hangs_as_far_as_published() {
    let out = fresh("csm1");
    let arguments = ["--test", "csm1", "--across", "4", "--no-fields"];
    let output = run(env!("CARGO_BIN_EXE_flag-structure"), &out, &arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!((metric(&out, "ux") / -7.187e-3 - 1.0).abs() < 0.03);
    assert!((metric(&out, "uy") / -66.10e-3 - 1.0).abs() < 0.016);
}

/// The largest tolerance that is told to be allowed is, and the log is written.
#[test]
fn a_flag_may_hang_roughly_and_is_logged() {
    let out = fresh("csm1-roughly");
    let arguments =
        ["--test", "csm1", "--across", "2", "--tolerance", "0.01", "--no-fields", "--log", "debug"];
    let output = run(env!("CARGO_BIN_EXE_flag-structure"), &out, &arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(metric(&out, "residual") <= 0.01 && metric(&out, "uy") < -0.03);
    let log = std::fs::read_to_string(out.join("run.log")).unwrap();
    assert!(log.contains("completed"), "{log}");
}

#[test]
fn what_cannot_be_run_is_refused_with_the_flag_and_a_remedy() {
    let cases: [(&str, &[&str], &str); 4] = [
        (env!("CARGO_BIN_EXE_cantilever"), &["--across", "1"], "--across"),
        (env!("CARGO_BIN_EXE_cantilever"), &["--periods=-1"], "--periods"),
        (env!("CARGO_BIN_EXE_flag-structure"), &["--test", "csm1", "--across", "0"], "--across"),
        (env!("CARGO_BIN_EXE_flag-structure"), &["--test", "csm1", "--tolerance", "2"], "--tolerance"),
    ];
    for (program, arguments, flag) in cases {
        let out = fresh("refused");
        let output = run(program, &out, arguments);
        let words = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && words.contains(flag), "{arguments:?}: {words}");
        assert!(!out.exists(), "nothing is written before the first step");
    }
}
