//! The sweep file: which program, with which settings, and what counts.

use mps_examples::{Failure, Refused};
use serde::Deserialize;
use std::path::Path;
use toml::{Table, Value};

/// What a sweep file says.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sweep {
    /// Heading of table and plot.
    pub(crate) title: String,
    /// The program of the case, e.g. `cantilever`.
    pub(crate) program: String,
    /// Flags of all runs, without their dashes; a flag without a value is `true` or `false`.
    #[serde(default)]
    pub(crate) base: Table,
    /// Flags that change; a list stands for one run with each of its values, several lists for all combinations.
    pub(crate) vary: Vec<Table>,
    /// What is held against the reference.
    pub(crate) counts: Vec<Count>,
    /// Results that are shown in the table and do not count.
    #[serde(default)]
    pub(crate) also: Vec<String>,
    /// A flag whose values are told apart in the plot.
    #[serde(default)]
    pub(crate) group: Option<String>,
}

/// A result that counts.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Count {
    /// Its name in `summary.json`, where it has a reference.
    pub(crate) metric: String,
    /// The error that is good enough \[-\], relative as in `summary.json`.
    pub(crate) tolerance: f64,
    /// How well the reference is known \[-\], relative: an error below counts as this much, so that no run wins by chance.
    #[serde(default)]
    pub(crate) uncertainty: f64,
}

/// One run to be made.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Setting {
    /// What is special about it.
    pub(crate) label: String,
    /// Value of the flag that groups the plot.
    pub(crate) group: String,
    /// Arguments of the program.
    pub(crate) arguments: Vec<String>,
}

impl Setting {
    /// Name of its directory.
    pub(crate) fn directory(&self) -> String {
        let kept = |c: char| if c.is_alphanumeric() || matches!(c, '.' | '-') { c } else { '_' };
        self.label.replace(", ", "_").chars().map(kept).collect()
    }
}

impl Sweep {
    /// Reads and checks a sweep file.
    pub(crate) fn read(path: &Path) -> Result<Self, Failure> {
        let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
        Self::parse(&text).map_err(|error| format!("{}: {error}", path.display()).into())
    }

    fn parse(text: &str) -> Result<Self, Failure> {
        let sweep: Self = toml::from_str(text)?;
        let plain =
            !sweep.program.is_empty() && sweep.program.chars().all(|c| c.is_alphanumeric() || c == '-');
        let remedy = "name a program that lies beside this one, e.g. cantilever";
        Refused::unless(plain, "program", &sweep.program, remedy)?;
        let remedy = "name at least one result of summary.json that has a reference";
        Refused::unless(!sweep.counts.is_empty(), "counts", "empty", remedy)?;
        for count in &sweep.counts {
            let (tolerance, uncertainty) = (count.tolerance, count.uncertainty);
            let remedy = "give the relative error that is good enough, e.g. 0.02";
            Refused::unless(tolerance.is_finite() && tolerance > 0.0, "tolerance", tolerance, remedy)?;
            let remedy = "give how well the reference is known, less than the tolerance";
            Refused::unless((0.0..tolerance).contains(&uncertainty), "uncertainty", uncertainty, remedy)?;
        }
        Ok(sweep)
    }

    /// All runs, in the order of the file; one that comes twice is made once.
    pub(crate) fn settings(&self) -> Result<Vec<Setting>, Refused> {
        let mut settings: Vec<Setting> = Vec::new();
        for vary in &self.vary {
            for changed in combinations(vary) {
                let setting = self.setting(&changed)?;
                if settings.iter().all(|known| known.arguments != setting.arguments) {
                    settings.push(setting);
                }
            }
        }
        let remedy = "give at least one [[vary]] with the flags of its runs";
        Refused::unless(!settings.is_empty(), "vary", "empty", remedy)?;
        Ok(settings)
    }

    fn setting(&self, changed: &Table) -> Result<Setting, Refused> {
        let mut flags = self.base.clone();
        flags.extend(changed.clone());
        let mut arguments = Vec::new();
        for (flag, value) in &flags {
            arguments.extend(argument(flag, value)?);
        }
        let words: Vec<String> = changed.iter().map(|(flag, value)| word(flag, value)).collect();
        let label = if words.is_empty() { "base".to_owned() } else { words.join(", ") };
        let group = self.group.as_ref().and_then(|group| Some(word(group, flags.get(group)?)));
        Ok(Setting { label, group: group.unwrap_or_default(), arguments })
    }
}

/// Every choice of one value from each list.
fn combinations(vary: &Table) -> Vec<Table> {
    vary.iter().fold(vec![Table::new()], |tables, (flag, values)| {
        let values = values.as_array().cloned().unwrap_or_else(|| vec![values.clone()]);
        let with = |table: &Table, value: &Value| {
            let mut table = table.clone();
            table.insert(flag.clone(), value.clone());
            table
        };
        tables.iter().flat_map(|table| values.iter().map(move |value| with(table, value))).collect()
    })
}

/// The argument that a flag and its value stand for; none if it is switched off.
fn argument(flag: &str, value: &Value) -> Result<Option<String>, Refused> {
    match value {
        Value::Boolean(on) => Ok(on.then(|| format!("--{flag}"))),
        Value::Integer(_) | Value::Float(_) | Value::String(_) => {
            Ok(Some(format!("--{flag}={}", plain(value))))
        }
        _ => {
            let remedy = format!("the flag {flag} needs a number, a text, true, false or a list of these");
            Err(Refused { flag: "value", value: value.to_string(), remedy })
        }
    }
}

/// As it is said in labels.
fn word(flag: &str, value: &Value) -> String {
    match value {
        Value::Boolean(true) => flag.to_owned(),
        Value::Boolean(false) => format!("not {flag}"),
        value => format!("{flag} {}", plain(value)),
    }
}

fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Float(number) => number.to_string(),
        value => value.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SWEEP: &str = r#"
        title = "t"
        program = "cantilever"
        group = "across"
        counts = [{ metric = "period", tolerance = 0.01 }]
        [base]
        threads = 1
        convergence = false
        [[vary]]
        across = [4, 8]
        [[vary]]
        across = 4
        precision = ["f64", "f32"]
        quiet = [false, true]
        [[vary]]
        across = [8]
    "#;

    #[test]
    fn lists_are_combined_and_what_comes_twice_is_run_once() {
        let settings = Sweep::parse(SWEEP).unwrap().settings().unwrap();
        let labels: Vec<&str> = settings.iter().map(|s| s.label.as_str()).collect();
        let four = "across 4, precision";
        let expected = ["across 4".to_owned(), "across 8".to_owned()].into_iter().chain(
            ["f64, not quiet", "f64, quiet", "f32, not quiet", "f32, quiet"]
                .map(|end| format!("{four} {end}")),
        );
        assert_eq!(labels, expected.collect::<Vec<_>>());
        assert_eq!(settings[3].arguments, ["--across=4", "--precision=f64", "--quiet", "--threads=1"]);
        assert_eq!(settings[3].group, "across 4");
        assert_eq!(settings[3].directory(), "across_4_precision_f64_quiet");
    }

    #[test]
    fn mistakes_are_told_with_their_place() {
        let cases = [
            (SWEEP.replace("program", "progam"), "progam"),
            (SWEEP.replace("\"cantilever\"", "\"/bin/sh\""), "program is /bin/sh"),
            (SWEEP.replace("tolerance = 0.01", "tolerance = 0.0"), "tolerance is 0"),
            (SWEEP.replace("0.01 }", "0.01, uncertainty = 0.02 }"), "uncertainty is 0.02"),
            (SWEEP.replace("across = 4", "across = [[4]]"), "the flag across needs"),
        ];
        for (text, expected) in cases {
            let refused = |text: &str| Ok::<_, Failure>(Sweep::parse(text)?.settings()?);
            let words = refused(&text).unwrap_err().to_string();
            assert!(words.contains(expected), "{words}");
        }
    }
}
