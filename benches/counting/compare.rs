//! What is counted now beside what was counted before.

use super::{Row, Table};
use core::fmt;

/// Share by which a count may differ: more than what a change elsewhere does to the code of a sweep, less than a change of the
/// sweep that somebody would want to know of.
const TOLERANCE: f64 = 0.02;

/// A count that is not what it was.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The subject.
    pub name: String,
    /// What of it.
    pub what: &'static str,
    /// What was kept, if anything.
    pub kept: Option<f64>,
    /// What has been counted, if anything.
    pub now: Option<f64>,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, what, kept, now } = self;
        match (kept, now) {
            (Some(kept), Some(now)) => {
                let verb = if now > kept { "rose" } else { "fell" };
                let percent = 100.0 * (now / kept - 1.0);
                write!(f, "{name}: {what} {verb} from {kept:.2} to {now:.2} a particle ({percent:+.1} %)")
            }
            (None, Some(now)) => write!(f, "{name}: {what} {now:.2} a particle, never counted before"),
            (_, None) => write!(f, "{name}: {what} kept, but nothing of this name is counted"),
        }
    }
}

/// Every count of a profile that differs by more than 2 %, is new or is gone.
pub fn differences(kept: &Table, now: &Table, profile: &str) -> Vec<Difference> {
    let mut found = Vec::new();
    let mut compare = |name: &str, what, before: Option<f64>, after: Option<f64>| {
        let same = match (before, after) {
            (Some(before), Some(after)) => (after - before).abs() <= TOLERANCE * before,
            (before, after) => before == after,
        };
        if !same {
            found.push(Difference { name: name.to_owned(), what, kept: before, now: after });
        }
    };
    let instructions = |row: &Row| row.instructions.get(profile).copied();
    for (name, row) in &now.rows {
        let before = kept.row(name);
        compare(name, "instructions", before.and_then(instructions), instructions(row));
        compare(name, "bytes", before.map(|row| row.bytes), Some(row.bytes));
    }
    for (name, row) in kept.rows.iter().filter(|(name, _)| now.row(name).is_none()) {
        compare(name, "instructions", instructions(row), None);
    }
    found
}
