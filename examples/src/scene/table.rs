//! The table of a run that was made before, and its columns by name.

use super::observer::TABLE;
use mps_io::scene_file::closest;
use mps_io::{CsvTable, OutputError, find_table};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// The table of probes of a run.
pub(super) struct Probes {
    path: PathBuf,
    pub(super) table: CsvTable,
}

/// Why there is nothing to be read from a table.
#[derive(Debug, Error)]
pub(super) enum Unread {
    #[error("{} has no column {name:?}: {advice}", table.display())]
    NoColumn { table: PathBuf, name: String, advice: String },
    #[error("{} has no rows yet: wait for the run to write some", table.display())]
    Empty { table: PathBuf },
    #[error(transparent)]
    Output(#[from] OutputError),
}

impl Probes {
    /// The table of the run in `dir`, which has rows.
    pub(super) fn of(dir: &Path) -> Result<Self, Unread> {
        let (table, path) = find_table(dir, TABLE)?;
        if table.columns.iter().all(Vec::is_empty) {
            return Err(Unread::Empty { table: path });
        }
        Ok(Self { path, table })
    }

    /// The number of a column by its heading, or by that without its unit.
    pub(super) fn column(&self, name: &str) -> Result<usize, Unread> {
        let names = &self.table.names;
        let found = names.iter().position(|heading| heading == name || bare(heading) == name);
        found.ok_or_else(|| {
            let advice = match closest(name, names.iter().map(|heading| bare(heading))) {
                Some(meant) => format!("did you mean {meant:?}?"),
                None => format!(
                    "there are {}",
                    names.iter().map(|heading| bare(heading)).collect::<Vec<_>>().join(", ")
                ),
            };
            Unread::NoColumn { table: self.path.clone(), name: name.to_owned(), advice }
        })
    }
}

/// A heading without its unit.
fn bare(heading: &str) -> &str {
    heading.rsplit_once(" [").map_or(heading, |(bare, _)| bare)
}
