//! Whether messages that the book quotes are in the sources.

use super::common::root;
use std::path::Path;

/// All sources of the workspace in one line, with the strings that are continued on a next line in one piece.
pub(crate) fn sources() -> String {
    let mut all = String::new();
    for member in super::common::packages() {
        let manifest = member["manifest_path"].as_str().unwrap();
        collect(&Path::new(manifest).parent().unwrap().join("src"), &mut all);
    }
    assert!(all.len() > 100_000, "the sources are not under {}", root().display());
    let joined: String = all.split("\\\n").map(|line| format!("{}\u{0}", line.trim_start())).collect();
    joined.replace('\u{0}', "")
}

fn collect(directory: &Path, all: &mut String) {
    let Ok(entries) = std::fs::read_dir(directory) else { return };
    for entry in entries {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, all);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            all.push_str(&std::fs::read_to_string(path).unwrap());
        }
    }
}

/// A quoted message that nobody says. `...` stands for what differs from case to case.
pub(crate) fn fault(text: &str, sources: &str) -> Option<String> {
    let message = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut pieces = message.split("...").map(str::trim).filter(|piece| !piece.is_empty());
    pieces.find(|piece| !sources.contains(*piece)).map(|piece| format!("no source says `{piece}`"))
}
