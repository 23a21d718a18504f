//! The exact problems of the fluid, the solid and their coupling at their coarsest, with bounds of what they reach there. On request:
//! `cargo test -p mps-examples --test validate_quick -- --ignored`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

use mps_io::Value;
use std::path::Path;
use std::process::Command;

/// Case, metric, resolution, and the largest error: about a third above what is measured.
const BOUNDS: &[(&str, &str, u64, f64)] = &[
    ("couette", "profile at 0.225", 20, 0.003),
    ("couette", "profile at 1", 20, 0.002),
    ("poiseuille", "profile at 0.225", 20, 0.008),
    ("poiseuille", "mean velocity at 1", 20, 0.013),
    ("free-fall", "largest pressure", 10, 1e-9),
    ("sideways", "slope along y", 10, 0.01),
    ("sideways", "slope along x", 10, 0.01),
    ("rotation", "angular momentum, largest change", 10, 1e-12),
    ("rotation", "velocity, L2 error", 10, 0.008),
    ("drop", "period", 15, 0.0027),
    ("drop", "strain rate, largest in the last period", 15, 0.005),
    ("drop", "energy at the end", 15, 0.006),
    ("drop", "momentum", 15, 1e-12),
    ("drop", "angular momentum", 15, 1e-12),
    ("taylor-green", "decay rate", 30, 0.01),
    ("taylor-green", "velocity, largest L2 error", 30, 0.035),
    ("taylor-green", "momentum", 30, 1e-12),
    ("taylor-green-30", "decay rate", 30, 0.01),
    ("taylor-green-30", "velocity, largest L2 error", 30, 0.038),
    ("standing-wave", "period", 32, 0.024),
    ("standing-wave", "decay rate of the energy", 32, 0.045),
    ("standing-wave-50", "period", 32, 0.021),
    ("standing-wave-50", "decay rate of the energy", 32, 0.042),
    ("hydrostatic", "pressure, L2 error", 20, 0.007),
    ("hydrostatic", "level", 20, 0.001),
    ("hydrostatic", "kinetic/potential energy", 20, 5e-6),
    ("resting", "kinetic/potential energy", 10, 1e-6),
    ("hydrostatic-3d", "pressure, L2 error", 8, 0.03),
    ("dam-break-3d", "front, largest difference", 8, 0.035),
    ("dam-break-3d", "energy without a cause", 8, 0.001),
    ("dam-break-3d", "leaked particles", 8, 0.0),
];

/// The same for the solid.
const SOLID: &[(&str, &str, u64, f64)] = &[
    ("rotation", "stress, largest", 10, 1e-12),
    ("patch", "deformation, largest error", 10, 1e-12),
    ("momentum", "momentum, largest change", 10, 1e-12),
    ("momentum", "angular momentum, largest change", 10, 1e-12),
    ("bar", "displacement at L/c", 80, 0.028),
    ("stretch", "stress in the middle, error", 17, 5e-5),
    ("weight", "sag of the end", 4, 0.02),
    ("spin", "angular momentum, largest change", 8, 1e-12),
    ("spin", "energy, largest change", 8, 1e-6),
    ("cantilever", "period", 5, 0.008),
    ("cantilever", "amplitude", 5, 0.006),
    ("cantilever", "energy, largest change", 5, 1e-4),
    ("csm1", "ux", 4, 0.03),
    ("csm1", "uy", 4, 0.016),
    ("csm3", "uy, mean", 4, 0.013),
    ("csm3", "uy, amplitude", 4, 0.022),
    ("csm3", "uy, frequency", 4, 0.003),
];

/// The same for both together.
const COUPLING: &[(&str, &str, u64, f64)] = &[
    ("exchange", "action and reaction", 4, 1e-12),
    ("exchange", "momentum, largest change", 4, 1e-12),
    ("exchange", "angular momentum, largest change", 4, 1e-6),
    ("exchange", "energy, largest change", 4, 0.004),
    ("exchange", "books, momentum", 4, 1e-12),
    ("exchange", "books, angular momentum", 4, 1e-12),
    ("added-mass", "frequency", 10, 0.001),
    ("waving-plate", "frequency", 20, 0.025),
    ("waving-plate", "decay", 20, 0.73),
    ("plate", "over the same solid without water", 4, 0.007),
    ("square-plate", "over the same solid without water", 2, 0.0075),
    ("submerged-beam", "deflection of the end", 4, 0.04),
    ("submerged-beam", "over the same solid without water", 4, 0.017),
    ("submerged-beam", "lift", 4, 0.023),
];

fn stays_within(phase: &str, bounds: &[(&str, &str, u64, f64)], pictures: &[&str], heading: &str) {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join("validate-quick").join(phase);
    let _ = std::fs::remove_dir_all(&dir);
    let status = Command::new(env!("CARGO_BIN_EXE_validate"))
        .args([phase, "--quick", "--quiet", "--out"])
        .arg(&dir)
        .status()
        .unwrap();
    assert!(status.success());

    let table: Value = std::fs::read_to_string(dir.join("validation.json")).unwrap().parse().unwrap();
    let rows = table["rows"].as_array().unwrap();
    assert!(rows.iter().all(|row| row["failure"].is_null()), "every run reaches its end");
    for &(case, metric, resolution, bound) in bounds {
        let row = rows
            .iter()
            .find(|row| row["case"] == case && row["metric"] == metric && row["resolution"] == resolution)
            .unwrap_or_else(|| panic!("no row for {case}, {metric} at {resolution}"));
        let error = row["error"].as_f64().unwrap_or(f64::NAN);
        assert!(error.abs() <= bound, "{case}, {metric} at {resolution}: error {error:e}, allowed {bound:e}");
    }
    for picture in pictures {
        assert!(dir.join(picture).is_file(), "{picture}");
    }
    let text = std::fs::read_to_string(dir.join("validation.md")).unwrap();
    assert!(text.contains(heading), "the same as tables");
}

#[test]
#[ignore = "takes about a minute"]
fn the_exact_problems_of_the_fluid_stay_as_good_as_they_are() {
    let pictures = ["couette-profiles.png", "taylor-green-decay.png", "standing-wave-mode.png"];
    stays_within("fluid", BOUNDS, &pictures, "## taylor-green");
}

#[test]
#[ignore = "takes a quarter of a minute"]
fn the_exact_problems_of_the_solid_stay_as_good_as_they_are() {
    stays_within("solid", SOLID, &[], "## cantilever");
}

#[test]
#[ignore = "takes half a minute"]
fn the_exact_problems_of_the_coupling_stay_as_good_as_they_are() {
    stays_within("coupling", COUPLING, &["submerged-beam-deflection.png"], "## added-mass");
}

/// Parts share no directory unless one is given, and the coarsest resolution is the least that can be asked for.
#[test]
fn every_part_has_its_directory_and_a_resolution_to_run() {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("validate-quick").join("default");
    let _ = std::fs::remove_dir_all(&root);
    std::fs::create_dir_all(&root).unwrap();
    let run = |arguments: &[&str]| {
        Command::new(env!("CARGO_BIN_EXE_validate")).current_dir(&root).args(arguments).output().unwrap()
    };
    let refused = run(&["solid", "--only", "rotation", "--finest", "1"]);
    let words = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert_eq!(refused.status.code(), Some(1), "{words}");
    assert!(words.contains("--finest is 1: the coarsest run of these cases has "), "{words}");
    assert!(!root.join("out").exists(), "nothing is written");
    for (part, case) in [("solid", "rotation"), ("fluid", "free-fall")] {
        let output = run(&[part, "--quick", "--quiet", "--only", case]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
    for (part, case) in [("solid", "rotation"), ("fluid", "free-fall")] {
        let text =
            std::fs::read_to_string(root.join("out/validate").join(part).join("validation.md")).unwrap();
        assert!(text.contains(&format!("## {case}")), "{text}");
    }
}

#[test]
fn an_unknown_case_is_refused_with_the_names_of_the_known() {
    let output =
        Command::new(env!("CARGO_BIN_EXE_validate")).args(["fluid", "--only", "flood"]).output().unwrap();
    assert!(!output.status.success());
    let words = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(words.contains("flood") && words.contains("hydrostatic"), "{words}");
}
