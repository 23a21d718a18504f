//! Binary tables: read back here, and by NumPy where there is one.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{directory, listing};
use mps_io::{CsvTable, OutputError, TableForm, TableWriter, find_table};
use mps_kernel::State;
use std::process::Command;

const COLUMNS: [&str; 3] = ["time [s]", "it's a \\ [–]", "a, b [Pa]"];

fn rows() -> [[f64; 3]; 4] {
    [
        [0.0, 1.0 / 3.0, -0.0],
        [0.1, f64::MIN_POSITIVE / 3.0, f64::INFINITY],
        [0.2, -1e300, 2.5],
        [0.3, 4.0, 5.0],
    ]
}

fn write(name: &str, form: TableForm) -> (std::path::PathBuf, TableWriter) {
    let dir = directory(name);
    let mut table = TableWriter::create(&dir, "probes", form, &COLUMNS).unwrap();
    rows().iter().for_each(|row| table.row(row).unwrap());
    (dir, table)
}

fn assert_rows(table: &CsvTable, count: usize) {
    assert_eq!(table.names, COLUMNS);
    for (k, column) in table.columns.iter().enumerate() {
        let expected: Vec<u64> = rows()[..count].iter().map(|row| row[k].to_bits()).collect();
        assert_eq!(column.iter().map(|x| x.to_bits()).collect::<Vec<_>>(), expected);
    }
}

#[test]
fn both_forms_keep_the_bits_and_replace_each_other() {
    for form in [TableForm::Csv, TableForm::Npy] {
        let (dir, mut table) = write("npy-bits", form);
        assert_rows(&table.read().unwrap(), 4);
        assert_rows(&find_table(&dir, "probes").unwrap().0, 4);
        assert_eq!(table.rows(), 4);
        let error = table.row(&[1.0]).unwrap_err();
        assert!(matches!(error, OutputError::RowLength { expected: 3, found: 1, row: 5, .. }), "{error}");
    }
    let dir = directory("npy-replaced");
    for (form, file) in
        [(TableForm::Npy, "probes.npy"), (TableForm::Csv, "probes.csv"), (TableForm::Npy, "probes.npy")]
    {
        TableWriter::create(&dir, "probes", form, &COLUMNS).unwrap();
        assert_eq!(listing(&dir), [file]);
    }
}

#[test]
fn a_table_goes_on_from_where_it_was_saved() {
    for form in [TableForm::Csv, TableForm::Npy] {
        let dir = directory("npy-resumed");
        let mut table = TableWriter::create(&dir, "probes", form, &COLUMNS).unwrap();
        rows()[..2].iter().for_each(|row| table.row(row).unwrap());
        let state = State::save(|transfer| table.transfer(transfer)).unwrap();
        table.row(&[9.0; 3]).unwrap();
        drop(table);

        let mut table = TableWriter::resume(&dir, "probes", form, &COLUMNS).unwrap();
        assert_eq!(table.rows(), 3);
        state.restore(|transfer| table.transfer(transfer)).unwrap();
        assert_rows(&table.read().unwrap(), 2);
        rows()[2..].iter().for_each(|row| table.row(row).unwrap());
        assert_rows(&table.read().unwrap(), 4);

        // A byte of the last row is missing.
        let (path, bytes) = (find_table(&dir, "probes").unwrap().1, |path| std::fs::read(path).unwrap());
        let full = bytes(&path);
        let fourth = State::save(|transfer| table.transfer(transfer)).unwrap();
        std::fs::write(&path, &full[..full.len() - 1]).unwrap();
        let mut cut = TableWriter::resume(&dir, "probes", form, &COLUMNS).unwrap();
        let error = fourth.restore(|transfer| cut.transfer(transfer)).unwrap_err();
        assert!(error.to_string().contains("the checkpoint is of a run with 4 rows"), "{error}");
        std::fs::write(&path, full).unwrap();

        let other = TableWriter::resume(&dir, "probes", form, &COLUMNS[..2]).err().unwrap();
        assert!(matches!(other, OutputError::Table { .. }), "{other}");
        drop(table);
        let mut short = TableWriter::create(&dir, "probes", form, &COLUMNS).unwrap();
        let error = state.restore(|transfer| short.transfer(transfer)).unwrap_err();
        assert!(error.to_string().contains("the checkpoint is of a run with 2 rows"), "{error}");
    }
}

#[test]
fn the_file_is_what_numpy_describes() {
    let (dir, _) = write("npy-bytes", TableForm::Npy);
    let bytes = std::fs::read(dir.join("probes.npy")).unwrap();
    assert_eq!(&bytes[..8], b"\x93NUMPY\x03\x00");
    let length = u32::from_le_bytes(bytes[8..12].try_into().unwrap()) as usize;
    assert_eq!(((12 + length) % 64, bytes.len()), (0, 12 + length + 4 * 3 * 8));
    let head = std::str::from_utf8(&bytes[12..12 + length]).unwrap();
    let columns = "[('time [s]', '<f8'), ('it\\'s a \\\\ [–]', '<f8'), ('a, b [Pa]', '<f8'), ]";
    let shape = "'fortran_order': False, 'shape': (                   4,), }";
    assert_eq!(head.trim_end(), format!("{{'descr': {columns}, {shape}"));
    assert!(head.ends_with('\n'));
}

#[test]
#[ignore = "needs a Python with numpy, named by MPS_PYTHON"]
fn numpy_opens_a_column_by_its_name() {
    let (dir, _) = write("npy-numpy", TableForm::Npy);
    let python = std::env::var("MPS_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let line = "import numpy, sys; print(numpy.load(sys.argv[1])[sys.argv[2]].tobytes().hex())";
    for (k, name) in COLUMNS.iter().enumerate() {
        let output =
            Command::new(&python).args(["-c", line]).arg(dir.join("probes.npy")).arg(name).output().unwrap();
        let expected: String =
            rows().iter().flat_map(|row| row[k].to_le_bytes()).map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(
            String::from_utf8_lossy(&output.stdout).trim(),
            expected,
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
    }
}
