//! What an earlier run has left in the directory of a new one, of the programs of the cases.

use crate::common::{fresh, words};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Program, arguments of a run of minutes, and two of the files it writes at its end.
type Case = (&'static str, &'static str, &'static [&'static str], [&'static str; 2]);

const CASES: &[Case] = &[
    (
        "dam-break",
        env!("CARGO_BIN_EXE_dam-break"),
        &["--spacing", "0.03", "--end-time", "50"],
        ["pressure_2.png", "jet_t6.0.png"],
    ),
    (
        "elastic-gate",
        env!("CARGO_BIN_EXE_elastic-gate"),
        &["--spacing", "2.5e-3", "--end-time", "9"],
        ["gate.png", "snapshot_040ms.png"],
    ),
    (
        "turek-hron",
        env!("CARGO_BIN_EXE_turek-hron"),
        &["--spacing", "0.01", "--length", "1", "--end-time", "900"],
        ["uy.png", "fields/cylinder.pvd"],
    ),
    (
        "submerged-beam",
        env!("CARGO_BIN_EXE_submerged-beam"),
        &["--across", "2", "--end-time", "900"],
        ["deflection.png", "fields/beam.pvd"],
    ),
    (
        "cantilever",
        env!("CARGO_BIN_EXE_cantilever"),
        &["--across", "8", "--periods", "3000"],
        ["energy_error.png", "fields/body.pvd"],
    ),
    ("csm3", env!("CARGO_BIN_EXE_flag-structure"), &["--end-time", "900"], ["ux.png", "stress_highest.png"]),
    (
        "csm1",
        env!("CARGO_BIN_EXE_flag-structure"),
        &["--test", "csm1", "--tolerance", "1e-11"],
        ["middle_line.png", "stress_rest.png"],
    ),
];

/// Begins a run among the results of an earlier one and kills it when it has begun its table.
fn begin_and_kill(program: &str, dir: &Path, arguments: &[&str]) {
    let mut command = Command::new(program);
    command.args(arguments).args(["--threads", "1", "--no-fields", "--quiet", "--out"]).arg(dir);
    let mut child = command.stderr(Stdio::null()).spawn().unwrap();
    let begun = Instant::now();
    while !dir.join("probes.csv").exists() && child.try_wait().unwrap().is_none() {
        assert!(begun.elapsed() < Duration::from_secs(100), "no table");
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
}

#[test]
fn a_run_that_is_killed_has_no_results_of_an_earlier_one_beside_it() {
    for (name, program, arguments, plots) in CASES {
        let dir = fresh("leftovers", name);
        std::fs::create_dir_all(dir.join("fields")).unwrap();
        let earlier = ["summary.json", plots[0], plots[1]].map(|file| dir.join(file));
        let others = ["photo.png", "notes.json", "fields/mine.pvd"].map(|file| dir.join(file));
        for file in earlier.iter().chain(&others) {
            std::fs::write(file, "earlier").unwrap();
        }
        // One that is refused leaves everything.
        let mut command = Command::new(program);
        let refused = command.args(*arguments).args(["--threads", "0", "--out"]).arg(&dir).output().unwrap();
        assert!(!refused.status.success(), "{name}: {}", words(&refused.stderr));
        assert!(earlier.iter().all(|file| file.exists()), "{name}: a refused run has removed something");

        begin_and_kill(program, &dir, arguments);
        assert!(dir.join("probes.csv").exists(), "{name}: it has not begun");
        assert!(earlier.iter().all(|file| !file.exists()), "{name}: {earlier:?}");
        assert!(others.iter().all(|file| file.exists()), "{name} has removed what it did not write");
    }
}
