//! A whole scene, read and written.

use super::check;
use super::fixed::Fixed;
use super::fluid::Fluid;
use super::outline;
use super::output::Output;
use super::probes::Probe;
use super::region::Point;
use super::solids::Solid;
use super::source::{Problem, SceneError, Source};
use super::suggest::advice;
use super::walls::Wall;
use super::watch::Watch;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A scene: what there is, how it is computed, what is measured and written
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SceneFile {
    /// Title of the pictures
    pub title: String,
    /// Number of dimensions, 2 or 3
    #[serde(default = "two")]
    pub dimension: usize,
    /// Simulated time (s)
    pub end_time: f64,
    /// Acceleration of gravity (m/s2); none if left out
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub gravity: Point,
    /// The fluid; none if left out
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fluid: Option<Fluid>,
    /// Walls for the fluid
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub walls: Vec<Wall>,
    /// Elastic bodies
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub solids: Vec<Solid>,
    /// Rigid bodies at rest whose load is measured
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fixed: Vec<Fixed>,
    /// What is measured besides the energies
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub probes: Vec<Probe>,
    /// What is written
    #[serde(default)]
    pub output: Output,
    /// What a run is watched for
    #[serde(default)]
    pub watch: Watch,
}

fn two() -> usize {
    2
}

/// Nothing yet, in two dimensions: for programs that describe a scene.
impl Default for SceneFile {
    fn default() -> Self {
        Self {
            title: String::new(),
            dimension: two(),
            end_time: 0.0,
            gravity: Vec::new(),
            fluid: None,
            walls: Vec::new(),
            solids: Vec::new(),
            fixed: Vec::new(),
            probes: Vec::new(),
            output: Output::default(),
            watch: Watch::default(),
        }
    }
}

impl SceneFile {
    /// The scene as TOML.
    ///
    /// # Errors
    /// If a number cannot be written.
    pub fn to_toml(&self) -> Result<String, SceneError> {
        toml::to_string_pretty(self).map_err(|error| SceneError::Unwritable { reason: error.to_string() })
    }
}

/// Reads a scene file.
///
/// # Errors
/// If there is no such file, or it is not a scene that can be run: every problem with file, line, column, key and remedy.
pub fn read(path: impl AsRef<Path>) -> Result<(SceneFile, Source), SceneError> {
    let path = path.as_ref();
    let text = std::fs::read_to_string(path)
        .map_err(|error| SceneError::Unreadable { path: path.to_path_buf(), reason: error.to_string() })?;
    let source = Source::new(path.display().to_string(), text);
    Ok((parse(&source)?, source))
}

/// Reads a scene from text; files that belong to it are looked for beside the file the text is named after.
///
/// # Errors
/// As [`read`].
pub fn parse(source: &Source) -> Result<SceneFile, SceneError> {
    let mut scene: SceneFile = toml::from_str(source.text()).map_err(|error| reworded(source, &error))?;
    let unread = outline::load(&mut scene, source);
    if !unread.is_empty() {
        return Err(SceneError::Refused(unread));
    }
    check::check(&scene, source)?;
    Ok(scene)
}

/// The JSON Schema of scene files, for editors that complete and check them.
pub fn schema() -> serde_json::Value {
    schemars::schema_for!(SceneFile).to_value()
}

/// The answer of the TOML library with the key, and with advice.
fn reworded(source: &Source, error: &toml::de::Error) -> Problem {
    let span = error.span().unwrap_or(0..0);
    let key = source.key_at(&span);
    let message = error.message().lines().collect::<Vec<_>>().join(" ");
    // The words of serde: "unknown field `a`, expected one of `b`, `c`", and the same of a variant.
    let mut quoted = message.split('`').skip(1).step_by(2);
    let kind = ["unknown field", "unknown variant", "missing field"]
        .into_iter()
        .find(|kind| message.starts_with(kind));
    match (kind, quoted.next()) {
        (Some("missing field"), Some(missing)) => {
            let what = if key.is_empty() { "the scene".to_owned() } else { String::new() };
            source.problem_at(span, &key, format!("{what} has no `{missing}`").trim_start(), "add it")
        }
        (Some(kind), Some(typed)) => {
            let allowed: Vec<&str> = quoted.collect();
            let what = if kind == "unknown field" { "is no key" } else { "is no choice" };
            let inside =
                if key.is_empty() || key.ends_with(typed) { String::new() } else { format!(" in {key}") };
            source.problem_at(span, typed, format!("{what} here{inside}"), advice(typed, &allowed))
        }
        _ => match message.strip_prefix("invalid type: ").and_then(|rest| rest.split_once(", expected ")) {
            Some((found, wanted)) => {
                source.problem_at(span, &key, format!("is the {found}"), wanted_words(wanted))
            }
            None => source.problem_at(span, &key, message, "see docs/scenes.md for the form of a scene"),
        },
    }
}

/// What to give, from the words of serde.
fn wanted_words(wanted: &str) -> String {
    match wanted {
        "f64" => "give a number".to_owned(),
        "u32" | "usize" => "give a whole number".to_owned(),
        "a sequence" => "give a list, a point as [0.0, 1.0]".to_owned(),
        "a string" => "give a text in double quotes".to_owned(),
        "a boolean" => "give true or false".to_owned(),
        other => format!("give {}", other.replace("struct", "a table with the keys of")),
    }
}
