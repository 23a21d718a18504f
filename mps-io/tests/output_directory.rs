//! Directories that can be used, and the sentences for those that cannot.
//!
//! Permission bits are no test: whoever runs as root may write anywhere.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on should fail")]

mod common;

use common::{directory, listing};
use mps_io::{CsvWriter, FieldOptions, FieldWriter, Image, OutputError, Summary, prepare_output};

#[test]
fn a_missing_directory_is_created_with_its_parents_and_left_empty() {
    let dir = directory("create").join("a").join("b");
    prepare_output(&dir).unwrap();
    prepare_output(&dir).unwrap();
    assert_eq!(listing(&dir), Vec::<String>::new());
}

#[test]
fn a_file_is_no_directory() {
    let file = directory("file").join("results");
    std::fs::write(&file, "precious").unwrap();
    let error = prepare_output(&file).unwrap_err();
    assert!(matches!(error, OutputError::NotADirectory { .. }));
    let text = error.to_string();
    assert!(text.contains("results is a file. Choose another output directory"), "{text}");
    assert!(matches!(
        FieldWriter::new(&file, "x", FieldOptions::default()),
        Err(OutputError::NotADirectory { .. })
    ));
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "precious");
}

#[test]
fn a_file_among_the_parents_is_named() {
    let file = directory("parent").join("results");
    std::fs::write(&file, "").unwrap();
    let error = prepare_output(file.join("run 1")).unwrap_err().to_string();
    assert!(error.contains("run 1") && error.contains("A file is where a directory should be"), "{error}");
}

#[test]
fn files_into_a_missing_directory_say_which_and_what_to_do() {
    let dir = directory("missing").join("nowhere");
    let errors = [
        CsvWriter::create(dir.join("probe.csv"), &["t"]).err().unwrap(),
        Image::new(2, 2).write_png(dir.join("picture.png")).unwrap_err(),
        Summary::new("x", "1").write(&dir).unwrap_err(),
    ];
    for error in errors {
        let text = error.to_string();
        assert!(text.contains("nowhere") && text.contains("create the directory before the run"), "{text}");
    }
}

/// A directory that disappears during the run: the writer reports it and the old frames are listed.
#[test]
fn a_name_taken_by_a_directory_is_reported() {
    let dir = directory("taken");
    std::fs::create_dir_all(dir.join("fluid_00000.vtu").join("occupied")).unwrap();
    let mut writer = FieldWriter::new(&dir, "fluid", FieldOptions::default()).unwrap();
    let positions = [mps_kernel::Vector::<f64, 2>::new(0.0, 0.0)];
    let error = writer.write(0.0, &mps_io::PointCloud::new(&positions)).unwrap_err();
    assert!(error.to_string().contains("fluid_00000.vtu"), "{error}");
    assert_eq!(writer.frames(), 0);
    // Nothing half-written stays behind.
    assert_eq!(listing(&dir), ["fluid_00000.vtu"]);
}
