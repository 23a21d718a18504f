//! Runs that are asked to end by a file.

use crate::common::{fresh, words};
use crate::{MPS, tank};
use mps_io::{CsvTable, Summary};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// Waits for a file of a run that asks for no rows, asks for the end, and waits for that.
fn stop_below(child: Child, file: &Path, dir: &Path) -> Output {
    let begun = Instant::now();
    while !file.exists() {
        assert!(begun.elapsed() < Duration::from_secs(100), "no {}", file.display());
        std::thread::sleep(Duration::from_millis(2));
    }
    std::fs::write(dir.join("stop"), "").unwrap();
    child.wait_with_output().unwrap()
}

fn start(program: &str, dir: &Path, arguments: &[&str]) -> Child {
    let mut command = Command::new(program);
    command.args(arguments).arg("--out").arg(dir).args(["--threads", "1", "--no-fields", "--quiet"]);
    command.stderr(Stdio::piped()).spawn().unwrap()
}

/// Waits for the first rows, asks for the end with a file, and waits for that.
fn stop(mut child: Child, dir: &Path) -> Output {
    let begun = Instant::now();
    let rows = || std::fs::read_to_string(dir.join("probes.csv")).map_or(0, |text| text.lines().count());
    while rows() < 3 && child.try_wait().unwrap().is_none() {
        assert!(begun.elapsed() < Duration::from_secs(100), "no rows");
        std::thread::sleep(Duration::from_millis(2));
    }
    std::fs::write(dir.join("stop"), "").unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(!dir.join("stop").exists(), "it has been heard");
    output
}

#[test]
fn a_file_ends_a_run_as_a_signal_does() {
    let (scene, dir) = (tank("stopped", "probe_interval = 1e-3"), fresh("output", "stopped"));
    let scene = scene.to_str().unwrap();
    // One that an earlier run has left there asks for nothing.
    std::fs::create_dir_all(&dir).unwrap();
    std::fs::write(dir.join("stop"), "").unwrap();
    let output = stop(start(MPS, &dir, &["run", scene, "--end-time", "50"]), &dir);
    let said = words(&output.stderr);
    assert!(
        !output.status.success() && said.contains("stopped by the file `stop`. Its state at t = "),
        "{said}"
    );
    assert!(dir.join("checkpoint/last.mps").exists() && dir.join("energies.png").exists());
    let log = std::fs::read_to_string(dir.join("run.log")).unwrap();
    assert!(log.contains(" WARN ") && log.contains("stopped by the file"), "{log}");
    let rows = CsvTable::read(dir.join("probes.csv")).unwrap().columns[0].len();

    let on = format!("{}", 1e-3 * (rows + 5) as f64);
    let resumed =
        Command::new(MPS).arg("resume").arg(&dir).args(["--end-time", &on, "--quiet"]).output().unwrap();
    assert!(resumed.status.success(), "{}", words(&resumed.stderr));
    assert!(CsvTable::read(dir.join("probes.csv")).unwrap().columns[0].len() > rows);
    // The log goes on as well.
    let whole = std::fs::read_to_string(dir.join("run.log")).unwrap();
    assert!(whole.starts_with(&log) && whole[log.len()..].contains("completed"), "{whole}");
}

#[test]
fn a_file_ends_the_programs_of_the_cases_with_their_results() {
    let dir = fresh("output", "gate-stopped");
    let arguments = ["--spacing", "2.5e-3", "--end-time", "2.0"];
    let output = stop(start(env!("CARGO_BIN_EXE_elastic-gate"), &dir, &arguments), &dir);
    let said = words(&output.stderr);
    assert!(!output.status.success() && said.contains("stopped by the file `stop` at t = "), "{said}");
    let summary = Summary::read(dir.join("summary.json")).unwrap();
    assert!(summary.status.contains("stopped by the file"), "{}", summary.status);
    assert!(dir.join("gate.png").exists());
    // The state it was stopped in has a row.
    let time = CsvTable::read(dir.join("probes.csv")).unwrap().columns[0].last().copied().unwrap();
    assert!(said.contains(&format!("at t = {time:e} s")), "{time:e}: {said}");
}

/// Programs that have no rows: an exact problem, and a flag that comes to rest.
#[test]
fn a_file_ends_programs_without_a_course_as_well() {
    let exact =
        (env!("CARGO_BIN_EXE_exact"), "exact", &["--problem", "hydrostatic", "--resolution", "60"][..]);
    let rest = ["--test", "csm1", "--tolerance", "1e-11"];
    let flag = (env!("CARGO_BIN_EXE_flag-structure"), "csm1", &rest[..]);
    for (program, name, arguments) in [exact, flag] {
        let dir = fresh("output", &format!("{name}-stopped"));
        let output = stop_below(start(program, &dir, arguments), &dir.join("run.log"), &dir);
        let said = words(&output.stderr);
        assert!(!output.status.success() && said.contains("stopped by the file `stop` at t = "), "{said}");
        let summary = Summary::read(dir.join("summary.json")).unwrap();
        assert!(summary.status.contains("stopped by the file"), "{}", summary.status);
        assert!(summary.steps > 0 || name == "exact");
    }
}

/// The end of one run of a comparison is that of the comparison.
#[test]
fn a_file_ends_the_comparison_of_stabilisers() {
    let dir = fresh("output", "stabilisers-stopped");
    let below = dir.join("as-given");
    let arguments = ["--stabilisers", "--spacing", "0.03", "--end-time", "50"];
    let child = start(env!("CARGO_BIN_EXE_dam-break"), &dir, &arguments);
    let output = stop_below(child, &below.join("run.log"), &below);
    let said = words(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("stopped by the file"), "{said}");
    let table = std::fs::read_to_string(dir.join("stabilisers.md")).unwrap();
    assert!(table.contains("| as given (stopped) |") && !table.contains("no density diffusion"), "{table}");
}
