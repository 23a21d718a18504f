//! The book (`docs/`, and the front pages) says what is so: every block of code is checked according to its kind, every
//! command against the programs, every link against the files.
//!
//! | kind of block | what is checked |
//! |---|---|
//! | `sh` | programs, targets, flags and choices exist (`commands`) |
//! | `rust` | the page is among those whose blocks are doc tests (`examples/src/book.rs`) |
//! | `toml` | it is read as a scene: keys and numbers, not whether its parts fit |
//! | `toml NAME` | it is a part of a scene: put in place of the same tables of `examples/scenes/NAME.toml` |
//! | `message` | each piece between dots is in a source: programs really say it |
//! | `text` | nothing: formulas, and what a program prints |
//! | `arrows`, `homes` | see `architecture.rs` |
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod blocks;
mod commands;
#[path = "../common/mod.rs"]
mod common;
mod links;
mod messages;
mod scenes;

use blocks::{Block, blocks, pages};
use commands::Programs;
use std::path::Path;

#[test]
fn every_block_of_code_is_what_it_says() {
    let programs = Programs::of_the_workspace();
    let sources = messages::sources();
    let doc_tests = std::fs::read_to_string(common::root().join("examples/src/book.rs")).unwrap();
    let mut faults = Vec::new();
    let mut tested = 0;
    for block in blocks() {
        tested += usize::from(block.kind != "text");
        let found = match (block.kind.as_str(), block.kind.split_once(' ')) {
            ("sh", _) => programs.fault_of_script(&block.text),
            ("rust", _) => fault_of_rust(&block, &doc_tests),
            ("toml", _) => scenes::fault(&block.text),
            (_, Some(("toml", scene))) => scenes::fault_of_part(&block.text, scene),
            ("message", _) => messages::fault(&block.text, &sources),
            ("text", _) => None,
            ("arrows" | "homes", _) if block.page == "ARCHITECTURE.md" => None,
            (kind, _) => Some(format!("`{kind}` is no kind of block that could be tested")),
        };
        faults.extend(found.map(|fault| format!("{}:{}: {fault}", block.page, block.line)));
    }
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
    assert!(tested > 20, "only {tested} blocks were found");
}

fn fault_of_rust(block: &Block, doc_tests: &str) -> Option<String> {
    let included = doc_tests.contains(&format!("include_str!(\"../../{}\")", block.page));
    (!included).then(|| format!("examples/src/book.rs does not test the Rust blocks of {}", block.page))
}

#[test]
fn commands_within_the_text_are_those_of_the_programs() {
    let programs = Programs::of_the_workspace();
    let mut faults = Vec::new();
    let mut found = 0;
    for page in pages() {
        for span in blocks::code_spans(&page).filter(|span| programs.is_command(span)) {
            found += 1;
            faults.extend(programs.fault(&span).map(|fault| format!("{page}: `{span}`: {fault}")));
        }
    }
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
    assert!(found > 20, "only {found} commands were found");
}

#[test]
fn every_link_leads_somewhere() {
    let faults: Vec<String> = pages().iter().flat_map(|page| links::faults(page)).collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn the_contents_name_every_page() {
    let contents = blocks::read("docs/README.md");
    for page in pages().iter().filter_map(|page| page.strip_prefix("docs/")) {
        let named = page == "README.md" || contents.contains(&format!("]({page})"));
        assert!(named, "docs/README.md does not lead to {page}");
    }
    assert!(Path::new(&common::root().join("docs/getting-started.md")).exists());
}

/// The checks above have to fail where something is wrong.
#[test]
fn mistakes_are_found() {
    let programs = Programs::of_the_workspace();
    for wrong in [
        "cargo run --release -p mps-exemples --bin mps",
        "cargo run --release -p mps-examples --bin elastic-gat",
        "cargo run -p mps-examples --bin elastic-gate -- --spacng 1e-3",
        "cargo run -p mps-examples --bin elastic-gate -- --material e8.7",
        "cargo run -p mps-examples --bin validate -- water",
        "cargo test -p mps-fluid --test nothing",
        "cargo run -p mps-solid --features matrices --example modes",
        "mps run examples/scenes/no-such-scene.toml",
        "mps chek examples/scenes/wave-maker.toml",
        "mps plan --checkpoint 3 examples/scenes/wave-maker.toml",
        "make all",
    ] {
        assert!(programs.fault_of_script(wrong).is_some(), "{wrong}");
    }
    assert!(scenes::fault("title = \"half a scene\"").is_some());
    assert!(scenes::fault_of_part("[fluid]\nspcing = 1.0", "hydrostatic-tank").is_some());
    assert!(messages::fault("nobody ever says this", &messages::sources()).is_some());
}
