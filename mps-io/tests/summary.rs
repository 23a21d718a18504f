//! summary.json: exact, and valid JSON whatever the numbers are.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on should fail")]

mod common;

use common::{directory, listing};
use mps_io::{Metric, Summary, Value, peak_memory_bytes};

fn example() -> Summary {
    let mut summary = Summary::new("dam_break", "0.1.0");
    summary.set("particle_distance_m", 0.1 + 0.2);
    summary.set("kernel", "rational");
    summary.set("levels", [1, 2, 3]);
    summary.particles.insert("fluid".to_owned(), 20_000);
    summary.particles.insert("wall".to_owned(), 1_500);
    summary.measure(1200, 34.5, 0.6);
    summary.threads = 8;
    summary.metrics.insert("front".to_owned(), Metric::new(0.52, "m").compared_with(0.5, "Martin 1952"));
    summary.metrics.insert("energy".to_owned(), Metric::new(1.0 / 3.0, "J/m"));
    summary
}

#[test]
fn round_trip() {
    let dir = directory("summary");
    let summary = example();
    let path = summary.write(&dir).unwrap();
    assert_eq!(path, dir.join("summary.json"));
    assert_eq!(Summary::read(&path).unwrap(), summary);
    assert_eq!(listing(&dir), ["summary.json"]);
}

#[test]
fn the_names_in_the_file_are_fixed() {
    let path = example().write(directory("names-in-file")).unwrap();
    let json: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    assert_eq!(json["program"], "dam_break");
    assert_eq!(json["settings"]["kernel"], "rational");
    assert_eq!(json["particles"]["fluid"], 20_000);
    assert_eq!(json["particle_steps_per_second"], 21_500.0 * 1200.0 / 34.5);
    assert_eq!(json["wall_seconds_per_simulated_second"], 34.5 / 0.6);
    assert_eq!(json["metrics"]["front"]["reference_source"], "Martin 1952");
    assert_eq!(json["metrics"]["front"]["error"], (0.52 - 0.5) / 0.5);
    // What is not known is not there.
    assert!(json["metrics"]["energy"].get("reference").is_none());
    assert!(json.get("notes").is_none());
}

#[test]
fn numbers_json_cannot_hold_become_null_with_a_note() {
    let mut summary = example();
    summary.measure(0, 0.0, 0.0);
    summary.set("viscosity", f64::NAN);
    summary.metrics.insert("force".to_owned(), Metric::new(f64::INFINITY, "N").compared_with(2.0, "theory"));
    summary.metrics.insert("drift".to_owned(), Metric::new(f64::NAN, "-"));
    let path = summary.write(directory("nan")).unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    let json: Value = serde_json::from_str(&text).expect("valid JSON");
    assert!(json["metrics"]["force"]["value"].is_null());
    assert!(json["metrics"]["force"]["error"].is_null());
    assert_eq!(json["metrics"]["force"]["reference"], 2.0);
    assert!(json["wall_seconds_per_simulated_second"].is_null());
    let notes: Vec<&str> = json["notes"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
    for part in ["metrics.force.value is inf", "metrics.drift.value is NaN", "settings.viscosity"] {
        assert!(notes.iter().any(|note| note.contains(part)), "{part}: {notes:?}");
    }
    let read = Summary::read(&path).unwrap();
    assert!(read.metrics["force"].value.is_nan() && read.metrics["force"].error.is_some_and(f64::is_nan));
    assert_eq!(read.metrics["front"], summary.metrics["front"]);
}

#[test]
fn a_reference_of_zero_gives_the_absolute_deviation() {
    assert_eq!(Metric::new(-0.25, "m").compared_with(0.0, "rest").error, Some(-0.25));
    assert_eq!(Metric::new(-3.0, "m").compared_with(-2.0, "theory").error, Some(-0.5));
}

#[test]
fn what_cannot_be_serialised_is_left_out_with_a_note() {
    let mut summary = example();
    summary.set("table", std::collections::BTreeMap::from([((1, 2), 3)]));
    assert!(!summary.settings.contains_key("table"));
    assert!(summary.notes[0].contains("settings.table is left out"), "{:?}", summary.notes);
}

#[test]
fn other_files_are_refused_by_name() {
    let path = directory("other").join("summary.json");
    std::fs::write(&path, "{ \"program\": 3 }").unwrap();
    let error = Summary::read(&path).unwrap_err().to_string();
    assert!(error.contains("summary.json is not a summary"), "{error}");
}

#[test]
#[cfg(target_os = "linux")]
fn peak_memory_grows_with_use() {
    let before = peak_memory_bytes().unwrap();
    let block = vec![1u8; 64 << 20];
    assert_eq!(block.iter().map(|b| u64::from(*b)).sum::<u64>(), 64 << 20);
    assert!(peak_memory_bytes().unwrap() >= before.max(64 << 20));
}
