//! ARCHITECTURE.md draws arrows between the crates and names a home for every library from outside.
//! Here the drawing is compared with what cargo sees, in both directions.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::{packages, root};
use mps_io::Value;
use std::collections::{BTreeMap, BTreeSet};

type Table = BTreeMap<String, BTreeSet<String>>;

/// Normal dependencies of every member of the workspace, as cargo reads the manifests.
fn dependencies() -> Table {
    let name = |value: &Value| value["name"].as_str().unwrap().to_owned();
    packages()
        .iter()
        .map(|package| {
            let all = package["dependencies"].as_array().unwrap();
            // "dev" and "build" say so; a normal dependency has no kind.
            let normal = all.iter().filter(|dependency| dependency["kind"].is_null());
            (name(package), normal.map(name).collect())
        })
        .collect()
}

/// Lines `one -> two, three` of the block of ARCHITECTURE.md that is fenced as `language`.
fn block(language: &str) -> Table {
    let text = std::fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let fence = format!("```{language}");
    let lines = text.lines().skip_while(|line| *line != fence).skip(1).take_while(|line| *line != "```");
    let table: Table = lines
        .map(|line| {
            let (from, to) = line.split_once("->").unwrap_or_else(|| panic!("no arrow in '{line}'"));
            let to = to.split(',').map(|name| name.trim().to_owned()).filter(|name| !name.is_empty());
            (from.trim().to_owned(), to.collect())
        })
        .collect();
    assert!(!table.is_empty(), "ARCHITECTURE.md has no block fenced as {language}");
    table
}

#[test]
fn the_arrows_are_those_of_the_manifests() {
    let mut found = dependencies();
    let members: BTreeSet<String> = found.keys().cloned().collect();
    for to in found.values_mut() {
        to.retain(|name| members.contains(name));
    }
    assert_eq!(found, block("arrows"), "left: the manifests, right: ARCHITECTURE.md");
}

#[test]
fn every_library_from_outside_has_its_home() {
    let found = dependencies();
    let mut homes = Table::new();
    for (member, to) in &found {
        for library in to.iter().filter(|name| !found.contains_key(*name)) {
            homes.entry(library.clone()).or_default().insert(member.clone());
        }
    }
    assert_eq!(homes, block("homes"), "left: the manifests, right: ARCHITECTURE.md");
}

#[test]
fn the_phases_do_not_know_each_other_nor_the_writer() {
    let found = dependencies();
    let knows = |from: &str, to: &str| found[from].contains(to);
    assert!(!knows("mps-fluid", "mps-solid") && !knows("mps-solid", "mps-fluid"));
    for quiet in ["mps-kernel", "mps-neighbors", "mps-fluid", "mps-solid", "mps-coupling"] {
        assert!(!knows(quiet, "mps-io"), "{quiet} writes");
    }
}
