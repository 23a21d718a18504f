//! What a run is watched for.

use super::region::Corners;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a run is watched for, and what becomes of one that fails; every key may be left out
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Watch {
    /// Last steps that the post-mortem of a run tells (-); it begins with a state at least as many steps back
    pub steps: u32,
    /// A step that is shorter than this share of the mean of the last ones has collapsed (-); 0 for not watched
    pub collapse: f64,
    /// The energy of fluid and bodies may rise by this much in a step (J, in two dimensions J/m): more than moving walls and inlets bring; not
    /// watched if left out. Costs a sum over all particles in every step
    #[serde(skip_serializing_if = "Option::is_none")]
    pub energy_rise: Option<f64>,
    /// Largest speed of a fluid particle over the speed of sound beyond which something is said or done (-): compression and the errors of the
    /// pressure go with its square
    pub mach: f64,
    /// What becomes of a run that fails
    pub on_failure: OnFailure,
    /// What becomes of a run whose fluid gets faster than `mach`
    pub on_mach: OnMach,
    /// Where all particles have to stay (m); not watched if left out
    #[serde(skip_serializing_if = "Option::is_none")]
    pub region: Option<Corners>,
}

impl Default for Watch {
    fn default() -> Self {
        Self {
            steps: 50,
            collapse: 0.01,
            energy_rise: None,
            mach: 0.3,
            on_failure: OnFailure::default(),
            on_mach: OnMach::default(),
            region: None,
        }
    }
}

/// What becomes of a run whose fluid gets too fast for its speed of sound
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OnMach {
    /// It goes on; the log and the notes of the summary say it once
    #[default]
    Warn,
    /// It fails
    Stop,
}

/// What becomes of a run that fails
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OnFailure {
    /// It stops, with a post-mortem
    #[default]
    Stop,
    /// It goes back and tries with shorter steps, and stops when that does not help
    Retry(Retry),
}

/// How a run that has failed is tried again; every key may be left out
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Retry {
    /// Steps with half the Courant number, from the failure on; a failure among them halves it again (-)
    pub steps: u32,
    /// How often in a run (-)
    pub times: u32,
}

impl Default for Retry {
    fn default() -> Self {
        Self { steps: 200, times: 3 }
    }
}
