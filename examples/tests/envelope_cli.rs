//! Both sides of every border of the envelope: fine on one, broken on the other, and where theory has them.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::{execute, fresh, root, words};
use mps_io::Value;

const ENVELOPE: &str = env!("CARGO_BIN_EXE_envelope");

/// Borders for which theory is exact up to this share: those of linear waves on a lattice, and of modes.
const PREDICTED: &[(&str, f64)] = &[
    ("courant-rational", 0.01),
    ("courant-smooth", 0.01),
    ("courant-corrected", 0.01),
    ("courant-3d", 0.01),
    ("courant-diffused", 0.01),
    ("courant-diffused-smooth", 0.01),
    ("diffusion", 0.01),
    ("viscous-laminar", 0.01),
    ("viscous-compact", 0.01),
    ("viscous-wendland", 0.01),
    ("viscous-artificial", 0.01),
    ("solid-courant", 0.02),
    ("solid-courant-rubber", 0.02),
    ("solid-courant-3d", 0.02),
];

#[test]
fn every_border_is_where_the_map_says_and_where_theory_has_it() {
    let dir = fresh("envelope", "quick");
    let output = execute(ENVELOPE, &dir, &["--quick", "--quiet"]);
    assert!(output.status.success(), "{}", words(&output.stderr));

    let map: Value = std::fs::read_to_string(dir.join("envelope.json")).unwrap().parse().unwrap();
    let borders = map["borders"].as_array().unwrap();
    assert!(borders.len() >= 30, "{} borders", borders.len());
    for border in borders {
        assert!(border["as_known"].as_bool().unwrap(), "{border}");
        for words in ["mechanism", "remedy"] {
            assert!(border[words].as_str().is_some_and(|text| !text.is_empty()), "{border}");
        }
    }
    for &(name, share) in PREDICTED {
        let border = borders.iter().find(|border| border["border"] == name);
        let border = border.unwrap_or_else(|| panic!("no border {name}"));
        let predicted = border["predicted"].as_f64().unwrap();
        let [fine, broken] =
            [&border["fine"][0], &border["broken"]].map(|side| side["value"].as_f64().unwrap());
        let good = fine > predicted * (1.0 - share) && broken < predicted * (1.0 + share);
        assert!(good, "{name}: fine at {fine}, broken at {broken}, predicted {predicted}");
    }
    let text = std::fs::read_to_string(dir.join("envelope.md")).unwrap();
    assert_eq!(text.lines().count(), borders.len() + 2, "a row for every border");
    let page = std::fs::read_to_string(root().join("docs/envelope.md")).unwrap();
    let missing: Vec<_> = text.lines().filter(|line| !page.contains(line)).collect();
    assert!(missing.is_empty(), "docs/envelope.md does not have\n{}", missing.join("\n"));
    assert!(std::fs::read_to_string(dir.join("envelope.csv")).unwrap().contains("\nviscous-laminar,"));
}

#[test]
fn a_name_of_no_border_and_a_value_of_none_are_refused() {
    for (arguments, flag, remedy) in [
        (["--only", "cliff", "--quick"].as_slice(), "--only", "courant-rational"),
        (&["--at", "0.5"], "--at", "with --only"),
    ] {
        let dir = fresh("envelope", "refused");
        let output = execute(ENVELOPE, &dir, arguments);
        let message = words(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(message.starts_with(&format!("error: {flag} is ")) && message.contains(remedy), "{message}");
        assert!(!dir.exists(), "something is left");
    }
}

#[test]
fn a_value_can_be_tried() {
    let dir = fresh("envelope", "at");
    let output = execute(ENVELOPE, &dir, &["--only", "thickness-hooke", "--at", "2", "--at", "1"]);
    assert!(output.status.success());
    let said = words(&output.stderr);
    assert!(
        said.contains("thickness-hooke at 2: fine") && said.contains("thickness-hooke at 1: ends:"),
        "{said}"
    );
    assert!(!dir.exists(), "something is left");
}
