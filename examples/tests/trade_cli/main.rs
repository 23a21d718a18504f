//! The program `trade`: goes on where it was interrupted, keeps runs that failed, and says which runs are worth their cost.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

#[path = "../common/mod.rs"]
mod common;
mod results;

use common::{fresh, words};
use mps_io::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const SWEEP: &str = r#"
title = "Tiny"
program = "cantilever"
also = ["energy_drift"]
counts = [
    { metric = "period", tolerance = 0.02, uncertainty = 0.0003 },
    { metric = "amplitude", tolerance = 0.02 },
]
[base]
threads = 1
periods = 1.2
[[vary]]
across = [1, 2, 4]
"#;

/// A sweep file and the directory of its results.
struct Trade {
    dir: PathBuf,
}

impl Trade {
    fn new(name: &str) -> Self {
        let dir = fresh("trade", name);
        std::fs::create_dir_all(&dir).unwrap();
        Self { dir }
    }

    fn run(&self, sweep: &str, arguments: &[&str]) -> Output {
        let file = self.dir.join("tiny.toml");
        std::fs::write(&file, sweep).unwrap();
        let trade = env!("CARGO_BIN_EXE_trade");
        Command::new(trade).arg(file).arg("--out").arg(self.out()).args(arguments).output().unwrap()
    }

    fn good(&self, sweep: &str, arguments: &[&str]) -> String {
        let output = self.run(sweep, arguments);
        assert!(output.status.success(), "{}", words(&output.stderr));
        words(&output.stdout)
    }

    fn out(&self) -> PathBuf {
        self.dir.join("out")
    }

    fn below(&self, run: &str) -> PathBuf {
        self.out().join("runs").join(run)
    }

    fn table(&self) -> Value {
        std::fs::read_to_string(self.out().join("trade.json")).unwrap().parse().unwrap()
    }
}

fn mark(run: &Path) -> PathBuf {
    let file = run.join("mark");
    std::fs::write(&file, "a run that is made again begins with an empty directory").unwrap();
    file
}

#[test]
fn a_failed_run_is_kept_and_the_best_are_told() {
    let trade = Trade::new("failed");
    let said = trade.good(SWEEP, &[]);
    let table = trade.table();
    let rows = table["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 3);

    assert!(
        rows[0]["failure"].as_str().unwrap().contains("--across is 1: the plate needs 2 to 200 particles")
    );
    assert!(rows[0]["error_over_tolerance"].is_null());
    let worst = |k: usize| rows[k]["error_over_tolerance"].as_f64().unwrap();
    let errors = |k: usize| [0, 1].map(|n| rows[k]["errors"][n].as_f64().unwrap());
    for k in [1, 2] {
        let [period, amplitude] = errors(k);
        let expected = (period.abs().max(0.0003) / 0.02).max(amplitude.abs() / 0.02);
        assert!((worst(k) - expected).abs() < 1e-12, "{k}: {} {expected}", worst(k));
        assert!(rows[k]["peak_memory_bytes"].as_u64().unwrap() > 1 << 20);
    }
    // The error the program itself has written.
    let summary = mps_io::Summary::read(trade.below("across_4").join("summary.json")).unwrap();
    assert_eq!(summary.metrics["period"].error.unwrap(), errors(2)[0]);

    // Two particles across bend with a fifth less, four are within two percent: both are on the front, unless the clock could not tell
    // them apart.
    assert!(worst(1) > 4.0 && worst(2) < 1.0, "{} {}", worst(1), worst(2));
    let front: Vec<u64> = table["front"].as_array().unwrap().iter().map(|k| k.as_u64().unwrap()).collect();
    let cost = |k: usize| rows[k]["cost_seconds"].as_f64().unwrap();
    assert_eq!(front, if cost(1) < cost(2) { vec![1, 2] } else { vec![2] });
    assert!(
        said.contains("- period within 2 %: across 4, ") && said.contains("- all within 1 times"),
        "{said}"
    );
    assert!(said.contains("- all within 0.5 times their tolerances: "), "{said}");

    let csv = std::fs::read_to_string(trade.out().join("trade.csv")).unwrap();
    let lines: Vec<&str> = csv.lines().collect();
    assert!(
        lines.len() == 4 && lines[1].starts_with("\"across 1\",") && lines[1].contains("e.g. 10\",\"20"),
        "{csv}"
    );
    let markdown = std::fs::read_to_string(trade.out().join("trade.md")).unwrap();
    assert!(
        markdown.contains("| across 4 | ") && markdown.contains("| - | failed: --across is 1"),
        "{markdown}"
    );
    assert!(trade.out().join("trade.png").exists());
}

#[test]
fn what_has_ended_is_not_run_again_and_what_was_interrupted_is() {
    let trade = Trade::new("resumed");
    let first = SWEEP.replace("[1, 2, 4]", "[1, 2, 3]");
    trade.good(&first, &["--quiet"]);
    let [failed, done, interrupted] = ["across_1", "across_2", "across_3"].map(|run| trade.below(run));
    let marks = [&failed, &done, &interrupted].map(|run| mark(run));
    let before = trade.table();
    // As a run looks whose process was killed: without its record.
    std::fs::remove_file(interrupted.join("run.json")).unwrap();

    // Tables without a run.
    trade.good(&first, &["--tables", "--quiet"]);
    assert_eq!(trade.table()["rows"].as_array().unwrap().len(), 2);
    assert!(marks.iter().all(|mark| mark.exists()));

    let longer = SWEEP.replace("[1, 2, 4]", "[1, 2, 3, 4]");
    trade.good(&longer, &[]);
    assert_eq!(marks.map(|mark| mark.exists()), [true, true, false]);
    let after = trade.table();
    assert_eq!(after["rows"].as_array().unwrap().len(), 4);
    assert_eq!(after["rows"][1], before["rows"][1]);
    assert_eq!(after["rows"][2]["errors"], before["rows"][2]["errors"], "the same run has the same bits");

    // Other arguments are another run, with the same name or not.
    let again = mark(&done);
    trade.good(&longer.replace("periods = 1.2", "periods = 1.1"), &["--quiet"]);
    assert!(!again.exists());
}

#[test]
fn commands_can_be_seen_and_mistakes_are_told() {
    let trade = Trade::new("refused");
    let commands = "cantilever --across=1 --periods=1.2 --threads=1\n";
    assert!(trade.good(SWEEP, &["--list"]).starts_with(commands));
    assert!(!trade.out().exists());
    for (sweep, message) in [
        (SWEEP.replace("\"cantilever\"", "\"none-such\""), "build it first"),
        (SWEEP.replace("tolerance = 0.02 }", "tolerance = -1 }"), "tolerance is -1"),
        (SWEEP.replace("[[vary]]", "[[varied]]"), "varied"),
    ] {
        let output = trade.run(&sweep, &[]);
        let said = words(&output.stderr);
        assert!(!output.status.success() && said.contains(message), "{message}: {said}");
    }
}

/// Every flag of these commands is one of its program.
fn assert_flags_are_known(commands: &str) {
    let name = commands.split(' ').next().unwrap();
    let program = Path::new(env!("CARGO_BIN_EXE_trade")).with_file_name(name);
    let help = words(&Command::new(program).arg("--help").output().unwrap().stdout);
    let flags = commands.split_whitespace().filter(|word| word.starts_with("--"));
    for flag in flags.filter_map(|word| word.split('=').next()) {
        assert!(
            help.contains(&format!("{flag} ")) || help.contains(&format!("{flag}\n")),
            "{name} has no {flag}"
        );
    }
}

/// The sweeps that are there can be read.
#[test]
fn the_sweeps_of_the_repository_are_good() {
    let sweeps = std::fs::read_dir(common::root().join("examples/trades")).unwrap();
    let mut found = 0;
    for sweep in sweeps {
        let path = sweep.unwrap().path();
        let output = Command::new(env!("CARGO_BIN_EXE_trade")).arg(&path).arg("--list").output().unwrap();
        let commands = words(&output.stdout);
        let runs = commands.lines().count();
        assert_flags_are_known(&commands);
        assert!(
            output.status.success() && runs >= 12,
            "{}: {runs} runs, {}",
            path.display(),
            words(&output.stderr)
        );
        found += 1;
    }
    assert!(found >= 3, "{found} sweeps");
}
