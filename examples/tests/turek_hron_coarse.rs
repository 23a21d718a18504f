//! The channel of Turek and Hron, coarse: steady drag of cylinder and rigid flag.
//! Long, hence only on request: `cargo test -p mps-examples --test turek_hron_coarse -- --ignored`.

mod common;

use common::completed;

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
}
