//! When and where the runs of a table were made: their costs compare only on one machine.

use crate::judge::Row;
use std::fmt;

/// The days and the machines of all runs, each once and in order.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Origin {
    pub(crate) dates: Vec<String>,
    pub(crate) machines: Vec<String>,
    /// Runs that say neither.
    unknown: usize,
}

impl Origin {
    pub(crate) fn of(rows: &[Row]) -> Self {
        let all = |word: fn(&Row) -> Option<&String>| {
            let mut words: Vec<String> = rows.iter().filter_map(word).cloned().collect();
            words.sort_unstable();
            words.dedup();
            words
        };
        let unknown = rows.iter().filter(|row| row.date.is_none() || row.machine.is_none()).count();
        Self { dates: all(|row| row.date.as_ref()), machines: all(|row| row.machine.as_ref()), unknown }
    }
}

impl fmt::Display for Origin {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match (self.dates.first(), self.dates.last()) {
            (Some(first), Some(last)) if first != last => write!(f, "{first} to {last}")?,
            (Some(day), _) => write!(f, "{day}")?,
            _ => write!(f, "on days that are not known")?,
        }
        match &self.machines[..] {
            [] => write!(f, ", on a machine that is not known")?,
            [one] => write!(f, ", {one}")?,
            several => {
                write!(f, ", **on {} machines, whose seconds do not compare**: ", several.len())?;
                write!(f, "{}", several.join("; "))?;
            }
        }
        if self.unknown > 0 && !self.machines.is_empty() {
            write!(f, " ({} runs do not say when and where they were made)", self.unknown)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::front::tests::row;

    #[test]
    fn the_days_and_machines_are_those_of_the_runs() {
        let made = |date: &str, machine: &str| Row {
            date: Some(date.to_owned()),
            machine: Some(machine.to_owned()),
            ..row(1.0, Some(1.0))
        };
        let (old, new) = (made("2026-11-26", "A, 2 cores"), made("2026-11-28", "A, 2 cores"));
        let told = |rows: &[Row]| Origin::of(rows).to_string();
        assert_eq!(told(std::slice::from_ref(&old)), "2026-11-26, A, 2 cores");
        assert_eq!(told(&[new.clone(), old.clone()]), "2026-11-26 to 2026-11-28, A, 2 cores");
        let elsewhere = told(&[old.clone(), made("2026-11-26", "B, 8 cores"), row(1.0, None)]);
        assert!(elsewhere.contains("on 2 machines, whose seconds do not compare**: A, 2 cores; B, 8 cores"));
        assert!(elsewhere.ends_with("(1 runs do not say when and where they were made)"), "{elsewhere}");
        assert_eq!(told(&[]), "on days that are not known, on a machine that is not known");
    }
}
