//! The runs as a table for people (Markdown), for spreadsheets (CSV) and for programs (JSON).

use crate::front::front;
use crate::judge::Row;
use crate::origin::Origin;
use crate::recommend::recommend;
use crate::sweep::Sweep;
use mps_examples::Failure;
use std::fmt::Write;
use std::path::Path;

/// Writes `trade.md`, `trade.csv` and `trade.json`.
pub(crate) fn write(sweep: &Sweep, dir: &Path, rows: &[Row], command: &str) -> Result<(), Failure> {
    let origin = Origin::of(rows);
    std::fs::write(dir.join("trade.csv"), csv(sweep, rows))?;
    let json = serde_json::json!({
        "title": sweep.title,
        "program": sweep.program,
        "dates": origin.dates,
        "machines": origin.machines,
        "command": command,
        "counts": sweep.counts.iter().map(|count| &count.metric).collect::<Vec<_>>(),
        "also": sweep.also,
        "rows": rows,
        "front": front(rows),
        "recommendations": recommend(sweep, rows),
    });
    std::fs::write(dir.join("trade.json"), format!("{json:#}\n"))?;
    let text = format!(
        "# {}\n\n{origin}, `{command}`\n\n{}\n{}",
        sweep.title,
        markdown(sweep, rows),
        recommendations(sweep, rows)
    );
    std::fs::write(dir.join("trade.md"), text)?;
    Ok(())
}

/// The table, in the order of the costs; runs of the Pareto set are marked, failed ones last.
fn markdown(sweep: &Sweep, rows: &[Row]) -> String {
    let counted = sweep.counts.iter().map(|count| format!("{} | ", count.metric)).collect::<String>();
    let also = sweep.also.iter().map(|name| format!("{name} | ")).collect::<String>();
    let mut text =
        format!("| settings | processor (s) | memory (MB) | {counted}{also}error/tolerance | best |\n");
    // Writing into a String cannot fail.
    let _ = writeln!(text, "|---|---|---|{}---|---|", "---|".repeat(sweep.counts.len() + sweep.also.len()));
    let best = front(rows);
    let mut order: Vec<usize> = (0..rows.len()).collect();
    order.sort_by(|a, b| {
        let failed = |k: &usize| rows[*k].failure.is_some();
        failed(a).cmp(&failed(b)).then(rows[*a].cost_seconds.total_cmp(&rows[*b].cost_seconds))
    });
    for k in order {
        let row = &rows[k];
        let memory =
            row.peak_memory_bytes.map_or("-".to_owned(), |bytes| format!("{:.1}", bytes as f64 / 1e6));
        let _ = write!(text, "| {} | {:.2} | {memory} | ", row.label, row.cost_seconds);
        if let Some(failure) = &row.failure {
            let empty = "- | ".repeat(sweep.counts.len() + sweep.also.len());
            let _ = writeln!(text, "{empty}failed: {} | |", failure.replace('|', "/"));
            continue;
        }
        for error in &row.errors {
            let _ = write!(text, "{} | ", percent(*error));
        }
        for value in &row.also {
            let _ = write!(text, "{} | ", value.map_or("-".to_owned(), |value| format!("{value:.3e}")));
        }
        let error = row.error_over_tolerance.map_or("-".to_owned(), |error| format!("{error:.2}"));
        let _ = writeln!(text, "{error} | {} |", if best.contains(&k) { "yes" } else { "" });
    }
    text
}

/// A sentence for each aim.
pub(crate) fn recommendations(sweep: &Sweep, rows: &[Row]) -> String {
    let sentence =
        |recommendation: &crate::recommend::Recommendation| match recommendation.row.map(|k| &rows[k]) {
            Some(row) => format!("- {}: {}, {:.2} s\n", recommendation.aim, row.label, row.cost_seconds),
            None => format!("- {}: none of these runs\n", recommendation.aim),
        };
    recommend(sweep, rows).iter().map(sentence).collect()
}

fn csv(sweep: &Sweep, rows: &[Row]) -> String {
    let mut text = "settings,processor [s],wall [s],memory [B],steps [-]".to_owned();
    let names = sweep.counts.iter().map(|count| format!("error of {} [-]", count.metric));
    for name in names.chain(sweep.also.iter().cloned()).chain(["error over tolerance [-]".to_owned()]) {
        let _ = write!(text, ",{}", if name.contains(',') { quoted(&name) } else { name });
    }
    text.push_str(",best,failure,date,machine\n");
    let best = front(rows);
    for (k, row) in rows.iter().enumerate() {
        let memory = row.peak_memory_bytes.map_or(String::new(), |bytes| bytes.to_string());
        let (cost, wall) = (row.cost_seconds, row.wall_seconds);
        let _ = write!(text, "{},{cost},{wall},{memory},{}", quoted(&row.label), row.steps);
        for k in 0..sweep.counts.len() {
            let _ = write!(text, ",{}", number(row.errors.get(k).copied()));
        }
        for value in row.also.iter().copied().chain([row.error_over_tolerance]) {
            let _ = write!(text, ",{}", number(value));
        }
        let failure = row.failure.as_deref().unwrap_or_default();
        let [date, machine] =
            [&row.date, &row.machine].map(|word| quoted(word.as_deref().unwrap_or_default()));
        let _ = writeln!(text, ",{},{},{date},{machine}", u8::from(best.contains(&k)), quoted(failure));
    }
    text
}

/// In percent, as a power of ten where that would have no digit left.
fn percent(error: f64) -> String {
    let is_small = error != 0.0 && error.abs() < 5e-5;
    if is_small { format!("{error:+.1e}") } else { format!("{:+.2} %", 100.0 * error) }
}

/// An empty field for what is not there.
fn number(value: Option<f64>) -> String {
    value.map_or(String::new(), |value| value.to_string())
}

/// A field of text as RFC 4180 has it.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\"").replace('\n', " "))
}

#[cfg(test)]
mod tests {
    use super::percent;

    #[test]
    fn small_errors_keep_their_digits() {
        assert_eq!([0.0, 0.0123, -6e-5, -3.2e-7].map(percent), ["+0.00 %", "+1.23 %", "-0.01 %", "-3.2e-7"]);
    }
}
