//! The work-precision plot: error over cost, both logarithmic.

use crate::front::front;
use crate::judge::Row;
use crate::sweep::Sweep;
use mps_examples::Failure;
use mps_io::CurvePlot;
use std::path::Path;

/// Writes `trade.png`; nothing if no run has come to its end yet.
pub(crate) fn write(sweep: &Sweep, dir: &Path, rows: &[Row]) -> Result<(), Failure> {
    let good: Vec<&Row> = rows.iter().filter(|row| row.error_over_tolerance.is_some()).collect();
    let (cost, error) = columns(&good);
    let ends = cost.iter().fold([f64::INFINITY, 0.0], |[low, high], c| [c.min(low), c.max(high)]);
    if good.is_empty() {
        return Ok(());
    }
    let mut plot = CurvePlot::new(&sweep.title, "processor time [s]", "largest error over its tolerance [–]")
        .log_x()
        .log_y();
    let best: Vec<&Row> = front(rows).into_iter().map(|k| &rows[k]).collect();
    let (front_cost, front_error) = columns(&best);
    plot =
        plot.line("Pareto set", &front_cost, &front_error).dashed("all within tolerance", &ends, &[1.0; 2]);
    let mut groups: Vec<&str> = Vec::new();
    for row in &good {
        if !groups.contains(&row.group.as_str()) {
            groups.push(&row.group);
        }
    }
    for group in groups {
        let inside = |k: &usize| good[*k].group == group;
        let pick = |values: &[f64]| (0..good.len()).filter(inside).map(|k| values[k]).collect::<Vec<_>>();
        let name = if group.is_empty() { "runs" } else { group };
        plot = plot.points(name, &pick(&cost), &pick(&error));
    }
    plot.write_png(dir.join("trade.png"))?;
    Ok(())
}

/// Cost \[s\] and error over tolerance. What took less than the clock can tell, or errs by nothing, is drawn at the edge.
fn columns(rows: &[&Row]) -> (Vec<f64>, Vec<f64>) {
    rows.iter()
        .map(|row| (row.cost_seconds.max(0.01), row.error_over_tolerance.unwrap_or(f64::NAN).max(1e-6)))
        .unzip()
}
