//! `mps plot`, `harmonics` and `converge`: the plots of a run, again, columns of its table by name, and a series of runs.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{execute, fresh, words};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const MPS: &str = env!("CARGO_BIN_EXE_mps");

fn plot(dir: &Path, arguments: &[&str]) -> Output {
    Command::new(MPS).arg("plot").arg(dir).args(arguments).output().unwrap()
}

/// A short run of a scene.
fn tank(name: &str) -> PathBuf {
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/hydrostatic-tank.toml");
    let dir = fresh("plots", name);
    let run = ["run", scene.to_str().unwrap(), "--end-time", "5e-3", "--no-fields", "--quiet"];
    assert!(execute(MPS, &dir, &run).status.success());
    dir
}

#[test]
fn the_plots_of_a_run_are_drawn_again_as_they_were() {
    let dir = tank("again");
    for name in ["probe_level.png", "probe_pressure_at_the_bottom.png", "energies.png"] {
        let path = dir.join(name);
        let first = std::fs::read(&path).unwrap();
        std::fs::remove_file(&path).unwrap();
        let output = plot(&dir, &[]);
        assert!(output.status.success(), "{}", words(&output.stderr));
        assert!(std::fs::read(&path).unwrap() == first, "{name}");
    }
}

#[test]
fn columns_are_drawn_by_name_with_or_without_their_units() {
    let dir = tank("columns");
    let draw = |arguments: &[&str], picture: &str| {
        let output = plot(&dir, arguments);
        assert!(output.status.success(), "{}", words(&output.stderr));
        assert_eq!(words(&output.stdout).trim(), dir.join(picture).to_str().unwrap());
        std::fs::read(dir.join(picture)).unwrap()
    };
    let one = draw(&["--column", "fluid kinetic"], "columns.png");
    assert!(one == draw(&["--column", "fluid kinetic [J/m]"], "columns.png"));
    let two = draw(&["--column", "fluid kinetic", "--column", "fluid compression"], "columns.png");
    assert!(one != two && two.starts_with(b"\x89PNG"));
    let other = dir.join("phase.png");
    let phase = ["--column", "level", "--over", "fluid kinetic", "--picture", other.to_str().unwrap()];
    assert!(draw(&phase, "phase.png") != draw(&["--column", "level"], "columns.png"));
}

#[test]
fn what_cannot_be_drawn_is_refused_with_a_remedy() {
    let dir = tank("refused");
    let table = dir.join("probes.csv").display().to_string();
    for (arguments, message) in [
        (vec!["--column", "levl"], format!("{table} has no column \"levl\": did you mean \"level\"?")),
        (
            vec!["--column", "drag"],
            format!("{table} has no column \"drag\": there are time, pressure at the bottom"),
        ),
        (
            vec!["--column", "level", "--column", "time step"],
            "\"level [m]\" and \"time step [s]\" have different units".to_owned(),
        ),
        (
            vec!["--column", "level", "--over", "tim"],
            format!("{table} has no column \"tim\": did you mean \"time\"?"),
        ),
    ] {
        let output = plot(&dir, &arguments);
        let said = words(&output.stderr);
        assert!(!output.status.success() && said.starts_with("error: ") && said.contains(&message), "{said}");
    }
    let nowhere = plot(&dir.join("nowhere"), &[]);
    assert!(!nowhere.status.success() && words(&nowhere.stderr).contains("probes.csv"));
    let headings =
        std::fs::read_to_string(dir.join("probes.csv")).unwrap().lines().next().unwrap().to_owned();
    std::fs::write(dir.join("probes.csv"), headings + "\n").unwrap();
    assert!(words(&plot(&dir, &[]).stderr).contains("has no rows yet"));
}

/// Programs that know no scenes have tables as well.
#[test]
fn the_table_of_another_program_is_drawn() {
    let dir = fresh("plots", "plate");
    let run = ["--across", "2", "--end-time", "0.02", "--no-fields", "--quiet"];
    assert!(execute(env!("CARGO_BIN_EXE_cantilever"), &dir, &run).status.success());
    let output = plot(&dir, &[]);
    assert!(output.status.success(), "{}", words(&output.stderr));
    assert!(dir.join("probe_tip_y.png").exists() && dir.join("probe_energy.png").exists());
}

#[test]
fn harmonics_of_a_table_are_told() {
    let dir = fresh("plots", "harmonics");
    std::fs::create_dir_all(&dir).unwrap();
    let mut table = "time [s],lift [N/m],level [m]\n".to_owned();
    for k in 0..400 {
        let t = f64::from(k) * 0.01;
        table += &format!("{t},{},0.5\n", 3.0 + 2.0 * (core::f64::consts::TAU * 5.0 * t).cos());
    }
    std::fs::write(dir.join("probes.csv"), table).unwrap();
    let run =
        |arguments: &[&str]| Command::new(MPS).arg("harmonics").arg(&dir).args(arguments).output().unwrap();
    let told = words(&run(&["--from", "1", "--to", "3", "--count", "1"]).stdout);
    assert!(told.contains("| lift [N/m] | 3.00000e0 | 2.0000e0 | 5.0000 |"), "{told}");
    assert!(told.contains("| level [m] | 5.00000e-1 | - | - | 0.000e0 |"), "{told}");
    let one = words(&run(&["--column", "level"]).stdout);
    assert!(one.contains("level") && !one.contains("lift"), "{one}");
    for (arguments, message) in [
        (["--column", "lft"], "did you mean \"lift\"?"),
        (["--from", "8"], "--from is 8: the run has 400 rows up to 3.9900 s: give an earlier time"),
        (["--from", "nan"], "--from is NaN: give a time of the run in seconds"),
        (["--to", "inf"], "--to is inf: give a time of the run in seconds"),
    ] {
        let output = run(&arguments);
        let said = words(&output.stderr);
        assert!(!output.status.success() && said.contains(message), "{said}");
    }
}

/// A long table is taken apart in a moment, and noise from row to row has the size it has.
#[test]
fn harmonics_of_a_long_table_are_told() {
    let dir = fresh("plots", "harmonics-long");
    std::fs::create_dir_all(&dir).unwrap();
    let mut table = "time [s],lift [N/m]\n".to_owned();
    for k in 0..30_000 {
        let (t, noise) = (f64::from(k) * 1e-3, if k % 2 == 0 { 0.5 } else { -0.5 });
        table += &format!("{t},{}\n", 3.0 + noise + 2.0 * (core::f64::consts::TAU * 5.03 * t).cos());
    }
    std::fs::write(dir.join("probes.csv"), table).unwrap();
    let begun = std::time::Instant::now();
    let output = Command::new(MPS).arg("harmonics").arg(&dir).args(["--from", "0"]).output().unwrap();
    let told = words(&output.stdout);
    assert!(told.contains("| 3.00000e0 | 2.0000e0 | 5.0300 | 5.0000e-1 | 500.0000 |"), "{told}");
    assert!(begun.elapsed().as_secs() < 30, "{:?}", begun.elapsed());
}

#[test]
fn a_series_of_runs_is_told_its_order() {
    let root = fresh("plots", "converge");
    let spacings = [4e-3, 2e-3, 1e-3];
    let dirs: Vec<PathBuf> = spacings.iter().map(|l0| root.join(format!("{l0}"))).collect();
    for (l0, dir) in spacings.iter().zip(&dirs) {
        std::fs::create_dir_all(dir).unwrap();
        let mut table = "time [s],tip x [m],level [m]\n".to_owned();
        // Rows of their own, and an error of second order.
        let rows = (0.2 / l0) as u32;
        for k in 0..=rows {
            let t = f64::from(k) / f64::from(rows);
            table += &format!("{t},{},0.5\n", t + l0 * l0 * 1e3);
        }
        std::fs::write(dir.join("probes.csv"), table).unwrap();
        let mut summary = mps_io::Summary::new("test", "0");
        summary.set("spacing_m", l0);
        summary.write(dir).unwrap();
    }
    let run = |dirs: &[PathBuf], arguments: &[&str]| {
        Command::new(MPS).arg("converge").args(dirs).args(arguments).output().unwrap()
    };
    let told = words(&run(&dirs, &["--column", "tip x", "--column", "level"]).stdout);
    assert!(told.contains("| 0.0000 to 1.0000 s | 4e-3 m to 2e-3 m | 2e-3 m to 1e-3 m | orders |"), "{told}");
    assert!(told.contains("| tip x [m] | 1.200e-2 | 3.000e-3 | 2.00 |"), "{told}");
    assert!(told.contains("| level [m] | 0.000e0 | 0.000e0 | - |"), "{told}");
    // The summary of a scene has its spacing elsewhere.
    let mut summary = mps_io::Summary::new("mps", "0");
    let scene: std::collections::BTreeMap<&str, f64> = [("spacing", spacings[0])].into();
    summary.set("description", std::collections::BTreeMap::from([("fluid", scene)]));
    summary.write(&dirs[0]).unwrap();
    assert_eq!(told, words(&run(&dirs, &["--column", "tip x", "--column", "level"]).stdout));
    // Spacings that do not tell runs apart are no names.
    let twice = [&dirs[1..2], &dirs[1..2]].concat();
    let same = words(&run(&twice, &["--column", "tip x"]).stdout);
    assert!(same.contains("| 0.002 to 0.002 | orders |") && same.contains("| 0.000e0 | - |"), "{same}");
    // Without a summary runs have names, and no order.
    std::fs::remove_file(dirs[0].join("summary.json")).unwrap();
    let told = words(&run(&dirs, &["--column", "tip x", "--from", "0.2", "--to", "0.9"]).stdout);
    assert!(told.contains("| 0.2000 to 0.9000 s | 0.004 to 0.002 | 0.002 to 0.001 |"), "{told}");
    assert!(told.contains("| tip x [m] | 1.200e-2 | 3.000e-3 | - |"), "{told}");
    let all = "all runs have rows from 0.0000 to 1.0000 s: give a time between";
    for (arguments, message) in [
        (vec!["--column", "tpi x"], "did you mean \"tip x\"?".to_owned()),
        (vec!["--column", "tip x", "--from", "8"], format!("--from is 8: {all}")),
        (vec!["--column", "tip x", "--to", "8"], format!("--to is 8: {all}")),
        (vec!["--column", "tip x", "--from", "nan"], format!("--from is NaN: {all}")),
        (
            vec!["--column", "tip x", "--from", "0.2", "--to", "0.1"],
            "--from is 0.2: give a time before 0.1000 s".to_owned(),
        ),
        (vec![], "--column <NAME>".to_owned()),
    ] {
        let output = run(&dirs, &arguments);
        let said = words(&output.stderr);
        assert!(!output.status.success() && said.contains(&message), "{said}");
    }
    // One that begins when the others have ended, and one with a value missing.
    std::fs::write(dirs[0].join("probes.csv"), "time [s],tip x [m],level [m]\n3,0,0\n4,0,0\n").unwrap();
    let said = words(&run(&dirs, &["--column", "tip x"]).stderr);
    assert!(said.contains("DIRECTORIES is 0.004, 0.002, 0.001: these runs have no time in common"), "{said}");
    std::fs::write(dirs[0].join("probes.csv"), "time [s],tip x [m],level [m]\n0,nan,0\n1,0,0\n").unwrap();
    let told = words(&run(&dirs, &["--column", "tip x"]).stdout);
    assert!(told.contains("| tip x [m] | - | 3.000e-3 | - |"), "{told}");
    assert!(!run(&dirs[..1], &["--column", "tip x"]).status.success());
}
