//! The presets keep the errors that `docs/trade.md` promises of them. Those that take seconds run on request:
//! `cargo test -p mps-examples --test presets -- --ignored`.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{completed, words};
use std::process::Command;

const PLATE: &str = env!("CARGO_BIN_EXE_cantilever");
const GATE: &str = env!("CARGO_BIN_EXE_elastic-gate");
const CHANNEL: &str = env!("CARGO_BIN_EXE_turek-hron");
const DAM: &str = env!("CARGO_BIN_EXE_dam-break");

/// Runs a preset and holds the errors of its results against what is promised.
fn keeps(program: &str, name: &str, arguments: &[&str], preset: &str, promised: &[(&str, f64)]) {
    let arguments = [arguments, &["--preset", preset]].concat();
    let summary = completed(program, &format!("preset-{name}-{preset}"), &arguments);
    for (metric, most) in promised {
        let error = summary.metrics[*metric].error.unwrap();
        assert!(error.abs() <= *most, "{name} {preset}: {metric} errs by {error:+.4}, promised is {most}");
    }
}

#[test]
fn the_cheap_presets_of_the_plate_keep_their_promises() {
    keeps(PLATE, "cantilever", &[], "fast", &[("period", 0.01), ("amplitude", 0.01)]);
    keeps(PLATE, "cantilever", &[], "balanced", &[("period", 0.005), ("amplitude", 0.005)]);
}

#[test]
#[ignore = "takes some seconds"]
fn the_accurate_plate_keeps_its_promises() {
    keeps(PLATE, "cantilever", &[], "accurate", &[("period", 0.001), ("amplitude", 0.001)]);
}

#[test]
#[ignore = "takes some seconds"]
fn the_fast_gate_keeps_its_promises() {
    // The rubber of the sweep: what is promised is the error against the published run with the same one.
    let rubber = ["--material", "e7.8-nu40"];
    keeps(GATE, "elastic-gate", &rubber, "fast", &[("gate_x_max", 0.05), ("gate_y_max", 0.15)]);
}

#[test]
#[ignore = "takes some seconds"]
fn the_cheap_presets_of_the_dam_break_keep_their_promises() {
    let both = [("arrival_sensor1", 0.02), ("large_sensor", 0.1)];
    let fast = [("front_rms", 0.06), ("pressure_noise", 0.12)];
    keeps(DAM, "dam-break", &[], "fast", &[&both[..], &fast].concat());
    let balanced = [("front_rms", 0.05), ("pressure_noise", 0.1), ("band_fraction_sensor1", 0.4)];
    keeps(DAM, "dam-break", &[], "balanced", &[&both[..], &balanced].concat());
}

/// In slow flow, for as long as drag and lift take to be steady; FSI3 takes too long.
#[test]
#[ignore = "takes a minute"]
fn the_fast_channel_keeps_its_promises() {
    let slow = ["--test", "fsi1", "--end-time", "6"];
    keeps(CHANNEL, "turek-hron", &slow, "fast", &[("drag_mean", 0.02), ("lift_mean", 0.1)]);
}

/// A preset is the settings it stands for, and what is given beside it counts.
#[test]
fn a_preset_is_its_settings() {
    let printed = |arguments: &[&str]| {
        let output = Command::new(GATE).args(arguments).arg("--print-scene").output().unwrap();
        assert!(output.status.success(), "{}", words(&output.stderr));
        words(&output.stdout)
    };
    let spelled_out = "--spacing 2.5e-3 --across 4 --weight rational --radius 2.5 --cfl 0.8 --sound-ratio 7 --precision f32";
    let spelled_out: Vec<&str> = spelled_out.split(' ').collect();
    assert_eq!(printed(&["--preset", "fast", "--sound-ratio", "7"]), printed(&spelled_out));
    assert_ne!(printed(&["--preset", "fast"]), printed(&["--preset", "accurate"]));
}

/// The settings that `docs/trade.md` tells of every preset.
#[test]
fn every_preset_has_the_settings_of_its_table() {
    let gate = "--spacing 2.5e-3 --across 4 --weight rational --radius 2.5 --cfl 0.8 --sound-ratio 5 --precision f32";
    let dam = "--spacing 0.02 --radius 3 --cfl 0.8 --sound-ratio 5 --precision f32";
    for (program, preset, settings) in [
        (PLATE, "fast", "--across 3"),
        (PLATE, "balanced", "--across 6"),
        (PLATE, "accurate", "--across 16"),
        (GATE, "fast", gate),
        (GATE, "balanced", "--spacing 2.5e-3 --across 5"),
        (GATE, "accurate", "--spacing 1.25e-3 --across 8"),
        (DAM, "fast", "--spacing 0.03 --sound-ratio 5"),
        (DAM, "balanced", dam),
        (DAM, "accurate", "--spacing 0.01 --sound-ratio 5"),
        (CHANNEL, "fast", "--spacing 5e-3 --length 1.5 --sound-ratio 5 --precision f32"),
        (CHANNEL, "balanced", "--spacing 5e-3 --length 1.5"),
        (CHANNEL, "accurate", "--spacing 2.5e-3 --length 1.5"),
    ] {
        let printed = |arguments: &[&str]| {
            let output = common::print(program, arguments);
            assert!(output.status.success(), "{}", words(&output.stderr));
            words(&output.stdout)
        };
        let told: Vec<&str> = settings.split(' ').collect();
        assert_eq!(printed(&["--preset", preset]), printed(&told), "{program} {preset}");
    }
}
