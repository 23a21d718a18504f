//! Tables that grow row by row.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on should fail")]

mod common;

use common::directory;
use mps_io::{CsvTable, CsvWriter, OutputError};
use mps_kernel::State;
use proptest::prelude::*;

/// A killed run drops nothing: not even the destructor runs.
#[test]
fn a_killed_run_keeps_its_rows() {
    let path = directory("killed").join("probe.csv");
    let mut writer = CsvWriter::create(&path, &["time [s]", "pressure [Pa]"]).unwrap();
    for k in 0..10 {
        writer.row(&[0.1 * f64::from(k), 1000.0]).unwrap();
        let table = CsvTable::read(&path).unwrap();
        assert_eq!(table.columns[0].len(), k as usize + 1);
    }
    std::mem::forget(writer);
    let table = CsvTable::read(&path).unwrap();
    assert_eq!(table.column("time [s]").unwrap().last(), Some(&(0.1 * 9.0)));
}

/// A run that goes on has neither a gap nor a row twice, also when the last line was cut by a kill.
#[test]
fn a_table_goes_on_where_it_was() {
    let path = directory("resumed").join("probe.csv");
    let names = ["time [s]", "x, left [m]"];
    let mut writer = CsvWriter::create(&path, &names).unwrap();
    writer.row(&[0.0, 1.0]).unwrap();
    writer.row(&[0.1, 2.0]).unwrap();
    let state = State::save(|transfer| writer.transfer(transfer)).unwrap();
    writer.row(&[0.2, 3.0]).unwrap();
    drop(writer);
    let mut text = std::fs::read_to_string(&path).unwrap();
    text += "0.3,";
    std::fs::write(&path, text).unwrap();
    let mut writer = CsvWriter::resume(&path, &names).unwrap();
    state.restore(|transfer| writer.transfer(transfer)).unwrap();
    assert_eq!(writer.rows(), 2);
    writer.row(&[0.25, 4.0]).unwrap();
    assert_eq!(CsvTable::read(&path).unwrap().columns, [[0.0, 0.1, 0.25], [1.0, 2.0, 4.0]]);
    let other = CsvWriter::resume(&path, &names[..1]).err().unwrap();
    assert!(other.to_string().contains("does not have the columns of this run"), "{other}");
    CsvWriter::create(&path, &names).unwrap();
    let mut writer = CsvWriter::resume(&path, &names).unwrap();
    let shorter = state.restore(|transfer| writer.transfer(transfer)).unwrap_err();
    assert!(shorter.to_string().contains("the checkpoint is of a run with 2 rows"), "{shorter}");
}

#[test]
fn names_with_commas_and_quotes() {
    let path = directory("quoted").join("probe.csv");
    let names = ["x, left [m]", "the \"front\"", "# 3", "plain"];
    let mut writer = CsvWriter::create(&path, &names).unwrap();
    writer.row(&[1.0, 2.0, 3.0, 4.0]).unwrap();
    let table = CsvTable::read(&path).unwrap();
    assert_eq!(table.names, names);
    assert_eq!(table.column("the \"front\""), Some(&[2.0][..]));
}

#[test]
fn a_row_of_the_wrong_length_is_refused_with_its_number() {
    let path = directory("length").join("probe.csv");
    let mut writer = CsvWriter::create(&path, &["a", "b"]).unwrap();
    writer.row(&[1.0, 2.0]).unwrap();
    let error = writer.row(&[1.0]).unwrap_err();
    assert!(matches!(error, OutputError::RowLength { expected: 2, found: 1, row: 2, .. }), "{error}");
    assert!(error.to_string().contains("probe.csv has 2 columns, and row 2 has 1 values"), "{error}");
    // The table stays usable and the next row has the number of the refused one.
    writer.row(&[3.0, 4.0]).unwrap();
    assert_eq!((writer.rows(), CsvTable::read(&path).unwrap().columns[1].clone()), (2, vec![2.0, 4.0]));
}

#[test]
fn references_may_have_comments_and_gaps() {
    let path = directory("reference").join("martin.csv");
    std::fs::write(&path, "# Martin and Moyce (1952), figure 3\ntime, front\n\n0, 1\n 0.5 ,\n1e0,-2.5e-3\n")
        .unwrap();
    let table = CsvTable::read(&path).unwrap();
    assert_eq!(table.column("time"), Some(&[0.0, 0.5, 1.0][..]));
    let front = table.column("front").unwrap();
    assert!(front[0] == 1.0 && front[1].is_nan() && front[2] == -0.0025);
    assert_eq!(table.column("pressure"), None);
}

#[test]
fn broken_tables_are_refused_with_the_line() {
    let path = directory("broken").join("table.csv");
    for (text, line, part) in [
        ("", 1, "no line with the names"),
        ("# only a comment\n", 1, "no line with the names"),
        ("a,b\n1,2\n3\n", 3, "1 values, but the header has 2"),
        ("a\n1\nx1\n", 3, "'x1' is not a number"),
    ] {
        std::fs::write(&path, text).unwrap();
        let error = CsvTable::read(&path).unwrap_err();
        assert!(error.to_string().contains(part), "{error}");
        assert!(matches!(error, OutputError::Table { line: found, .. } if found == line), "{error}");
    }
}

proptest! {
    /// Every number comes back with the same bits.
    #[test]
    fn numbers_come_back_exactly(bits in prop::collection::vec(any::<u64>(), 1..50)) {
        let path = directory("exact").join("bits.csv");
        let mut writer = CsvWriter::create(&path, &["x"]).unwrap();
        let values: Vec<f64> = bits.into_iter().map(f64::from_bits).collect();
        for value in &values {
            writer.row(&[*value]).unwrap();
        }
        let table = CsvTable::read(&path).unwrap();
        for (written, read) in values.iter().zip(&table.columns[0]) {
            prop_assert!(written.to_bits() == read.to_bits() || (written.is_nan() && read.is_nan()));
        }
    }
}
