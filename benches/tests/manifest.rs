//! `cargo bench -p mps-benches -- FLAGS` hands the flags to everything that it runs, and only benchmarks understand those of criterion.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

#[test]
fn flags_of_criterion_reach_benchmarks_only() {
    let manifest = include_str!("../Cargo.toml");
    let sections: Vec<&str> = manifest.split("\n[").map(|section| section.trim_start_matches('[')).collect();
    for name in ["lib]", "bin]"] {
        let section = sections.iter().find(|section| section.starts_with(name)).unwrap();
        assert!(section.contains("\nbench = false"), "run by cargo bench: [{section}");
    }
}
