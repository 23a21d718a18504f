//! What is written, where and how often.

use super::choice::{Field, FieldForm, FieldPrecision, ProbeForm};
use super::region::{Corners, Region};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What is written; every key may be left out
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Output {
    /// Directory; `out/` and the name of the scene file if left out
    #[serde(skip_serializing_if = "Option::is_none")]
    pub directory: Option<String>,
    /// Time between two rows of the table of probes (s); an 800th of the run if left out. Of bodies alone film, fields and pictures are no closer
    #[serde(skip_serializing_if = "Option::is_none")]
    pub probe_interval: Option<f64>,
    /// Form of the table of probes; `"csv"` if left out
    #[serde(skip_serializing_if = "Option::is_none")]
    pub probe_form: Option<ProbeForm>,
    /// Time between two frames of the film (s); a 100th of the run if left out, 0 for no film
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frame_interval: Option<f64>,
    /// Time between two frames of the fields for ParaView (s); a 40th of the run if left out, 0 for none
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field_interval: Option<f64>,
    /// Fields that are written for ParaView; all if left out, an empty list for places alone
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fields: Option<Vec<Field>>,
    /// Only particles in this region are written for ParaView; all if left out
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field_region: Option<Region>,
    /// Precision of the numbers for ParaView; `"f32"` if left out
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field_precision: Option<FieldPrecision>,
    /// Form of the files for ParaView; `"vtu"` if left out
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field_form: Option<FieldForm>,
    /// Time between two pictures (s); a tenth of the run if left out, 0 for none
    #[serde(skip_serializing_if = "Option::is_none")]
    pub picture_interval: Option<f64>,
    /// What the pictures show (m); everything that is there at the start if left out
    #[serde(skip_serializing_if = "Option::is_none")]
    pub view: Option<Corners>,
    /// Pressure at the upper end of the colours (Pa); if left out the largest at the start, or where there is none
    /// the stagnation pressure of a tenth of the sound speed
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pressure_scale: Option<f64>,
    /// Principal strain at the upper end of the colours (-); 0.1 if left out
    #[serde(skip_serializing_if = "Option::is_none")]
    pub strain_scale: Option<f64>,
}

impl Output {
    /// Those of these fields that are written.
    pub fn chosen(&self, fields: &[Field]) -> Vec<Field> {
        let wanted = |field: &Field| self.fields.as_ref().is_none_or(|chosen| chosen.contains(field));
        fields.iter().copied().filter(wanted).collect()
    }

    /// The intervals \[s\] of rows, film, fields and pictures of a run of `end` seconds; 0 for never.
    pub fn intervals(&self, end: f64) -> [f64; 4] {
        [
            self.probe_interval.unwrap_or(end / 800.0),
            self.frame_interval.unwrap_or(end / 100.0),
            self.field_interval.unwrap_or(end / 40.0),
            self.picture_interval.unwrap_or(end / 10.0),
        ]
    }
}
