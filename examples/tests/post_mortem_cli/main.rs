//! Runs that fail: what they leave behind names the particle and goes through the failure again, and some are passed with shorter steps.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod bodies;
#[path = "../common/mod.rs"]
mod common;
mod retry;

use common::{execute, fresh, words};
use mps_io::checkpoint::Rotation;
use mps_io::{CsvTable, Summary};
use mps_kernel::Section;
use std::path::{Path, PathBuf};
use std::process::Command;

const MPS: &str = env!("CARGO_BIN_EXE_mps");

/// Water that is let go in a tank, computed like this, with more of the scene behind it.
fn water(name: &str, numerics: &str, more: &str) -> PathBuf {
    let text = format!(
        r#"title = "Water that is let go"
end_time = 0.5
gravity = [0.0, -9.81]

[fluid]
spacing = 1e-2
expected_speed = 1.4
numerics = {{ {numerics} }}

[[fluid.bodies]]
region = {{ box = {{ lower = [0.0, 0.0], upper = [0.2, 0.1] }} }}
pressure = "released_column"

[[walls]]
name = "tank"
shape = {{ line = [[0.0, 0.4], [0.0, 0.0], [0.4, 0.0], [0.4, 0.4]] }}
fineness = 0.5

[output]
probe_interval = 1e-3
{more}"#
    );
    file(name, &text)
}

/// Corrected sums do not stand a free surface, and without collisions nothing keeps particles apart.
fn unstable(cfl: &str) -> String {
    format!(
        r#"cfl = {cfl}, weight = "rational", radius = 3.0, collisions = false, pressure_form = "corrected""#
    )
}

/// The usual numerics.
const CALM: &str = "cfl = 0.5";

/// The water reaches the right end of it after 0.16 s.
const REGION: &str = "[watch]\nregion = { lower = [-0.1, -0.1], upper = [0.35, 0.5] }\nsteps = 20\n";

fn file(name: &str, text: &str) -> PathBuf {
    let dir = fresh("post-mortem-scenes", name);
    std::fs::create_dir_all(&dir).unwrap();
    let file = dir.join("scene.toml");
    std::fs::write(&file, text).unwrap();
    file
}

/// Runs a scene that is to fail; its directory and what it says.
fn broken(name: &str, scene: &Path, flags: &[&str]) -> (PathBuf, String) {
    let dir = fresh("post-mortem", name);
    let run = ["run", scene.to_str().unwrap(), "--quiet", "--threads", "1"];
    let output = execute(MPS, &dir, &[&run, flags].concat());
    let said = words(&output.stderr);
    assert!(!output.status.success(), "{name} did not fail");
    assert!(
        said.contains(&format!("`mps resume {}/post-mortem` goes through", dir.display())),
        "{name}: {said}"
    );
    (dir, said)
}

/// The first number behind these words.
fn number_behind(said: &str, words: &str) -> String {
    said.split(words).nth(1).unwrap().chars().take_while(char::is_ascii_digit).collect()
}

fn report(dir: &Path) -> String {
    std::fs::read_to_string(dir.join("post-mortem/report.md")).unwrap()
}

/// The line of what a run says that tells the failure, with every digit.
fn failure(said: &str) -> String {
    said.lines().find(|line| line.starts_with("error: ")).unwrap().to_owned()
}

/// What the checkpoint of a run says of its course.
fn state(dir: &Path) -> Vec<Section> {
    let (checkpoint, _) = Rotation::new(dir.join("checkpoint")).read().unwrap();
    let of_the_course = |name: &str| ["wet/", "dry/", "watch/"].iter().any(|part| name.starts_with(part));
    checkpoint.state.sections().iter().filter(|section| of_the_course(&section.name)).cloned().collect()
}

/// The failure of a run comes again from its post-mortem with every bit: the same words, the same last steps and terms, the same rows.
fn comes_again(dir: &Path, said: &str) {
    let apart = dir.join("post-mortem");
    // A repetition that goes back as well writes a checkpoint there.
    let begins = state(&apart);
    let output =
        Command::new(MPS).arg("resume").arg(&apart).args(["--quiet", "--threads", "2"]).output().unwrap();
    assert!(!output.status.success());
    assert_eq!(failure(&words(&output.stderr)), failure(said));
    assert_eq!(report(&apart), report(dir));
    let [mine, theirs] = [&apart, dir].map(|dir| CsvTable::read(dir.join("probes.csv")).unwrap());
    let last =
        |table: &CsvTable| table.columns.iter().map(|column| column.last().unwrap().to_bits()).collect();
    let [mine, theirs]: [Vec<u64>; 2] = [last(&mine), last(&theirs)];
    assert_eq!(mine, theirs, "the last row");
    // And so does the state it begins with.
    let again = state(&apart.join("post-mortem"));
    let differs = begins.iter().zip(&again).find(|(one, other)| one != other).map(|(one, _)| &one.name);
    assert!(differs.is_none() && begins.len() == again.len(), "{differs:?}");
}

#[test]
fn an_unstable_run_is_examined_and_comes_again() {
    let (dir, said) = broken("unstable", &water("unstable", &unstable("1.2"), ""), &[]);
    let number = number_behind(&said, "because of fluid particle ");
    let report = report(&dir);
    for part in [
        format!("## The particle: fluid particle {number}\n").as_str(),
        &failure(&said)["error: ".len()..],
        "| pressure | ",
        "| pressure of walls | ",
        "| gravity | 0 | -9.8100 | 9.8100 |",
        "| **sum** |",
        "| motion of neighbours | ",
        "| diffusion | ",
        "| collisions [m/s] | ",
        " nearest of ",
        "**acts**",
        "## The last steps",
    ] {
        assert!(report.contains(part), "{part}: {report}");
    }
    let steps =
        report.split("## The last steps").nth(1).unwrap().lines().filter(|line| line.starts_with("| "));
    assert_eq!(steps.count(), 2 + 50, "{report}");
    assert!(dir.join("post-mortem/picture.png").exists());
    let summary = Summary::read(dir.join("summary.json")).unwrap();
    assert!(summary.status.contains("post-mortem/report.md"), "{}", summary.status);
    comes_again(&dir, &said);
    // A run that begins anew has nothing to do with it.
    let scene = water("unstable-not", CALM, "");
    let output = execute(MPS, &dir, &["run", scene.to_str().unwrap(), "--quiet", "--end-time", "0.01"]);
    assert!(output.status.success() && !dir.join("post-mortem").exists(), "{}", words(&output.stderr));
}

/// What is watched for beside errors of the step, each with words of its own.
#[test]
fn alarms_stop_a_run_and_come_again() {
    let rise = "[watch]\nenergy_rise = 0.1\n";
    let slow = "[watch]\nmach = 0.05\non_mach = \"stop\"\n";
    for (name, scene, words) in [
        ("collapsed", water("collapsed", &unstable("1.1"), ""), "of the mean of the last ones"),
        (
            "energy",
            water("energy", &unstable("1.2"), rise),
            "where `watch.energy_rise` of the scene allows 1e-1",
        ),
        (
            "too fast",
            water("too-fast", CALM, slow),
            "where `watch.mach` of the scene allows 0.05: raise the sound speed",
        ),
        ("escaped", water("escaped", CALM, REGION), "has left the region of `watch.region` in step "),
    ] {
        let (dir, said) = broken(name, &scene, &[]);
        assert!(said.contains(words), "{name}: {said}");
        assert!(report(&dir).contains("## The particle: fluid particle "));
        comes_again(&dir, &said);
    }
}

/// A run whose fluid is too fast goes on; log and summary say so, once, also where it has been resumed since.
#[test]
fn fluid_that_is_too_fast_is_told_once() {
    let scene = water("warned", CALM, "[watch]\nmach = 0.05\n");
    let dir = fresh("post-mortem", "warned");
    for arguments in [
        ["run", scene.to_str().unwrap(), "--quiet", "--end-time", "0.1"],
        ["resume", dir.to_str().unwrap(), "--quiet", "--end-time", "0.15"],
    ] {
        let output = if arguments[0] == "run" {
            execute(MPS, &dir, &arguments)
        } else {
            Command::new(MPS).args(arguments).output().unwrap()
        };
        assert!(output.status.success(), "{}", words(&output.stderr));
        let log = std::fs::read_to_string(dir.join("run.log")).unwrap();
        assert_eq!(log.matches("where `watch.mach` of the scene allows 0.05").count(), 1, "{log}");
        let summary = Summary::read(dir.join("summary.json")).unwrap();
        assert_eq!(summary.notes.iter().filter(|note| note.contains("times as fast as sound")).count(), 1);
        let [mach, density] =
            ["largest_mach_number", "largest_density_deviation"].map(|name| summary.metrics[name].value);
        // The front is at 1.4 m/s, a tenth of the speed of sound, before the water hits anything.
        assert!(mach > 0.05 && mach < 0.2 && density > 1e-3 && density < 0.05, "{mach} {density}");
    }
}

const SOFT: &str = r#"title = "A gate that is too soft"
end_time = 0.5
gravity = [0.0, -9.81]

[fluid]
spacing = 5e-3
expected_speed = 1.6

[[fluid.bodies]]
region = { box = { lower = [0.0, 0.0], upper = [0.1, 0.12] } }

[[walls]]
name = "tank"
shape = { line = [[0.0, 0.2], [0.0, 0.0], [0.3, 0.0], [0.3, 0.2]] }
fineness = 0.5

[[solids]]
name = "gate"
region = { box = { lower = [0.1, 0.0], upper = [0.115, 0.16] } }
spacing = 5e-3
density = 1100
material = { saint_venant = { youngs_modulus = 1e4, poissons_ratio = 0.4 } }
clamp = { sides = ["bottom"] }

[output]
probe_interval = 1e-3
"#;

#[test]
fn a_body_that_is_turned_inside_out_is_examined_and_comes_again() {
    let (dir, said) = broken("soft", &file("soft", SOFT), &[]);
    assert!(said.contains("structure 0 at "), "{said}");
    let number = number_behind(&said, "particle ");
    let report = report(&dir);
    for part in [
        format!("## The particle: particle {number} of solid 1\n").as_str(),
        "| volume ratio det F [-] | ",
        "| stretch [-] |",
        "**acts**",
    ] {
        assert!(report.contains(part), "{part}: {report}");
    }
    comes_again(&dir, &said);
}

/// Watching more changes nothing in a run that does not fail.
#[test]
fn a_watched_run_has_the_bits_of_any_other() {
    let watch = "[watch]\nsteps = 7\ncollapse = 0.1\nenergy_rise = 1e3\nregion = { lower = [-1.0, -1.0], upper = [1.0, 1.0] }\n";
    let tables = [("plain", ""), ("watched", watch)].map(|(name, watch)| {
        let (scene, dir) = (water(name, CALM, watch), fresh("post-mortem", name));
        let output = execute(MPS, &dir, &["run", scene.to_str().unwrap(), "--quiet", "--end-time", "0.1"]);
        assert!(output.status.success(), "{}", words(&output.stderr));
        std::fs::read(dir.join("probes.csv")).unwrap()
    });
    assert!(tables[0] == tables[1]);
}
