//! The results as rows: validation.json for programs, validation.md for people.

use mps_examples::Failure;
use mps_examples::exact::{Case, Measure, Outcome, observed_order};
use mps_io::Value;
use std::fmt::Write as _;
use std::path::Path;

/// All that has been measured so far.
pub(crate) struct Table {
    part: &'static str,
    quick: bool,
    cases: Vec<CaseResults>,
}

struct CaseResults {
    name: &'static str,
    about: &'static str,
    resolution: &'static str,
    rows: Vec<Row>,
    seconds: f64,
}

struct Row {
    resolution: usize,
    /// A run that broke off has a sentence instead.
    result: Result<Measure, String>,
    order: Option<f64>,
}

impl Row {
    /// Whether the target is met; `None` if none is set at this resolution.
    fn met(&self) -> Option<bool> {
        let measure = self.result.as_ref().ok()?;
        let target = measure.target.filter(|target| self.resolution >= target.from)?;
        // A NaN meets nothing.
        Some(measure.error().abs() <= target.error)
    }
}

impl Table {
    pub(crate) fn new(part: &'static str, quick: bool) -> Self {
        Self { part, quick, cases: Vec::new() }
    }

    /// Adds the runs of a case, which took `seconds` together.
    pub(crate) fn add(&mut self, case: &dyn Case, runs: &[(usize, Result<Outcome, Failure>)], seconds: f64) {
        let mut rows: Vec<Row> = Vec::new();
        for (resolution, run) in runs {
            let resolution = *resolution;
            match run {
                Ok(outcome) => rows.extend(outcome.measures.iter().map(|measure| {
                    let result = Ok(measure.clone());
                    Row { resolution, result, order: None }
                })),
                Err(failure) => {
                    rows.push(Row { resolution, result: Err(failure.to_string()), order: None });
                }
            }
        }
        // The same metric side by side, coarsest first.
        let metrics: Vec<&str> = rows.iter().filter_map(|r| Some(r.result.as_ref().ok()?.metric)).collect();
        rows.sort_by_key(|row| {
            let metric = row.result.as_ref().map_or("", |measure| measure.metric);
            (metrics.iter().position(|m| *m == metric).unwrap_or(usize::MAX), row.resolution)
        });
        for k in 1..rows.len() {
            if let (Ok(coarse), Ok(fine)) = (&rows[k - 1].result, &rows[k].result)
                && coarse.metric == fine.metric
            {
                let errors = (coarse.error(), fine.error());
                rows[k].order =
                    observed_order((rows[k - 1].resolution, errors.0), (rows[k].resolution, errors.1));
            }
        }
        let (name, about, resolution) = (case.name(), case.about(), case.resolution());
        self.cases.push(CaseResults { name, about, resolution, rows, seconds });
    }

    /// The runs that broke off: case and resolution.
    pub(crate) fn broken(&self) -> Vec<String> {
        let rows = self.cases.iter().flat_map(|case| case.rows.iter().map(move |row| (case.name, row)));
        let broken = rows.filter(|(_, row)| row.result.is_err());
        broken.map(|(name, row)| format!("{name} at {}", row.resolution)).collect()
    }

    /// Writes both files.
    pub(crate) fn write(&self, dir: &Path) -> Result<(), Failure> {
        std::fs::write(dir.join("validation.json"), format!("{:#}\n", self.json()))?;
        std::fs::write(dir.join("validation.md"), self.markdown())?;
        Ok(())
    }

    fn json(&self) -> Value {
        let rows: Vec<Value> =
            self.cases.iter().flat_map(|case| case.rows.iter().map(|row| json_row(case, row))).collect();
        object([
            ("program", "validate".into()),
            ("part", self.part.into()),
            ("version", env!("CARGO_PKG_VERSION").into()),
            ("quick", self.quick.into()),
            ("rows", rows.into()),
        ])
    }

    fn markdown(&self) -> String {
        let mut text = String::new();
        for case in &self.cases {
            // Writing into a String cannot fail.
            let _ = writeln!(text, "## {}\n\n{}\n", case.name, case.about);
            let _ = writeln!(
                text,
                "| metric | {} | value | reference | error | order | target | reference from |\n|---|---|---|---|---|---|---|---|",
                case.resolution
            );
            for row in &case.rows {
                text += &markdown_row(row);
            }
            let _ = writeln!(text, "\n{:.0} s\n", case.seconds);
        }
        text
    }
}

fn object<const N: usize>(fields: [(&str, Value); N]) -> Value {
    fields.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}

fn json_row(case: &CaseResults, row: &Row) -> Value {
    let head = [("case", case.name.into()), ("resolution", row.resolution.into())];
    match &row.result {
        Err(failure) => object([head[0].clone(), head[1].clone(), ("failure", failure.as_str().into())]),
        Ok(measure) => object([
            head[0].clone(),
            head[1].clone(),
            ("resolution_is", case.resolution.into()),
            ("metric", measure.metric.into()),
            ("unit", measure.unit.into()),
            ("value", measure.value.into()),
            ("reference", measure.exact.into()),
            ("reference_source", measure.source.into()),
            ("error", measure.error().into()),
            ("observed_order", row.order.map_or(Value::Null, Value::from)),
            ("target", measure.target.map_or(Value::Null, |target| target.error.into())),
            ("met", row.met().map_or(Value::Null, Value::from)),
        ]),
    }
}

fn markdown_row(row: &Row) -> String {
    let n = row.resolution;
    match &row.result {
        Err(failure) => format!("| broke off | {n} | {failure} | | | | | |\n"),
        Ok(measure) => {
            let error = measure.error();
            let error = match measure.exact {
                0.0 => format!("{error:.2e}"),
                _ => format!("{:+.2} %", error * 100.0),
            };
            let order = row.order.map_or(String::new(), |order| format!("{order:.1}"));
            let target = match (measure.target, row.met()) {
                (Some(target), Some(met)) => {
                    format!("{:.0e}, {}", target.error, if met { "met" } else { "**missed**" })
                }
                _ => String::new(),
            };
            format!(
                "| {} ({}) | {n} | {:.5e} | {:.5e} | {error} | {order} | {target} | {} |\n",
                measure.metric, measure.unit, measure.value, measure.exact, measure.source
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solid;

    #[test]
    fn runs_that_broke_off_are_told() {
        let case = &solid::cases()[0];
        let mut table = Table::new("solid", true);
        let good = Measure::new("stress", "Pa", 1.0, 1.0, "none");
        table.add(case.as_ref(), &[(4, Ok(Outcome::new(vec![good], Vec::new())))], 1.0);
        assert!(table.broken().is_empty());
        table.add(case.as_ref(), &[(8, Err("it burst".into()))], 1.0);
        assert_eq!(table.broken(), [format!("{} at 8", case.name())]);
    }
}
