//! `cargo bench -p mps-benches -- FLAGS` hands the flags to everything that it runs, and only benchmarks understand those of criterion.

#[test]
fn flags_of_criterion_reach_benchmarks_only() {
    let manifest = include_str!("../Cargo.toml");
    let sections = manifest.split("\n[").map(|section| section.trim_start_matches('['));
    let others: Vec<&str> =
        sections.filter(|section| section.starts_with("lib]") || section.starts_with("bin]")).collect();
    assert!(others.len() > 1, "the library and the program are looked for by their headings");
    for section in others {
        assert!(section.contains("\nbench = false"), "run by cargo bench: [{section}");
    }
}
