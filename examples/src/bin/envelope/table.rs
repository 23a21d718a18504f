//! The map as files: envelope.json and envelope.csv for programs, envelope.md for people.

use crate::border::{Border, Breaks, Trial};
use crate::search::Found;
use mps_examples::Failure;
use mps_io::Value;
use std::fmt::Write as _;
use std::path::Path;

/// Columns of the table for people.
const HEAD: &str = "| border | parameter | fine at | broken at | predicted | how it breaks | why | remedy |\n|---|---|---|---|---|---|---|---|\n";

/// All that has been found so far.
pub(crate) struct Table {
    quick: bool,
    rows: Vec<Value>,
    csv: String,
    markdown: String,
    moved: Vec<&'static str>,
}

impl Table {
    pub(crate) fn new(quick: bool) -> Self {
        let csv = "border,parameter,fine,broken,predicted,breaks,as_known\n".to_owned();
        Self { quick, rows: Vec::new(), csv, markdown: HEAD.to_owned(), moved: Vec::new() }
    }

    /// Borders that are not where they are written down.
    pub(crate) fn moved(&self) -> &[&'static str] {
        &self.moved
    }

    /// Adds a border.
    ///
    /// # Errors
    /// If the prediction cannot be made.
    pub(crate) fn add(&mut self, border: &Border, found: Found) -> Result<(), Failure> {
        let predicted = border.predicted.map(|predict| predict()).transpose()?;
        let Border { name, parameter, measure, bound, breaks, mechanism, remedy, .. } = border;
        let Found { fine, broken, as_known } = found;
        if !as_known {
            self.moved.push(name);
        }
        let list = |trials: &[Trial]| trials.iter().map(|trial| digits(trial.value)).collect::<Vec<_>>();
        let fine_at = list(&fine);
        let broken_at = broken.as_ref().map_or_else(String::new, |trial| digits(trial.value));
        let theory = predicted.map_or_else(String::new, digits);
        let how = breaks.name();
        // Writing into a String cannot fail.
        let _ = writeln!(
            self.csv,
            "{name},\"{parameter}\",{},{broken_at},{theory},{how},{as_known}",
            fine_at.join(" ")
        );
        let broken_when = match breaks {
            Breaks::Nothing => how.to_owned(),
            Breaks::Refusal => format!("{how}: the run ends with an error"),
            _ => format!("{how}: {measure} > {}", digits(*bound)),
        };
        let _ = writeln!(
            self.markdown,
            "| {name} | {parameter} | {} | {} | {} | {broken_when} | {mechanism} | {remedy} |",
            fine_at.join(", "),
            or_dash(broken_at),
            or_dash(theory),
        );
        self.rows.push(object([
            ("border", (*name).into()),
            ("parameter", (*parameter).into()),
            ("measure", (*measure).into()),
            ("bound", (*bound).into()),
            ("fine", fine.iter().map(trial).collect::<Vec<_>>().into()),
            ("broken", broken.as_ref().map_or(Value::Null, trial)),
            ("predicted", predicted.map_or(Value::Null, Value::from)),
            ("breaks", how.into()),
            ("mechanism", (*mechanism).into()),
            ("remedy", (*remedy).into()),
            ("as_known", as_known.into()),
        ]));
        Ok(())
    }

    /// Writes the three files.
    ///
    /// # Errors
    /// If one cannot be written.
    pub(crate) fn write(&self, dir: &Path) -> Result<(), Failure> {
        let json = object([
            ("program", "envelope".into()),
            ("version", env!("CARGO_PKG_VERSION").into()),
            ("quick", self.quick.into()),
            ("borders", self.rows.clone().into()),
        ]);
        std::fs::write(dir.join("envelope.json"), format!("{json:#}\n"))?;
        std::fs::write(dir.join("envelope.csv"), &self.csv)?;
        std::fs::write(dir.join("envelope.md"), &self.markdown)?;
        Ok(())
    }
}

fn object<const N: usize>(fields: [(&str, Value); N]) -> Value {
    fields.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}

fn trial(trial: &Trial) -> Value {
    let (measure, failure) = match &trial.measure {
        Ok(measure) => (Value::from(*measure), Value::Null),
        Err(failure) => (Value::Null, failure.as_str().into()),
    };
    object([("value", trial.value.into()), ("measure", measure), ("failure", failure)])
}

/// Four digits, plain where that is short.
fn digits(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    let plain = rounded == 0.0 || (1e-3..1e5).contains(&rounded.abs());
    if plain { format!("{rounded}") } else { format!("{rounded:e}") }
}

fn or_dash(text: String) -> String {
    if text.is_empty() { "-".to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let written = [0.0, 1.0, 2.0 / 3.0, 123_456.0, 1.5e-7].map(digits);
        assert_eq!(written, ["0", "1", "0.6667", "1.235e5", "1.5e-7"]);
    }
}
