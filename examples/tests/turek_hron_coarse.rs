//! The channel of Turek and Hron, coarse: steady drag of cylinder and rigid flag.
//! Long, hence only on request: `cargo test -p mps-examples --test turek_hron_coarse -- --ignored`.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::completed;
use mps_io::CsvTable;
use std::path::Path;

/// Finite elements (Turek and Hron 2006) say 14.29 N/m and, of the lift, 1.119 N/m.
#[test]
#[ignore = "takes half a minute"]
fn a_coarse_channel_has_the_drag_of_finite_elements() {
    let coarse = ["--test", "cfd1", "--spacing", "0.01", "--length", "1.5", "--end-time", "6"];
    let summary = completed(env!("CARGO_BIN_EXE_turek-hron"), "turek-hron-coarse", &coarse);
    let drag = summary.metrics["drag_mean"].value;
    assert!((drag / 14.29 - 1.0).abs() < 0.05, "{drag} N/m");
    let lift = summary.metrics["lift_mean"].value;
    assert!((lift - 1.119).abs() < 0.7, "{lift} N/m");
    assert!(summary.metrics["interface_momentum_residual"].value < 1e-12);
    // Shifting moves particles without the density knowing; it has to learn of it, or they gather.
    let probes = Path::new(env!("CARGO_TARGET_TMPDIR")).join("whole-cases/turek-hron-coarse/probes.csv");
    let table = CsvTable::read(probes).unwrap();
    let count = table.column("fluid particles [-]").unwrap();
    let gathered = count.iter().map(|n| (n / count[0] - 1.0).abs()).fold(0.0, f64::max);
    assert!(gathered < 0.03, "{gathered} more particles than at the start");
}
