//! How far the runs of a series are apart.

use super::table::Probes;
use crate::convergence::{Curve, distance, order};
use crate::{Failure, Refused};
use mps_io::Summary;
use mps_io::number;
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
}

/// What `summary.json` in `dir` says of the spacing \[m\]: the setting of a program, or the scene of the fluid.
fn spacing(dir: &Path) -> Option<f64> {
    let settings = Summary::read(dir.join("summary.json")).ok()?.settings;
    let of_program = settings.get("spacing_m");
    let of_scene = || settings.get("description")?.get("fluid")?.get("spacing");
    of_program.or_else(of_scene)?.as_f64()
}

/// Root mean square distances of columns between each run and the next, and the orders in the spacing that fit each three of them, as a table in
/// Markdown; `-` where there is none. The time is the first column of the tables of probes; `from` and `to` \[s\] are those that all runs have for `None`.
///
/// # Errors
/// If a directory has no such table, it has no such column, or the times are not those of all runs.
pub fn converge(
    dirs: &[PathBuf],
    columns: &[String],
    [from, to]: [Option<f64>; 2],
) -> Result<String, Failure> {
    let runs = dirs.iter().map(|dir| Run::read(dir)).collect::<Result<Vec<_>, _>>()?;
    let window = window(&runs, from, to)?;
    let mut text =
        format!("| {} to {} s |", number(window[0], 4, window[1]), number(window[1], 4, window[1]));
    for pair in names(&runs).windows(2) {
        let _ = write!(text, " {} to {} |", pair[0], pair[1]);
    }
    let _ = writeln!(text, " orders |\n|---|{}---|", "---|".repeat(runs.len() - 1));
    for name in columns {
        let numbers = runs.iter().map(|run| run.probes.column(name)).collect::<Result<Vec<usize>, _>>()?;
        let curves: Vec<Curve<'_>> = runs.iter().zip(&numbers).map(|(run, k)| run.curve(*k)).collect();
        let apart: Vec<Option<f64>> =
            curves.windows(2).map(|pair| distance(&pair[0], &pair[1], window)).collect();
        let _ = write!(text, "| {} |", runs[0].probes.table.names[numbers[0]]);
        for distance in &apart {
            let known = distance.filter(|distance| distance.is_finite());
            let _ = write!(text, " {} |", known.map_or("-".to_owned(), |distance| format!("{distance:.3e}")));
        }
        let _ = writeln!(text, " {} |", orders(&runs, &apart));
    }
    Ok(text)
}

/// The part that is compared \[s\].
fn window(runs: &[Run], from: Option<f64>, to: Option<f64>) -> Result<[f64; 2], Refused> {
    let begin = runs.iter().filter_map(|run| run.time().first().copied()).fold(f64::NEG_INFINITY, f64::max);
    let end = runs.iter().filter_map(|run| run.time().last().copied()).fold(f64::INFINITY, f64::min);
    let all = runs.iter().map(|run| run.name.as_str()).collect::<Vec<_>>().join(", ");
    Refused::unless(begin < end, "DIRECTORIES", all, "these runs have no time in common: give others")?;
    let advice = format!(
        "all runs have rows from {} to {} s: give a time between",
        number(begin, 4, end),
        number(end, 4, end)
    );
    for (flag, time) in [("--from", from), ("--to", to)] {
        let Some(time) = time else { continue };
        Refused::unless((begin..=end).contains(&time), flag, time, advice.clone())?;
    }
    let window = [from.unwrap_or(begin), to.unwrap_or(end)];
    Refused::unless(
        window[0] < window[1],
        "--from",
        window[0],
        format!("give a time before {} s", number(window[1], 4, window[1])),
    )?;
    Ok(window)
}

/// What the runs are called: by their spacings if these tell them apart, by their directories otherwise.
fn names(runs: &[Run]) -> Vec<String> {
    let spacings: Option<Vec<f64>> = runs.iter().map(|run| run.spacing).collect();
    match spacings {
        Some(spacings) if spacings.windows(2).all(|pair| pair[0] != pair[1]) => {
            spacings.iter().map(|l0| format!("{l0:e} m")).collect()
        }
        _ => runs.iter().map(|run| run.name.clone()).collect(),
    }
}

/// The orders of each three runs, one after the other.
fn orders(runs: &[Run], apart: &[Option<f64>]) -> String {
    let of = |three: &[Run], apart: &[Option<f64>]| {
        order([three[0].spacing?, three[1].spacing?, three[2].spacing?], [apart[0]?, apart[1]?])
    };
    let said = |order: Option<f64>| order.map_or("-".to_owned(), |p| format!("{p:.2}"));
    let all: Vec<String> = runs.windows(3).zip(apart.windows(2)).map(|(h, d)| said(of(h, d))).collect();
    if all.is_empty() { "-".to_owned() } else { all.join(", ") }
}
