//! The program `exact`: one exact problem, its flags reach the numerics, and its summary has what `trade` reads.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{fresh, words};
use mps_io::Summary;
use std::path::Path;
use std::process::{Command, Output};

fn exact(dir: &Path, arguments: &[&str]) -> Output {
    let shared = ["--threads=1", "--quiet", "--no-fields", "--out"];
    Command::new(env!("CARGO_BIN_EXE_exact")).args(arguments).args(shared).arg(dir).output().unwrap()
}

fn summary(name: &str, arguments: &[&str]) -> Summary {
    let dir = fresh("exact", name);
    let output = exact(&dir, arguments);
    assert!(output.status.success(), "{}", words(&output.stderr));
    Summary::read(dir.join("summary.json")).unwrap()
}

fn error(summary: &Summary, metric: &str) -> f64 {
    summary.metrics[metric].error.unwrap().abs()
}

#[test]
fn a_summary_has_errors_and_cost() {
    let dir = fresh("exact", "channel");
    assert!(exact(&dir, &["--problem=poiseuille", "--resolution=10"]).status.success());
    let summary = Summary::read(dir.join("summary.json")).unwrap();
    assert_eq!((summary.status.as_str(), summary.particles["fluid"]), ("completed", 100));
    assert!(summary.steps > 100 && summary.metrics.contains_key("particle_steps_per_second"));
    // What `validate` finds at this resolution (docs/validation.md), within a third.
    assert!((0.0098..0.0196).contains(&error(&summary, "mean velocity at 1")));
    assert!((0.0033..0.0066).contains(&error(&summary, "profile at 0.225")));
    assert!(dir.join("poiseuille-profiles.png").is_file());
}

/// Every flag makes another run of the same problem.
#[test]
fn every_flag_reaches_the_numerics() {
    let base = ["--problem=poiseuille", "--resolution=8"];
    let own = summary("own", &base);
    let flags = [
        "--weight=rational",
        "--radius=3.5",
        "--sound-ratio=8",
        "--cfl=0.4",
        "--diffusion=0.2",
        "--shifting=1",
        "--shifting-strength=3",
        "--dpc",
        "--plain",
        "--viscosity=compact",
        "--precision=f32",
    ];
    for (k, flag) in flags.iter().enumerate() {
        let changed = summary(&format!("flag-{k}"), &[base[0], base[1], flag]);
        assert_ne!(own.metrics["profile at 1"].value, changed.metrics["profile at 1"].value, "{flag}");
    }
    // It is corrected anyhow.
    let corrected = summary("corrected", &[base[0], base[1], "--corrected"]);
    assert_eq!(own.metrics["profile at 1"].value, corrected.metrics["profile at 1"].value);
}

/// Pictures of another problem would be taken for results of the summary beside them.
#[test]
fn what_an_earlier_run_has_left_is_not_beside_the_new_one() {
    let dir = fresh("exact", "leftovers");
    std::fs::create_dir_all(&dir).unwrap();
    for file in ["standing-wave-mode.png", "photo.png"] {
        std::fs::write(dir.join(file), "earlier").unwrap();
    }
    let output = exact(&dir, &["--problem=poiseuille", "--resolution=8"]);
    assert!(output.status.success(), "{}", words(&output.stderr));
    assert!(!dir.join("standing-wave-mode.png").exists() && dir.join("photo.png").exists());
}

#[test]
fn mistakes_are_told() {
    let dir = fresh("exact", "refused");
    for (arguments, message) in [
        (["--problem=flood", "--resolution=10"], "--problem is flood: give one of poiseuille, drop"),
        (
            ["--problem=standing-wave", "--resolution=25"],
            "--resolution is 25: the tank is half as deep as long",
        ),
        (["--problem=drop", "--resolution=2"], "--resolution is 2"),
        (["--problem=drop", "--radius=5"], "--resolution"),
    ] {
        let output = exact(&dir, &arguments);
        let said = words(&output.stderr);
        assert!(!output.status.success() && said.contains(message), "{message}: {said}");
    }
}
