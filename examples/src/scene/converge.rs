//! How far the runs of a series are apart.

use super::table::Probes;
use crate::convergence::{Curve, distance, order};
use crate::{Failure, Refused};
use mps_io::Summary;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// A run of the series.
struct Run {
    name: String,
    probes: Probes,
    /// Of its particles \[m\], if its summary tells.
    spacing: Option<f64>,
}

impl Run {
    fn read(dir: &Path) -> Result<Self, Failure> {
        let name = dir.file_name().unwrap_or(dir.as_os_str()).to_string_lossy().into_owned();
        Ok(Self { name, probes: Probes::of(dir)?, spacing: spacing(dir) })
    }

    fn time(&self) -> &[f64] {
        &self.probes.table.columns[0]
    }

    fn curve(&self, column: usize) -> Curve<'_> {
        Curve { time: self.time(), value: &self.probes.table.columns[column] }
    }

    fn said(&self) -> String {
        self.spacing.map_or_else(|| self.name.clone(), |l0| format!("{l0:e} m"))
    }
}

/// What `summary.json` in `dir` says of the spacing \[m\]: the setting of a program, or the scene of the fluid.
fn spacing(dir: &Path) -> Option<f64> {
    let settings = Summary::read(dir.join("summary.json")).ok()?.settings;
    let of_program = settings.get("spacing_m");
    let of_scene = || settings.get("description")?.get("fluid")?.get("spacing");
    of_program.or_else(of_scene)?.as_f64()
}

/// Root mean square distances of columns between each run and the next, and the orders in the spacing that fit each three of them, as a table in
/// Markdown. The time is the first column of the tables of probes; `from` and `to` \[s\] are those that all runs have for `None`.
///
/// # Errors
/// If a directory has no such table, it has no such column, or the runs have no time in common.
pub fn converge(
    dirs: &[PathBuf],
    columns: &[String],
    [from, to]: [Option<f64>; 2],
) -> Result<String, Failure> {
    let runs = dirs.iter().map(|dir| Run::read(dir)).collect::<Result<Vec<_>, _>>()?;
    let begin = runs.iter().filter_map(|run| run.time().first().copied()).fold(f64::NEG_INFINITY, f64::max);
    let end = runs.iter().filter_map(|run| run.time().last().copied()).fold(f64::INFINITY, f64::min);
    let window = [from.map_or(begin, |t| t.max(begin)), to.map_or(end, |t| t.min(end))];
    let asked = from.or(to).map_or_else(|| "left out".to_owned(), |t| t.to_string());
    let advice = format!("all runs have rows from {begin:.4} to {end:.4} s: give a time between");
    Refused::unless(window[0] < window[1], if from.is_some() { "--from" } else { "--to" }, asked, advice)?;

    let mut text = format!("| {:.4} to {:.4} s |", window[0], window[1]);
    for pair in runs.windows(2) {
        let _ = write!(text, " {} to {} |", pair[0].said(), pair[1].said());
    }
    let _ = writeln!(text, " orders |\n|---|{}---|", "---|".repeat(runs.len() - 1));
    for name in columns {
        let of = |run: &Run| run.probes.column(name);
        let numbers = runs.iter().map(of).collect::<Result<Vec<usize>, _>>()?;
        let heading = &runs[0].probes.table.names[numbers[0]];
        let curves: Vec<Curve<'_>> = runs.iter().zip(&numbers).map(|(run, k)| run.curve(*k)).collect();
        let apart: Vec<f64> =
            curves.windows(2).map(|pair| distance(&pair[0], &pair[1], window).unwrap_or(f64::NAN)).collect();
        let _ = write!(text, "| {heading} |");
        for distance in &apart {
            let _ = write!(text, " {distance:.3e} |");
        }
        let orders = runs.windows(3).zip(apart.windows(2)).map(|(three, apart)| {
            let h = [three[0].spacing?, three[1].spacing?, three[2].spacing?];
            order(h, [apart[0], apart[1]])
        });
        let orders: Vec<String> =
            orders.map(|order| order.map_or("-".to_owned(), |p| format!("{p:.2}"))).collect();
        let orders = if orders.is_empty() { "-".to_owned() } else { orders.join(", ") };
        let _ = writeln!(text, " {orders} |");
    }
    Ok(text)
}
