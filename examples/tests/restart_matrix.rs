//! Case by moment by threads: a run that is broken off and gone on with is the run in one piece, to the last bit of its table and of
//! its state.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{execute, fresh, printed, words};
use mps_io::CsvTable;
use mps_io::checkpoint::Rotation;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const MPS: &str = env!("CARGO_BIN_EXE_mps");

/// Threads before and after the break.
const THREADS: [[&str; 2]; 2] = [["1", "3"], ["2", "1"]];

/// Breaks a scene off after its first step, in the middle and before its last step, on several threads each.
fn matrix(name: &str, scene: &Path) {
    let whole = fresh("restart-matrix", &format!("{name}-whole"));
    succeeded(execute(
        MPS,
        &whole,
        &["run", scene.to_str().unwrap(), "--quiet", "--no-fields", "--threads", "1"],
    ));
    let table = CsvTable::read(whole.join("probes.csv")).unwrap();
    let end = *table.column("time [s]").unwrap().last().unwrap();
    // A step of bodies alone is a row of the table, whatever its sub-steps.
    let wet = state(&whole).iter().any(|(name, _)| name.starts_with("wet/"));
    let step =
        if wet { *table.column("time step [s]").unwrap().last().unwrap() } else { table.columns[0][1] };
    for (k, moment) in [1e-3 * step, 0.45 * end, end - 1.5 * step].into_iter().enumerate() {
        for [before, after] in THREADS {
            let dir = fresh("restart-matrix", &format!("{name}-{k}-{before}-{after}"));
            let arguments = ["run", scene.to_str().unwrap(), "--quiet", "--no-fields", "--threads", before];
            succeeded(execute(
                MPS,
                &dir,
                &[&arguments[..], &["--end-time", &format!("{moment:e}")]].concat(),
            ));
            let reached = *CsvTable::read(dir.join("probes.csv")).unwrap().columns[0].last().unwrap();
            assert!(reached >= moment && reached < moment + 1.6 * step, "{name}: {reached} s for {moment} s");
            // The last step ends there, whatever the rounding.
            let last = format!("{:e}", end * (1.0 - 1e-9));
            let arguments = ["--quiet", "--threads", after, "--end-time", &last];
            succeeded(Command::new(MPS).arg("resume").arg(&dir).args(arguments).output().unwrap());
            let what = format!("{name}, broken off at {reached} s, {before} and {after} threads");
            let read = |dir: &Path| std::fs::read(dir.join("probes.csv")).unwrap();
            assert!(read(&whole) == read(&dir), "{what}: probes.csv");
            assert_eq!(differing(&state(&whole), &state(&dir)), [""; 0], "{what}");
        }
    }
}

fn succeeded(output: Output) {
    assert!(output.status.success(), "{}", words(&output.stderr));
}

/// The state at the end: each part by name, with its bytes.
fn state(dir: &Path) -> Vec<(String, Vec<u8>)> {
    let (checkpoint, _) = Rotation::new(dir.join("checkpoint")).read().unwrap();
    let sections = checkpoint.state.sections().iter();
    sections.map(|section| (section.name.clone(), section.bytes.clone())).collect()
}

/// Names of the parts that are not the same, but for what the clock of the machine says, and when frames are due that are not written: how
/// often follows from the end that is asked for.
fn differing<'a>(one: &'a [(String, Vec<u8>)], other: &[(String, Vec<u8>)]) -> Vec<&'a str> {
    assert_eq!(one.len(), other.len());
    let pairs =
        one.iter().zip(other).filter(|(a, b)| a != b && !["wall time", "output/due"].contains(&a.0.as_str()));
    pairs.map(|(a, _)| a.0.as_str()).collect()
}

/// A scene of the gallery that ends after `end`.
fn gallery(name: &str, end: &str) -> PathBuf {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name);
    let text = std::fs::read_to_string(file).unwrap();
    let old = text.lines().find(|line| line.starts_with("end_time")).unwrap();
    let dir = fresh("restart-matrix", &format!("{name}-scene"));
    std::fs::create_dir_all(&dir).unwrap();
    let file = dir.join(name);
    std::fs::write(&file, text.replace(old, &format!("end_time = {end}"))).unwrap();
    file
}

#[test]
fn the_gate() {
    let options = ["--spacing", "2.5e-3", "--across", "4", "--end-time", "4e-3"];
    matrix("gate", &printed(env!("CARGO_BIN_EXE_elastic-gate"), "matrix-gate", &options));
}

#[test]
fn the_dam_break() {
    let options = ["--spacing", "1.2e-2", "--end-time", "0.04", "--shifting", "2"];
    matrix("dam", &printed(env!("CARGO_BIN_EXE_dam-break"), "matrix-dam", &options));
}

#[test]
fn the_cantilever() {
    let options = ["--across", "12", "--end-time", "5e-3"];
    matrix("plate", &printed(env!("CARGO_BIN_EXE_cantilever"), "matrix-plate", &options));
}

/// Fluid enters and leaves, and the flag has finer particles than the fluid.
#[test]
fn the_channel() {
    let options =
        ["--test", "fsi3", "--spacing", "0.01", "--length", "1.2", "--across", "4", "--end-time", "0.03"];
    matrix("channel", &printed(env!("CARGO_BIN_EXE_turek-hron"), "matrix-channel", &options));
}

/// A body with damping in water at rest.
#[test]
fn the_beam_in_water() {
    let options = ["--across", "4", "--end-time", "0.05"];
    matrix("beam", &printed(env!("CARGO_BIN_EXE_submerged-beam"), "matrix-beam", &options));
}

/// A wall that moves.
#[test]
fn the_wave_maker() {
    matrix("wave-maker", &gallery("wave-maker.toml", "0.05"));
}

#[test]
fn a_dam_break_in_space() {
    matrix("dam-3d", &gallery("dam-break-3d.toml", "0.03"));
}
