//! Instructions, counted by valgrind.
//!
//! A program is run twice under `valgrind --tool=cachegrind`, the second time with more steps: the difference is what the
//! steps take, and everything before and after drops out. Valgrind executes the program itself, one instruction after the other, on a
//! processor of its own making that has AVX2 and no AVX-512: the counts are the same on every machine.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use thiserror::Error;

/// Steps of the two runs.
const STEPS: [u64; 2] = [2, 6];

/// Why nothing was counted.
#[derive(Debug, Error)]
pub enum CountError {
    /// There is no valgrind, or the program does not start.
    #[error("could not start {what}: {source}; install valgrind 3.19 or later")]
    Start {
        /// The command.
        what: String,
        /// The words of the system.
        source: std::io::Error,
    },
    /// The program failed.
    #[error("{what} failed: {words}")]
    Failed {
        /// The command.
        what: String,
        /// Its last words.
        words: String,
    },
    /// What cachegrind wrote is not what was expected.
    #[error("cachegrind wrote no counts to {file}: {reason}; is its format that of valgrind 3.19?")]
    Format {
        /// The file.
        file: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
}

/// Instructions in one step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Count {
    /// All of them.
    pub total: f64,
    /// Those of each file of the workspace, as `mps-fluid/src/momentum.rs`; what is inlined counts where it was written.
    pub by_file: BTreeMap<String, f64>,
    /// Those of the sweeps, wherever they were written: of the functions that are compiled for vector instructions.
    pub sweeps: f64,
}

impl Count {
    /// Those of all files whose names begin with one of these.
    pub fn of(&self, sources: &[&str]) -> f64 {
        let of = |file: &&String| sources.iter().any(|source| file.starts_with(source));
        self.by_file.keys().filter(of).map(|file| self.by_file[file]).sum()
    }
}

/// Whether there is a valgrind.
pub fn available() -> bool {
    Command::new("valgrind").arg("--version").output().is_ok_and(|output| output.status.success())
}

/// The vector instructions that `program level` says it finds under valgrind.
///
/// # Errors
/// If valgrind or the program cannot be run.
pub fn instruction_set(program: &Path) -> Result<String, CountError> {
    let output = run(Command::new("valgrind").arg("--tool=none").arg(program).arg("level"))?;
    Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// Instructions in one step of what `program run SUBJECT STEPS` does.
///
/// # Errors
/// If valgrind or the program cannot be run, or says something unexpected.
pub fn per_step(program: &Path, subject: &str) -> Result<Count, CountError> {
    let [few, many] = STEPS;
    let (fewer, more) = (count(program, subject, few)?, count(program, subject, many)?);
    let mean = |more: u64, fewer: u64| (more as f64 - fewer as f64) / (many - few) as f64;
    let fewer_in = |file: &String| fewer.by_file.get(file).copied().unwrap_or(0);
    let by_file = more.by_file.iter().map(|(file, n)| (file.clone(), mean(*n, fewer_in(file)))).collect();
    let (total, sweeps) = (mean(more.total, fewer.total), mean(more.sweeps, fewer.sweeps));
    Ok(Count { total, by_file, sweeps })
}

/// What a whole run took.
#[derive(Default)]
struct Whole {
    total: u64,
    by_file: BTreeMap<String, u64>,
    sweeps: u64,
}

fn count(program: &Path, subject: &str, steps: u64) -> Result<Whole, CountError> {
    let name = format!("mps-count-{}-{}-{steps}", std::process::id(), subject.replace('/', "-"));
    let file = std::env::temp_dir().join(name);
    let mut command = Command::new("valgrind");
    command.args(["--tool=cachegrind", "--cache-sim=no", "--branch-sim=no"]);
    command.arg(format!("--cachegrind-out-file={}", file.display()));
    command.arg(program).args(["run", subject, &steps.to_string()]);
    run(&mut command)?;
    let text = std::fs::read_to_string(&file);
    // Nothing depends on whether it stays.
    let _ = std::fs::remove_file(&file);
    let whole = text.map_err(|error| error.to_string()).and_then(|text| read(&text));
    whole.map_err(|reason| CountError::Format { file, reason })
}

fn run(command: &mut Command) -> Result<Output, CountError> {
    let what = format!("{command:?}");
    match command.output() {
        Ok(output) if output.status.success() => Ok(output),
        Ok(output) => {
            let words = String::from_utf8_lossy(&output.stderr);
            let last: Vec<&str> = words.lines().rev().take(5).collect();
            let words = last.into_iter().rev().collect::<Vec<_>>().join("; ");
            Err(CountError::Failed { what, words })
        }
        Err(source) => Err(CountError::Start { what, source }),
    }
}

/// Lines `fl=FILE`, `fn=FUNCTION`, and below them `LINE COUNT`; at the end `summary: COUNT`.
fn read(text: &str) -> Result<Whole, String> {
    let mut whole = Whole::default();
    let (mut file, mut vectorized) = (None, false);
    for line in text.lines() {
        if let Some(name) = line.strip_prefix("fl=") {
            file = workspace_file(name);
        } else if let Some(sum) = line.strip_prefix("summary:") {
            whole.total = sum.trim().parse().map_err(|_| format!("no number in '{line}'"))?;
        } else if let Some(name) = line.strip_prefix("fn=") {
            vectorized = name.contains("vectorize");
        } else if let Some((place, n)) = line.split_once(' ')
            && place.bytes().all(|byte| byte.is_ascii_digit())
        {
            let n: u64 = n.trim().parse().map_err(|_| format!("no number in '{line}'"))?;
            if let Some(file) = &file {
                *whole.by_file.entry(file.clone()).or_default() += n;
            }
            whole.sweeps += if vectorized { n } else { 0 };
        }
    }
    if whole.total == 0 { Err("it has no summary".to_owned()) } else { Ok(whole) }
}

/// The part of a path that begins with the folder of a crate of the workspace.
fn workspace_file(path: &str) -> Option<String> {
    let begin = path.find("mps-").filter(|at| path[*at..].contains("/src/"))?;
    Some(path[begin..].to_owned())
}
