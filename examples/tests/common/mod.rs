//! How the tests of the programs run them.
#![allow(dead_code, reason = "each test uses what it needs")]
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use mps_io::{CsvTable, Summary, Value};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A directory of its own for every test of a `group`, emptied first.
pub(crate) fn fresh(group: &str, name: &str) -> PathBuf {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join(group).join(name);
    let _ = std::fs::remove_dir_all(&dir);
    dir
}

/// Runs a program with its results in `out`.
pub(crate) fn execute(program: &str, out: &Path, arguments: &[&str]) -> Output {
    Command::new(program).args(arguments).arg("--out").arg(out).output().unwrap()
}

/// What a program prints with `--print-scene`.
pub(crate) fn print(program: &str, arguments: &[&str]) -> Output {
    Command::new(program).args(arguments).arg("--print-scene").output().unwrap()
}

/// The scene that a program prints, as a file.
pub(crate) fn printed(program: &str, name: &str, arguments: &[&str]) -> PathBuf {
    let output = print(program, arguments);
    assert!(output.status.success() && output.stderr.is_empty(), "{name}: {}", words(&output.stderr));
    let dir = fresh("printed", name);
    std::fs::create_dir_all(&dir).unwrap();
    let file = dir.join("scene.toml");
    std::fs::write(&file, output.stdout).unwrap();
    file
}

/// What a program printed.
pub(crate) fn words(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// Runs a whole case without fields and reads the summary it has to complete.
pub(crate) fn completed(program: &str, name: &str, arguments: &[&str]) -> Summary {
    let dir = fresh("whole-cases", name);
    let output = execute(program, &dir, &[arguments, &["--no-fields", "--quiet"]].concat());
    assert!(output.status.success(), "{arguments:?}: {}", words(&output.stderr));
    let summary = Summary::read(dir.join("summary.json")).unwrap();
    assert_eq!(summary.status, "completed");
    summary
}

/// Runs a program without pictures and reads its table and its summary.
pub(crate) fn results(program: &str, name: &str, arguments: &[&str]) -> (CsvTable, Summary) {
    let dir = fresh("scenes", name);
    let output = execute(program, &dir, &[arguments, &["--no-fields", "--quiet"]].concat());
    assert!(output.status.success(), "{name}: {}", words(&output.stderr));
    (CsvTable::read(dir.join("probes.csv")).unwrap(), Summary::read(dir.join("summary.json")).unwrap())
}

/// Two columns agree within a share of the largest value of the second.
pub(crate) fn assert_same(a: &CsvTable, b: &CsvTable, columns: &[(&str, &str)], share: f64) {
    for (mine, theirs) in columns {
        let (x, y) = (a.column(mine).unwrap(), b.column(theirs).unwrap());
        assert_eq!(x.len(), y.len(), "{mine}");
        let largest = y.iter().fold(0.0_f64, |largest, y| largest.max(y.abs()));
        for (k, (x, y)) in x.iter().zip(y).enumerate() {
            assert!((x - y).abs() <= share * largest, "{mine} is {x:e} in row {k}, in the program {y:e}");
        }
    }
}

/// The table of a plate's scene is that of the program.
pub(crate) fn assert_same_plate(scene: &CsvTable, program: &CsvTable) {
    let columns = ["time [s]", "tip x [m]", "tip y [m]", "energy [J/m]"].map(|name| (name, name));
    assert_same(scene, program, &columns, 1e-9);
}

/// Where the workspace is.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_path_buf()
}

/// The members of the workspace, as cargo reads their manifests.
pub(crate) fn packages() -> Vec<Value> {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--no-deps", "--offline"])
        .current_dir(root())
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", words(&output.stderr));
    let metadata: Value = words(&output.stdout).parse().unwrap();
    metadata["packages"].as_array().unwrap().clone()
}
