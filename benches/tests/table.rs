//! The table of counts comes back as it was written, and what has changed since is told.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use mps_benches::counting::{Row, Table, differences};

#[test]
fn a_table_comes_back_as_it_was_written() {
    let mut table = Table::default();
    table.builds.insert("debug".to_owned(), "rustc 1.95.0 (x), AVX2".to_owned());
    let row = Row { instructions: [("debug".to_owned(), 812.25)].into(), bytes: 345.5 };
    table.rows.push(("2d/f64/bare".to_owned(), row));
    let text = table.text();
    assert!(text.ends_with("2d/f64/bare,812.25,,345.5\n"), "{text}");
    assert!(Table::parse(&text).is_ok_and(|read| read == table));
    assert!(Table::parse("2d/f64/bare,many,,1\n").is_err_and(|error| error.to_string().contains("line 1")));
}

fn table(counts: &[(&str, f64, f64)]) -> Table {
    let line = |(name, count, bytes): &(&str, f64, f64)| format!("{name},{count},,{bytes}\n");
    Table::parse(&counts.iter().map(line).collect::<String>()).unwrap_or_default()
}

#[test]
fn what_rises_falls_comes_or_goes_is_told() {
    let kept = table(&[("a", 100.0, 8.0), ("b", 100.0, 8.0), ("c", 100.0, 8.0), ("gone", 1.0, 1.0)]);
    let now = table(&[("a", 102.1, 8.0), ("b", 97.9, 9.0), ("c", 101.9, 8.1), ("new", 5.0, 1.0)]);
    let told: Vec<String> = differences(&kept, &now, "debug").iter().map(ToString::to_string).collect();
    assert_eq!(
        told,
        [
            "a: instructions rose from 100.00 to 102.10 a particle (+2.1 %)",
            "b: instructions fell from 100.00 to 97.90 a particle (-2.1 %)",
            "b: bytes rose from 8.00 to 9.00 a particle (+12.5 %)",
            "new: instructions 5.00 a particle, never counted before",
            "new: bytes 1.00 a particle, never counted before",
            "gone: instructions kept, but nothing of this name is counted",
        ]
    );
    assert!(differences(&now, &now, "debug").is_empty());
}

/// The table that is kept can be read, and is the one of what is counted.
#[test]
fn the_table_of_the_repository_has_every_subject() {
    let kept = Table::parse(include_str!("../counts.csv")).unwrap();
    let names: Vec<_> = mps_benches::counting::entries().into_iter().map(|entry| entry.name).collect();
    assert_eq!(kept.rows.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>(), names);
    assert!(kept.rows.iter().all(|(_, row)| row.instructions.len() == 2 && row.bytes > 0.0));
    assert_eq!(kept.builds.len(), 2);
}
