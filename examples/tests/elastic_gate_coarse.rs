//! The whole elastic gate, coarse: against a published run with the same rubber, and with few sub-steps.
//! Long, hence only on request: `cargo test -p mps-examples --test elastic_gate_coarse -- --ignored`.

mod common;

use common::completed;
use mps_io::Summary;

const GATE: &str = env!("CARGO_BIN_EXE_elastic-gate");

/// Largest displacements of the free end \[m\]: Ng et al. 2020 (SPH-VCPM) with 12 MPa and 0.4, as in
/// the example's `reference.rs`.
const PUBLISHED: [(&str, f64, f64); 2] = [("gate_x_max", 0.03895, 0.05), ("gate_y_max", 0.01371, 0.15)];

/// What holds for every gate; the energy may rise by `most` of what the water can give.
fn keeps_its_books(summary: &Summary, most: f64) {
    let value = |name: &str| summary.metrics[name].value;
    assert_eq!(value("leaked_particles"), 0.0);
    let residual = value("interface_momentum_residual");
    assert!(residual < 1e-12, "action and reaction differ by {residual:e}");
    let rise = value("energy_rise");
    assert!(rise <= most, "the total energy has risen by {rise:e} of what the water can give");
}

#[test]
#[ignore = "takes some seconds"]
fn a_coarse_gate_opens_as_far_as_published() {
    let summary = completed(GATE, "elastic-gate-coarse", &["--spacing", "2.5e-3", "--material", "e12-nu40"]);
    for (name, published, share) in PUBLISHED {
        let value = summary.metrics[name].value;
        let error = value / published - 1.0;
        assert!(error.abs() <= share, "{name} is {value:e} m, {:+.1} % from published", error * 100.0);
    }
    // The rise is 4e-5 at this spacing and below 1e-6 at finer ones (`docs/elastic-gate.md`).
    keeps_its_books(&summary, 6e-5);
}

/// With four sub-steps in a step of the water the force on the gate once lagged behind its motion, and fed
/// it: the total energy had risen by 0.6 % at 0.2 s and by 3 % at 0.25 s (`docs/coupling.md`).
#[test]
#[ignore = "takes half a minute"]
fn a_gate_coarser_than_the_water_is_not_fed_by_it() {
    let coarse = ["--spacing", "1.25e-3", "--across", "3", "--material", "e7.8-nu40", "--end-time", "0.2"];
    keeps_its_books(&completed(GATE, "elastic-gate-few-substeps", &coarse), 1e-6);
}
