//! Where the keys of a scene file are, and what is wrong with them.

use std::fmt;
use std::ops::Range;
use std::path::PathBuf;
use thiserror::Error;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The text of a scene file.
#[derive(Clone, Debug)]
pub struct Source {
    name: String,
    text: String,
}

/// Something wrong in a scene file: where, what, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Name of the file.
    pub file: String,
    /// Line, counted from 1.
    pub line: usize,
    /// Column, counted from 1.
    pub column: usize,
    /// The key, as `solids[0].clamp`; empty where there is none.
    pub key: String,
    /// What is wrong.
    pub what: String,
    /// What to do about it.
    pub remedy: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, line, column, key, what, remedy } = self;
        let space = if key.is_empty() { "" } else { " " };
        write!(f, "{file}:{line}:{column}: {key}{space}{what}: {remedy}")
    }
}

/// Why there is no scene.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SceneError {
    /// The file cannot be read.
    #[error("cannot read the scene {}: {reason}. Check the spelling of the path", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The answer of the operating system.
        reason: String,
    },
    /// The scene cannot be written as text.
    #[error("the scene cannot be written as text: {reason}")]
    Unwritable {
        /// The answer of the TOML library.
        reason: String,
    },
    /// The scene, or a file that belongs to it, cannot be written.
    #[error("cannot write {}: {reason}. Check that the directory may be written to and the disk has room", path.display())]
    NotWritten {
        /// The file.
        path: PathBuf,
        /// The answer of the operating system.
        reason: String,
    },
    /// The scene is refused.
    #[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))]
    Refused(Vec<Problem>),
}

impl From<Problem> for SceneError {
    fn from(problem: Problem) -> Self {
        Self::Refused(vec![problem])
    }
}

impl Source {
    /// Of a text and the name it is called by in messages.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self { name: name.into(), text: text.into() }
    }

    /// Name of the file.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Something wrong at `key`. If the file does not have the key, the place is that of the nearest one around it.
    pub fn problem(&self, key: &str, what: impl Into<String>, remedy: impl Into<String>) -> Problem {
        self.problem_at(self.locate(key), key, what, remedy)
    }

    /// Something wrong at a span of the text.
    pub(super) fn problem_at(
        &self,
        span: Range<usize>,
        key: &str,
        what: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Problem {
        let before = self.text.get(..span.start).unwrap_or("");
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        Problem {
            file: self.name.clone(),
            line: before.matches('\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
            key: key.to_owned(),
            what: what.into(),
            remedy: remedy.into(),
        }
    }

    /// Span of the value of a key, or of the nearest one around it.
    fn locate(&self, key: &str) -> Range<usize> {
        let Ok(table) = DeTable::parse(&self.text) else { return 0..0 };
        let mut found = 0..0;
        let mut steps = steps(key);
        let Some(first) = steps.next().and_then(|step| table.get_ref().get(step)) else { return found };
        let mut here: &Spanned<DeValue<'_>> = first;
        loop {
            // A table that has a heading begins where the heading does.
            found = here.span();
            let next = steps.next().and_then(|step| match here.get_ref() {
                DeValue::Table(table) => table.get(step),
                DeValue::Array(array) => array.get(step.parse::<usize>().ok()?),
                _ => None,
            });
            match next {
                Some(next) => here = next,
                None => return found,
            }
        }
    }

    /// The key whose value covers a span most closely.
    pub(super) fn key_at(&self, span: &Range<usize>) -> String {
        let mut best = (usize::MAX, String::new());
        self.walk(|key, value| {
            let here = value.span();
            if here.start <= span.start && span.end <= here.end && here.len() <= best.0 {
                best = (here.len(), key.to_owned());
            }
        });
        best.1
    }

    /// Visits every value of the file with its key.
    pub(super) fn walk(&self, mut visit: impl FnMut(&str, &Spanned<DeValue<'_>>)) {
        if let Ok(table) = DeTable::parse(&self.text) {
            walk_table(table.get_ref(), "", &mut visit);
        }
    }
}

/// `solids[0].clamp` as `solids`, `0`, `clamp`.
fn steps(key: &str) -> impl Iterator<Item = &str> {
    key.split(['.', '[', ']']).filter(|step| !step.is_empty())
}

type Visit<'v> = dyn FnMut(&str, &Spanned<DeValue<'_>>) + 'v;

fn walk_table(table: &DeTable<'_>, path: &str, visit: &mut Visit<'_>) {
    for (name, value) in table.iter() {
        let dot = if path.is_empty() { "" } else { "." };
        walk_value(value, &format!("{path}{dot}{}", name.get_ref()), visit);
    }
}

fn walk_value(value: &Spanned<DeValue<'_>>, path: &str, visit: &mut Visit<'_>) {
    visit(path, value);
    match value.get_ref() {
        DeValue::Table(table) => walk_table(table, path, visit),
        DeValue::Array(array) => {
            for (k, item) in array.iter().enumerate() {
                walk_value(item, &format!("{path}[{k}]"), visit);
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "a = 1\n\n[b]\nc = [ { d = 2 }, { d = 3 } ]\n";

    #[test]
    fn keys_have_lines_and_columns_and_spans_have_keys() {
        let source = Source::new("s.toml", TEXT);
        let at = |key: &str| {
            let problem = source.problem(key, "is wrong", "mend it");
            (problem.line, problem.column)
        };
        assert_eq!(at("a"), (1, 5));
        assert_eq!(at("b.c[1].d"), (4, 24));
        // A key that is not there: the one around it.
        assert_eq!(at("b.c[1].missing.too"), at("b.c[1]"));
        assert_eq!(at("nowhere"), (1, 1));
        let span = TEXT.find('3').unwrap();
        assert_eq!(source.key_at(&(span..span + 1)), "b.c[1].d");
        let text = source.problem("a", "is 1", "give 2").to_string();
        assert_eq!(text, "s.toml:1:5: a is 1: give 2");
    }
}
