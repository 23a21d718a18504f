//! Runs that are asked to end by a file.

use crate::common::{fresh, words};
use crate::{MPS, tank};
use mps_io::{CsvTable, Summary};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

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
