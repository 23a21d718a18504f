//! The whole elastic gate at two particles across its thickness, against a published run with the
//! same rubber. A minute long, hence only on request: `cargo test -p mps-examples --test elastic_gate_coarse -- --ignored`.

use mps_io::Summary;
use std::path::Path;
use std::process::Command;

/// Largest displacements of the free end \[m\]: Ng et al. 2020 (SPH-VCPM) with 12 MPa and 0.4, as in
/// the example's `reference.rs`.
const PUBLISHED: [(&str, f64, f64); 2] = [("gate_x_max", 0.03895, 0.08), ("gate_y_max", 0.01371, 0.15)];

#[test]
#[ignore = "takes a minute"]
fn a_coarse_gate_opens_as_far_as_published() {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join("elastic-gate-coarse");
    let _ = std::fs::remove_dir_all(&dir);
    let status = Command::new(env!("CARGO_BIN_EXE_elastic-gate"))
        .args(["--spacing", "2.5e-3", "--material", "e12-nu40", "--no-fields", "--quiet", "--out"])
        .arg(&dir)
        .status()
        .unwrap();
    assert!(status.success());

    let summary = Summary::read(dir.join("summary.json")).unwrap();
    assert_eq!(summary.status, "completed");
    let value = |name: &str| summary.metrics[name].value;
    for (name, published, share) in PUBLISHED {
        let error = value(name) / published - 1.0;
        assert!(
            error.abs() <= share,
            "{name} is {:e} m, {:+.1} % from published",
            value(name),
            error * 100.0
        );
    }
    assert_eq!(value("leaked_particles"), 0.0);
    let residual = value("interface_momentum_residual");
    assert!(residual < 1e-12, "action and reaction differ by {residual:e}");
    let rise = value("energy_closure");
    assert!(rise <= 1e-6, "the total energy has risen by {rise:e} of what the water can give");
}
