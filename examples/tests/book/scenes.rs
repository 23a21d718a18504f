//! Whether blocks are scenes, or parts of one.

use super::common::root;
use mps_io::scene_file::{Source, parse};

/// Why a text is no scene.
pub(crate) fn fault(text: &str) -> Option<String> {
    fault_of("block", text)
}

/// The same of a text that is in a file of this name, from whose directory the paths of shapes count.
fn fault_of(file: &str, text: &str) -> Option<String> {
    parse(&Source::new(file, text)).err().map(|error| error.to_string())
}

/// Why a text cannot take the place of the same tables of a scene of the gallery.
pub(crate) fn fault_of_part(text: &str, scene: &str) -> Option<String> {
    let path = root().join("examples/scenes").join(scene).with_extension("toml");
    let whole = match std::fs::read_to_string(&path) {
        Ok(whole) => whole,
        Err(error) => return Some(format!("{scene}: {error}")),
    };
    let part = tables(text);
    let replaced = |table: &str| part.iter().any(|other| heading(other) == heading(table));
    let kept = tables(&whole).into_iter().filter(|table| !replaced(table));
    // What has no heading comes first, and a table before its parts.
    let mut all: Vec<String> = kept.chain(part.iter().cloned()).collect();
    all.sort_by_key(|table| heading(table).trim_matches(['[', ']']).to_owned());
    fault_of(&path.display().to_string(), &all.concat())
}

/// The text before the first heading, and each table with its heading.
fn tables(text: &str) -> Vec<String> {
    let mut tables = vec![String::new()];
    for line in text.lines() {
        if line.starts_with('[') {
            tables.push(String::new());
        }
        let table = tables.last_mut().unwrap();
        table.push_str(line);
        table.push('\n');
    }
    tables.retain(|table| !table.trim().is_empty());
    tables
}

/// `[[solids]]`; nothing for what comes before all headings.
fn heading(table: &str) -> &str {
    table.lines().next().filter(|line| line.starts_with('[')).unwrap_or("")
}
