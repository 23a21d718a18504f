//! What was counted before: a table of rows by subject, with a column for each profile.
//!
//! Lines that begin with `#` tell how the columns were counted: `# debug: rustc 1.95.0 (...), AVX2`.

use std::collections::BTreeMap;
use std::fmt::Write;
use thiserror::Error;

/// What is kept of one subject.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    /// Instructions a particle and step, by profile.
    pub instructions: BTreeMap<String, f64>,
    /// Bytes a particle.
    pub bytes: f64,
}

/// The table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// With what each profile was counted.
    pub builds: BTreeMap<String, String>,
    /// In the order of the subjects.
    pub rows: Vec<(String, Row)>,
}

/// What is wrong with a table.
#[derive(Debug, Error)]
#[error(
    "line {line} of the table of counts is '{text}', expected {expected}; write it anew with `count store`"
)]
pub struct TableError {
    line: usize,
    text: String,
    expected: &'static str,
}

const HEAD: &str = "# Instructions a particle and step, and bytes a particle. Written by `count store`, held by `count check`.";
const PROFILES: [&str; 2] = ["debug", "release"];

impl Table {
    /// Reads what [`text`](Self::text) wrote.
    ///
    /// # Errors
    /// If a line is none of such a table.
    pub fn parse(text: &str) -> Result<Self, TableError> {
        let mut table = Self::default();
        for (number, line) in text.lines().enumerate() {
            let fault = |expected| TableError { line: number + 1, text: line.to_owned(), expected };
            if let Some(comment) = line.strip_prefix("# ") {
                if let Some((profile, with)) = comment.split_once(": ").filter(|(p, _)| PROFILES.contains(p))
                {
                    table.builds.insert(profile.to_owned(), with.to_owned());
                }
            } else if !line.starts_with("subject,") {
                let fields: Vec<&str> = line.split(',').collect();
                let [name, counts @ .., bytes] = fields.as_slice() else { return Err(fault("five fields")) };
                if counts.len() != PROFILES.len() {
                    return Err(fault("a name, two counts and bytes"));
                }
                let mut row =
                    Row { bytes: bytes.parse().map_err(|_| fault("bytes last"))?, ..Row::default() };
                for (profile, count) in PROFILES.iter().zip(counts).filter(|(_, count)| !count.is_empty()) {
                    let count = count.parse().map_err(|_| fault("a number of instructions"))?;
                    row.instructions.insert((*profile).to_owned(), count);
                }
                table.rows.push(((*name).to_owned(), row));
            }
        }
        Ok(table)
    }

    /// The table as it is kept.
    pub fn text(&self) -> String {
        let mut text = format!("{HEAD}\n");
        // Writing into a String cannot fail.
        for (profile, with) in &self.builds {
            let _ = writeln!(text, "# {profile}: {with}");
        }
        let _ = writeln!(text, "subject,{},bytes", PROFILES.join(","));
        for (name, row) in &self.rows {
            let _ = write!(text, "{name}");
            for profile in PROFILES {
                let _ = match row.instructions.get(profile) {
                    Some(count) => write!(text, ",{count:.2}"),
                    None => write!(text, ","),
                };
            }
            let _ = writeln!(text, ",{:.1}", row.bytes);
        }
        text
    }

    /// What is kept of a subject.
    pub fn row(&self, name: &str) -> Option<&Row> {
        self.rows.iter().find(|(kept, _)| kept == name).map(|(_, row)| row)
    }
}
