//! A body and a time loop of another simulator: the raft of `embed` floats as it has to.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{completed, execute, fresh, words};
use mps_io::CsvTable;

const EMBED: &str = env!("CARGO_BIN_EXE_embed");

/// The draught lacks a fifth of a spacing, at any spacing (`docs/coupling.md`).
#[test]
fn the_raft_of_another_simulator_rests_where_it_displaces_its_own_mass() {
    for (name, density) in [("embed-light", "300"), ("embed-heavy", "600")] {
        let arguments = ["--spacing", "0.02", "--end-time", "5", "--density", density];
        let summary = completed(EMBED, name, &arguments);
        let value = |name: &str| summary.metrics[name].value;
        let exact = summary.metrics["draught"].reference.unwrap();
        let off = (value("draught") - exact) / 0.02;
        assert!(off.abs() < 0.25, "{density} kg/m3: {off} spacings from {exact} m");
        assert!(value("roll").abs() < 1e-6, "it leans by {} rad", value("roll"));
        assert!(value("interface_momentum_residual") < 1e-12);
        assert!(value("clocks_apart").abs() < 1e-10);
    }
}

/// A symmetric raft does not turn whatever the torque is: this one is let go inclined, to either side.
#[test]
fn an_inclined_raft_rights_itself() {
    for (name, lean) in [("embed-left", 0.1_f64), ("embed-right", -0.1)] {
        let out = fresh("embed-lean", name);
        let angle = lean.to_string();
        let arguments =
            ["--spacing", "0.02", "--end-time", "4", "--lean", angle.as_str(), "--quiet", "--no-fields"];
        let output = execute(EMBED, &out, &arguments);
        assert!(output.status.success(), "{}", words(&output.stderr));
        let table = CsvTable::read(out.join("probes.csv")).unwrap();
        let [time, roll] =
            ["time of the host [s]", "roll [rad]"].map(|name| table.column(name).unwrap().to_vec());
        let share: Vec<_> = roll.iter().map(|roll| roll / lean).collect();
        assert!((share[0] - 1.0).abs() < 1e-6, "it begins at {} rad", roll[0]);
        let largest = share.iter().fold(0.0_f64, |most, share| most.max(share.abs()));
        assert!(largest < 1.05, "{name}: it turns over, by {largest} times what it leaned");
        // A quarter of its period of about a second: 0.24 s.
        let upright = time.iter().zip(&share).find(|(_, share)| **share < 0.1).map(|(time, _)| *time);
        assert!(upright.is_some_and(|time| time < 0.6), "{name}: upright after {upright:?} s");
        let late: Vec<_> = share[share.len() * 4 / 5..].to_vec();
        let rest = late.iter().sum::<f64>() / late.len() as f64;
        assert!(rest.abs() < 0.2, "{name}: it rests at {rest} of what it leaned");
    }
}

/// Frames much shorter and much longer than a step of the water, none of which is a multiple of the other.
#[test]
fn the_water_keeps_the_time_of_its_host_whatever_the_frames() {
    for (name, frame) in [("short", "1.3e-4"), ("long", "0.04")] {
        let out = fresh("embed-frames", name);
        let arguments =
            ["--spacing", "0.02", "--end-time", "0.1", "--frame", frame, "--quiet", "--no-fields"];
        let output = execute(EMBED, &out, &arguments);
        assert!(output.status.success(), "{}", words(&output.stderr));
        let table = CsvTable::read(out.join("probes.csv")).unwrap();
        let [host, water] = ["time of the host [s]", "time of the water [s]"]
            .map(|name| table.column(name).unwrap().to_vec());
        assert!(host.len() > 2 && host.iter().zip(&water).all(|(a, b)| (a - b).abs() < 1e-9));
    }
}

#[test]
fn what_cannot_be_run_is_refused_with_the_flag_and_a_remedy() {
    for (flag, value) in [
        ("--spacing", "0.015"),
        ("--density", "1200"),
        ("--lean", "1"),
        ("--frame", "nan"),
        ("--end-time", "0"),
    ] {
        let out = fresh("embed", "refused");
        let output = execute(EMBED, &out, &[flag, value]);
        let message = words(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{flag} {value}: {message}");
        assert!(message.starts_with(&format!("error: {flag} is ")), "{flag} {value}: {message}");
        assert!(!out.exists(), "{flag} {value} has left something");
    }
}
