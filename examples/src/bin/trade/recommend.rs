//! The cheapest run that is good enough, for several meanings of good enough.

use crate::judge::Row;
use crate::sweep::Sweep;
use serde::Serialize;

/// How many times the tolerances.
const FACTORS: [f64; 4] = [4.0, 2.0, 1.0, 0.5];

/// An aim, and the cheapest run that meets it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Recommendation {
    /// What is asked for.
    pub(crate) aim: String,
    /// Number of the row; `None` if no run is as good.
    pub(crate) row: Option<usize>,
}

/// One for each result alone, then for all of them at several multiples of their tolerances.
pub(crate) fn recommend(sweep: &Sweep, rows: &[Row]) -> Vec<Recommendation> {
    let single = sweep.counts.iter().enumerate().map(|(k, count)| Recommendation {
        aim: format!("{} within {} %", count.metric, percent(count.tolerance)),
        row: cheapest(rows, |row| row.errors.get(k).is_some_and(|error| error.abs() <= count.tolerance)),
    });
    let all = FACTORS.iter().map(|factor| Recommendation {
        aim: format!("all within {factor} times their tolerances"),
        row: cheapest(rows, |row| row.error_over_tolerance.is_some_and(|error| error <= *factor)),
    });
    single.chain(all).collect()
}

/// In percent, without the digits that rounding adds.
fn percent(share: f64) -> f64 {
    (1e8 * share).round() / 1e6
}

fn cheapest(rows: &[Row], good: impl Fn(&Row) -> bool) -> Option<usize> {
    let candidates = rows.iter().enumerate().filter(|(_, row)| good(row));
    candidates.min_by(|a, b| a.1.cost_seconds.total_cmp(&b.1.cost_seconds)).map(|(k, _)| k)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::front::tests::row;
    use crate::sweep::Count;

    #[test]
    fn the_cheapest_that_is_good_enough() {
        let counts = vec![Count { metric: "period".into(), tolerance: 0.5, uncertainty: 0.0 }];
        let (title, program) = (String::new(), String::new());
        let (base, vary, also, group) = Default::default();
        let sweep = Sweep { title, program, base, vary, counts, also, group };
        let rows = [row(9.0, Some(0.4)), row(1.0, Some(3.0)), row(3.0, Some(0.9)), row(2.0, None)];
        let found: Vec<_> = recommend(&sweep, &rows).into_iter().map(|r| r.row).collect();
        // The error of these rows is their error over tolerance: 0.5 is asked for by the first and the last.
        assert_eq!(found, [Some(0), Some(1), Some(2), Some(2), Some(0)]);
        assert_eq!(recommend(&sweep, &rows[1..2])[0].row, None);
    }
}
