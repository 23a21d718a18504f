//! The plots and the summary of a run.

use super::Layout;
use super::columns::stem;
use super::observer::Observer;
use crate::Failure;
use crate::series::extremes;
use mps_io::scene_file::SceneFile;
use mps_io::{CsvTable, CurvePlot, Metric, Summary};
use mps_kernel::Real;
use std::path::Path;

/// A curve of every probe, the first `measured` columns, and one of the energies, the rest.
pub(super) fn plots(dir: &Path, title: &str, table: &CsvTable, measured: usize) -> Result<(), Failure> {
    let CsvTable { names, columns } = table;
    let time = &columns[0];
    for k in 1..measured {
        let name = &names[k];
        CurvePlot::new(title, &names[0], name)
            .line(name, time, &columns[k])
            .write_png(dir.join(format!("{}.png", stem(name))))?;
    }
    // Where zero of a potential lies has no meaning: what counts is the change.
    let unit = names.get(measured).and_then(|total| total.rsplit_once(" [")).map_or("J]", |(_, unit)| unit);
    let mut energies = CurvePlot::new(title, &names[0], &format!("energy since the start [{unit}"));
    let mut changed = false;
    for (name, column) in names.iter().zip(columns).skip(measured) {
        let mut column = column.clone();
        let start = column.first().copied().unwrap_or(0.0);
        column.iter_mut().for_each(|value| *value -= start);
        if let Some((name, its)) = name.rsplit_once(" [")
            && its == unit
            && column.iter().any(|value| *value != 0.0)
        {
            energies = energies.line(name, time, &column);
            changed = true;
        }
    }
    // A run that fails in its first step has no energy that has changed.
    let picture = dir.join("energies.png");
    if changed {
        energies.write_png(picture)?;
    } else {
        // Nor shall that of an earlier run in the same directory be taken for its own.
        let _ = std::fs::remove_file(picture);
    }
    Ok(())
}

/// Settings and results; what the run has cost is entered later.
pub(super) fn summary<T: Real, const D: usize>(
    name: &str,
    scene: &SceneFile,
    layout: &Layout<D>,
    observer: &Observer<T, D>,
) -> Summary {
    let mut summary = Summary::new("mps", env!("CARGO_PKG_VERSION"));
    summary.set("scene", name);
    summary.set("description", scene);
    summary.particles.insert("fluid".into(), layout.fluid_len() as u64);
    summary.particles.insert("wall".into(), layout.walls_len() as u64);
    summary.particles.insert("structure".into(), layout.solids_len() as u64);
    if !scene.fixed.is_empty() {
        summary.particles.insert("fixed".into(), layout.fixed_len() as u64);
    }
    for k in 1..observer.measured {
        let column = observer.column(k);
        let (name, unit) = observer.names[k].rsplit_once(" [").unwrap_or((&observer.names[k], "-]"));
        let mut put = |what: &str, value: f64| {
            let metric = Metric::new(value, unit.trim_end_matches(']'));
            summary.metrics.insert(format!("{name} {what}"), metric);
        };
        if let (Some([low, high]), Some(last)) = (extremes(&column), column.last()) {
            put("smallest", low);
            put("largest", high);
            put("at the end", *last);
        }
    }
    summary
}
