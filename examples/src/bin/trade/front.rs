//! The Pareto set: the runs than which no other is both cheaper and better.

use crate::judge::Row;

/// Numbers of the rows in the Pareto set, the cheapest first. Of several as good and as cheap the first counts.
pub(crate) fn front(rows: &[Row]) -> Vec<usize> {
    let mut order: Vec<(usize, f64, f64)> = rows
        .iter()
        .enumerate()
        .filter_map(|(k, row)| Some((k, row.cost_seconds, row.error_over_tolerance?)))
        .collect();
    order.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.2.total_cmp(&b.2)));
    let mut best = f64::INFINITY;
    let mut front = Vec::new();
    for (k, _, error) in order {
        if error < best {
            best = error;
            front.push(k);
        }
    }
    front
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A run of this cost and error.
    pub(crate) fn row(cost_seconds: f64, error_over_tolerance: Option<f64>) -> Row {
        Row {
            label: format!("{cost_seconds} s"),
            group: String::new(),
            arguments: Vec::new(),
            cost_seconds,
            wall_seconds: cost_seconds,
            peak_memory_bytes: None,
            steps: 1,
            errors: error_over_tolerance.into_iter().collect(),
            also: Vec::new(),
            error_over_tolerance,
            failure: error_over_tolerance.is_none().then(|| "it broke".to_owned()),
            date: None,
            machine: None,
        }
    }

    #[test]
    fn only_what_nothing_beats_is_left() {
        let rows = [
            row(8.0, Some(0.5)),
            row(1.0, Some(4.0)),
            row(2.0, Some(4.0)), // as good as a cheaper one
            row(0.1, None),      // cheap, and failed
            row(4.0, Some(5.0)), // dearer and worse
            row(4.0, Some(1.0)),
            row(4.0, Some(1.0)), // the same again
            row(1.0, Some(6.0)), // as cheap, and worse
        ];
        assert_eq!(front(&rows), [1, 5, 0]);
        assert!(front(&rows[3..4]).is_empty());
    }

    /// Against the definition: a row is in the set if no other beats it.
    #[test]
    fn the_set_is_that_of_the_definition() {
        // Bits of a multiplicative hash: no order, no equal costs.
        let number = |k: u64| (k * 2_654_435_761 % 4_294_967_296) as f64;
        let rows: Vec<Row> = (1..60).map(|k| row(number(k), Some(number(k * k + 7)))).collect();
        let beaten = |a: &Row| {
            rows.iter()
                .any(|b| b.cost_seconds < a.cost_seconds && b.error_over_tolerance <= a.error_over_tolerance)
        };
        let mut expected: Vec<usize> = (0..rows.len()).filter(|k| !beaten(&rows[*k])).collect();
        expected.sort_by(|a, b| rows[*a].cost_seconds.total_cmp(&rows[*b].cost_seconds));
        assert!(expected.len() > 2 && expected.len() < rows.len());
        assert_eq!(front(&rows), expected);
    }
}
