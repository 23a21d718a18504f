//! `summary.json`: what ran, how long it took, what came out and how far it is from the reference.

mod memory;
mod number;

use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
pub use serde_json::Value;

use crate::OutputError;
use crate::directory::write_atomically;

pub use memory::peak_memory_bytes;

/// The record of one run, for people, for tests and for tables of many runs.
///
/// JSON knows no NaN and no infinity. They are written as `null`, and `notes` says which.
///
/// ```
/// use mps_io::{Metric, Summary};
/// let mut summary = Summary::new("dam_break", "0.1.0");
/// summary.set("particle_distance_m", 0.005);
/// summary.particles.insert("fluid".to_owned(), 20_000);
/// summary.measure(1200, 34.5, 0.6);
/// let front = Metric::new(0.52, "m").compared_with(0.5, "Martin and Moyce 1952, figure 3");
/// assert!((front.error.unwrap() - 0.04).abs() < 1e-12);
/// summary.metrics.insert("front at 0.2 s".to_owned(), front);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// Name of the program.
    pub program: String,
    /// Version of the program.
    pub version: String,
    /// Every setting that shaped the result, by name.
    #[serde(default)]
    pub settings: BTreeMap<String, Value>,
    /// Number of particles of each kind.
    #[serde(default)]
    pub particles: BTreeMap<String, u64>,
    /// Time steps done.
    pub steps: u64,
    /// Duration of the run (s).
    #[serde(with = "number")]
    pub wall_seconds: f64,
    /// Duration of the run for one second of simulated time.
    #[serde(with = "number")]
    pub wall_seconds_per_simulated_second: f64,
    /// Particles times steps, divided by the duration.
    #[serde(with = "number")]
    pub particle_steps_per_second: f64,
    /// Largest resident memory of the process (bytes); `None` where the system does not tell.
    pub peak_memory_bytes: Option<u64>,
    /// Threads used.
    pub threads: usize,
    /// The scalar type: `"f64"` or `"f32"`.
    pub precision: String,
    /// `"completed"`, or a sentence about the failure.
    pub status: String,
    /// Results by name.
    #[serde(default)]
    pub metrics: BTreeMap<String, Metric>,
    /// Remarks, among them numbers that JSON cannot hold.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// One result and its distance from a reference.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Metric {
    /// The value in `unit`.
    #[serde(with = "number")]
    pub value: f64,
    /// SI unit, `"-"` for a plain number.
    pub unit: String,
    /// What it should be, in the same unit.
    #[serde(default, with = "number::optional", skip_serializing_if = "Option::is_none")]
    pub reference: Option<f64>,
    /// Where the reference is from: paper and figure, or formula.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reference_source: Option<String>,
    /// Relative deviation `(value - reference) / |reference|`; `value` itself if the reference is 0.
    #[serde(default, with = "number::optional", skip_serializing_if = "Option::is_none")]
    pub error: Option<f64>,
}

impl Metric {
    /// A result without a reference.
    pub fn new(value: f64, unit: &str) -> Self {
        Self { value, unit: unit.to_owned(), reference: None, reference_source: None, error: None }
    }

    /// Adds the reference and the relative deviation from it.
    pub fn compared_with(self, reference: f64, source: &str) -> Self {
        let scale = if reference == 0.0 { 1.0 } else { reference.abs() };
        let error = Some((self.value - reference) / scale);
        Self { reference: Some(reference), reference_source: Some(source.to_owned()), error, ..self }
    }
}

impl Summary {
    /// A summary of a run that has done nothing yet: no steps, one thread, `f64`, "completed".
    pub fn new(program: &str, version: &str) -> Self {
        Self {
            program: program.to_owned(),
            version: version.to_owned(),
            settings: BTreeMap::new(),
            particles: BTreeMap::new(),
            steps: 0,
            wall_seconds: 0.0,
            wall_seconds_per_simulated_second: 0.0,
            particle_steps_per_second: 0.0,
            peak_memory_bytes: None,
            threads: 1,
            precision: "f64".to_owned(),
            status: "completed".to_owned(),
            metrics: BTreeMap::new(),
            notes: Vec::new(),
        }
    }

    /// Records a setting: a number, a text, a list, or anything that serde can serialise.
    ///
    /// What cannot be serialised is left out with a note, because a summary is written after the
    /// run and must not be lost for a setting.
    pub fn set(&mut self, name: &str, value: impl Serialize) {
        match serde_json::to_value(value) {
            Ok(value) => {
                if has_null(&value) {
                    self.notes
                        .push(format!("settings.{name}: null stands for absent or not a finite number"));
                }
                self.settings.insert(name.to_owned(), value);
            }
            Err(error) => self.notes.push(format!("settings.{name} is left out: {error}")),
        }
    }

    /// Fills in the speed and the memory: call it after `particles` is filled and the run is over.
    ///
    /// `wall_seconds` is the duration of the run, `simulated_seconds` the time it covered.
    pub fn measure(&mut self, steps: u64, wall_seconds: f64, simulated_seconds: f64) {
        let particles: u64 = self.particles.values().sum();
        self.steps = steps;
        self.wall_seconds = wall_seconds;
        self.wall_seconds_per_simulated_second = wall_seconds / simulated_seconds;
        self.particle_steps_per_second = particles as f64 * steps as f64 / wall_seconds;
        self.peak_memory_bytes = peak_memory_bytes();
    }

    /// Writes `summary.json` into `dir`, whole or not at all, and returns its path.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, dir: impl AsRef<Path>) -> Result<PathBuf, OutputError> {
        let path = dir.as_ref().join("summary.json");
        let mut complete = self.clone();
        complete.notes.extend(self.unspeakable());
        let text = serde_json::to_string_pretty(&complete)
            .map_err(|error| OutputError::Summary { path: path.clone(), reason: error.to_string() })?;
        write_atomically(&path, |file| {
            file.write_all(text.as_bytes())?;
            file.write_all(b"\n")
        })?;
        Ok(path)
    }

    /// Reads a `summary.json`; a `null` where a number should be becomes NaN.
    ///
    /// # Errors
    /// The file cannot be read or is not a summary.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, OutputError> {
        let path = path.as_ref();
        let text = std::fs::read_to_string(path).map_err(OutputError::file("read", path))?;
        serde_json::from_str(&text)
            .map_err(|error| OutputError::Summary { path: path.to_path_buf(), reason: error.to_string() })
    }

    /// A note for every number that JSON cannot hold.
    fn unspeakable(&self) -> Vec<String> {
        let mut numbers = vec![
            ("wall_seconds".to_owned(), self.wall_seconds),
            ("wall_seconds_per_simulated_second".to_owned(), self.wall_seconds_per_simulated_second),
            ("particle_steps_per_second".to_owned(), self.particle_steps_per_second),
        ];
        for (name, metric) in &self.metrics {
            numbers.push((format!("metrics.{name}.value"), metric.value));
            numbers.extend(metric.reference.map(|x| (format!("metrics.{name}.reference"), x)));
            numbers.extend(metric.error.map(|x| (format!("metrics.{name}.error"), x)));
        }
        numbers.retain(|(_, number)| !number.is_finite());
        numbers.iter().map(|(name, number)| format!("{name} is {number}, written as null")).collect()
    }
}

fn has_null(value: &Value) -> bool {
    match value {
        Value::Null => true,
        Value::Array(values) => values.iter().any(has_null),
        Value::Object(map) => map.values().any(has_null),
        _ => false,
    }
}
