//! Plots of a run that was made before.

use super::observer::{TABLE, measured};
use super::report::plots;
use crate::Failure;
use mps_io::scene_file::{closest, read};
use mps_io::{CsvTable, CurvePlot, find_table};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Which columns are drawn, and where.
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    /// Names of the columns, with or without their units; none for the plots that a run makes.
    pub columns: Vec<String>,
    /// The column they are drawn over; the first one, the time, if left out.
    pub over: Option<String>,
    /// The picture; `columns.png` in the directory of the run if left out.
    pub picture: Option<PathBuf>,
}

/// Why a plot cannot be drawn.
#[derive(Debug, Error)]
enum Undrawn {
    #[error("{} has no column {name:?}: {advice}", table.display())]
    NoColumn { table: PathBuf, name: String, advice: String },
    #[error("{first:?} and {other:?} have different units, and one plot has one axis: draw them in two")]
    Units { first: String, other: String },
    #[error("{} has no rows yet: wait for the run to write some", table.display())]
    Empty { table: PathBuf },
}

/// Draws the probes of the run in `dir` again, from its table of probes. Returns what the plots are called.
///
/// Without columns the plots are those that the run of a scene makes at its end, for a run that goes on or was killed as well; of other
/// programs, a plot of every column. Columns are drawn into one plot.
///
/// # Errors
/// If there is no such table, or it has no such columns.
pub fn plot(dir: &Path, drawing: &Drawing) -> Result<String, Failure> {
    let (table, path) = find_table(dir, TABLE)?;
    if table.columns.iter().all(Vec::is_empty) {
        return Err(Undrawn::Empty { table: path }.into());
    }
    let scene = dir.join("scene.toml");
    // Other programs have tables, and no scenes.
    let scene = if scene.exists() { Some(read(scene)?.0) } else { None };
    let name = dir.file_name().map_or_else(|| dir.display().to_string(), |name| name.display().to_string());
    let title = scene.as_ref().map_or(name, |scene| scene.title.clone());
    if drawing.columns.is_empty() {
        let measured = if scene.is_some() { measured(&table.names) } else { table.names.len() };
        plots(dir, &title, &table, measured)?;
        return Ok(dir.join("probe_*.png").display().to_string());
    }

    let find = |name: &str| column(&table, name).ok_or_else(|| no_column(&path, &table, name));
    let over = drawing.over.as_deref().map_or(Ok(0), find)?;
    let columns = drawing.columns.iter().map(|name| find(name)).collect::<Result<Vec<usize>, _>>()?;
    let unit = |k: usize| table.names[k].rsplit_once(" [").map_or("-]", |(_, unit)| unit);
    let first = columns.first().copied().unwrap_or(over);
    if let Some(other) = columns.iter().find(|other| unit(**other) != unit(first)) {
        let [first, other] = [first, *other].map(|k| table.names[k].clone());
        return Err(Undrawn::Units { first, other }.into());
    }
    let label = if columns.len() == 1 { table.names[first].clone() } else { format!("[{}", unit(first)) };
    let mut drawn = CurvePlot::new(&title, &table.names[over], &label);
    for k in columns {
        drawn = drawn.line(&table.names[k], &table.columns[over], &table.columns[k]);
    }
    let picture = drawing.picture.clone().unwrap_or_else(|| dir.join("columns.png"));
    drawn.write_png(&picture)?;
    Ok(picture.display().to_string())
}

/// The number of a column by its heading, or by that without its unit.
fn column(table: &CsvTable, name: &str) -> Option<usize> {
    let bare = |heading: &str| heading.rsplit_once(" [").map_or(heading.len(), |(bare, _)| bare.len());
    table.names.iter().position(|heading| heading == name || &heading[..bare(heading)] == name)
}

fn no_column(path: &Path, table: &CsvTable, name: &str) -> Undrawn {
    let bare = table
        .names
        .iter()
        .map(|heading| heading.rsplit_once(" [").map_or(heading.as_str(), |(bare, _)| bare));
    let advice = match closest(name, bare.clone()) {
        Some(meant) => format!("did you mean {meant:?}?"),
        None => format!("there are {}", bare.collect::<Vec<_>>().join(", ")),
    };
    Undrawn::NoColumn { table: path.to_path_buf(), name: name.to_owned(), advice }
}
