//! Plots of a run that was made before.

use super::observer::measured;
use super::report::plots;
use super::table::Probes;
use crate::Failure;
use mps_io::CurvePlot;
use mps_io::scene_file::read;
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
#[error("{first:?} and {other:?} have different units, and one plot has one axis: draw them in two")]
struct Units {
    first: String,
    other: String,
}

/// Draws the probes of the run in `dir` again, from its table of probes. Returns what the plots are called.
///
/// Without columns the plots are those that the run of a scene makes at its end, for a run that goes on or was killed as well; of other
/// programs, a plot of every column. Columns are drawn into one plot.
///
/// # Errors
/// If there is no such table, or it has no such columns.
pub fn plot(dir: &Path, drawing: &Drawing) -> Result<String, Failure> {
    let probes = Probes::of(dir)?;
    let table = &probes.table;
    let scene = dir.join("scene.toml");
    // Other programs have tables, and no scenes.
    let scene = if scene.exists() { Some(read(scene)?.0) } else { None };
    let name = dir.file_name().map_or_else(|| dir.display().to_string(), |name| name.display().to_string());
    let title = scene.as_ref().map_or(name, |scene| scene.title.clone());
    if drawing.columns.is_empty() {
        let measured = if scene.is_some() { measured(&table.names) } else { table.names.len() };
        plots(dir, &title, table, measured)?;
        return Ok(dir.join("probe_*.png").display().to_string());
    }

    let over = drawing.over.as_deref().map_or(Ok(0), |name| probes.column(name))?;
    let columns =
        drawing.columns.iter().map(|name| probes.column(name)).collect::<Result<Vec<usize>, _>>()?;
    let unit = |k: usize| table.names[k].rsplit_once(" [").map_or("-]", |(_, unit)| unit);
    let first = columns.first().copied().unwrap_or(over);
    if let Some(other) = columns.iter().find(|other| unit(**other) != unit(first)) {
        let [first, other] = [first, *other].map(|k| table.names[k].clone());
        return Err(Units { first, other }.into());
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
