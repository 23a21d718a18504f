//! One run: a process of its own, so that its memory and its processor time are its own, and the record by which it is known to be
//! finished.

use crate::machine::{TICKS, machine, processor_ticks_of_children, today};
use crate::sweep::Setting;
use mps_examples::Failure;
use mps_io::Summary;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::Instant;

/// What is known of a run that has ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Record {
    /// Name of the program.
    pub(crate) program: String,
    /// The arguments it was given: with others it is another run.
    pub(crate) arguments: Vec<String>,
    /// From start to end of the process \[s\].
    pub(crate) wall_seconds: f64,
    /// Processor time of the process \[s\]; `None` where the system does not tell.
    pub(crate) processor_seconds: Option<f64>,
    /// Why it did not come to its end, if so.
    pub(crate) failure: Option<String>,
    /// The day it was made; `None` of runs that were made when this was not kept.
    #[serde(default)]
    pub(crate) date: Option<String>,
    /// The machine it was made on.
    #[serde(default)]
    pub(crate) machine: Option<String>,
}

impl Record {
    /// What the run has cost \[s\]: processor time, which does not depend on what else the machine does.
    pub(crate) fn cost(&self) -> f64 {
        self.processor_seconds.unwrap_or(self.wall_seconds)
    }
}

/// Path of a program of this name beside this one.
pub(crate) fn program(name: &str) -> Result<PathBuf, Failure> {
    let path = std::env::current_exe()?.with_file_name(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    if path.exists() {
        return Ok(path);
    }
    let remedy = format!("build it first: cargo build --release -p mps-examples --bin {name}");
    Err(format!("there is no program {name} in {}: {remedy}", path.parent().unwrap_or(&path).display())
        .into())
}

/// The record of the run in `dir`, if the same run has ended there.
pub(crate) fn finished(program: &str, dir: &Path, setting: &Setting) -> Option<Record> {
    let text = std::fs::read_to_string(dir.join("run.json")).ok()?;
    let record: Record = serde_json::from_str(&text).ok()?;
    (record.program == program && record.arguments == setting.arguments).then_some(record)
}

/// Makes the run in `dir`. One that is stopped, by a signal or a file, leaves no record, and is made again the next time.
pub(crate) fn run(name: &str, program: &Path, dir: &Path, setting: &Setting) -> Result<Record, Failure> {
    // What an earlier run of other settings has left must not be taken for this one's.
    if dir.exists() {
        std::fs::remove_dir_all(dir)?;
    }
    mps_io::prepare_output(dir)?;
    let (clock, before) = (Instant::now(), processor_ticks_of_children());
    let output = Command::new(program)
        .args(&setting.arguments)
        .args(["--no-fields", "--quiet", "--out"])
        .arg(dir)
        .output()
        .map_err(|error| format!("{} cannot be started: {error}", program.display()))?;
    if output.status.code() == Some(MISREAD) {
        return Err(misread(name, &output).into());
    }
    let wall_seconds = clock.elapsed().as_secs_f64();
    let ticks = processor_ticks_of_children().zip(before).map(|(after, before)| after - before);
    let processor_seconds = ticks.map(|ticks| ticks as f64 / TICKS);
    let record = Record {
        program: name.to_owned(),
        arguments: setting.arguments.clone(),
        wall_seconds,
        processor_seconds,
        failure: failure(dir, &output),
        date: Some(today()),
        machine: Some(machine()),
    };
    let stopped = record.failure.as_ref().is_some_and(|words| words.starts_with("stopped by "));
    if output.status.code().is_some() && !stopped {
        // Renamed into place, so that a record is whole or not there.
        let part = dir.join("run.json.part");
        std::fs::write(&part, serde_json::to_string_pretty(&record)?)?;
        std::fs::rename(part, dir.join("run.json"))?;
    }
    Ok(record)
}

/// Exit status of a program that does not understand its arguments.
const MISREAD: i32 = 2;

/// Arguments that the program does not have, or not with this value, or not together. They are the mistake of the sweep file: no further run is made, and
/// this one leaves no record.
fn misread(name: &str, output: &Output) -> String {
    let words = String::from_utf8_lossy(&output.stderr);
    // The first paragraph says what, the others what might be meant and how it is used.
    let said: Vec<&str> = words.lines().take_while(|line| !line.starts_with("Usage:")).collect();
    let said = said.join(" ").split_whitespace().collect::<Vec<_>>().join(" ");
    let said = said.trim_start_matches("error:").trim();
    format!(
        "{name} does not take these arguments: {said}. Correct the flag in the sweep file; `{name} --help` names all"
    )
}

/// Why a run did not come to its end: its own words.
fn failure(dir: &Path, output: &Output) -> Option<String> {
    let told = Summary::read(dir.join("summary.json")).ok().map(|summary| summary.status);
    if output.status.success() {
        return match told {
            Some(status) if status == "completed" => None,
            Some(status) => Some(status),
            None => Some("it has written no summary.json".to_owned()),
        };
    }
    let words = String::from_utf8_lossy(&output.stderr);
    let line = words.lines().find(|line| line.starts_with("error:")).or_else(|| words.lines().last());
    Some(match (told, line) {
        (Some(status), _) if status != "completed" => status,
        (_, Some(line)) => line.trim_start_matches("error:").trim().to_owned(),
        _ => output.status.to_string(),
    })
}
