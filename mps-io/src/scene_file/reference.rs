//! Every key of scene files, as Markdown: written from the schema, so that it cannot be out of date.

use serde_json::Value;
use std::fmt::Write;

/// A table of keys or choices for the scene and for each of its parts.
pub fn reference() -> String {
    let schema = super::schema();
    let mut text = String::new();
    section(&mut text, "Scene", &schema);
    for (name, part) in schema["$defs"].as_object().into_iter().flatten() {
        section(&mut text, name, part);
    }
    text
}

// Writing into a String cannot fail, here and below.
fn section(text: &mut String, name: &str, part: &Value) {
    let _ = writeln!(text, "### {name}\n\n{}.\n", words(part));
    if let Some(choices) = part["oneOf"].as_array() {
        let _ = writeln!(text, "| choice | meaning |\n|---|---|");
        choices.iter().for_each(|choice| self::choice(text, choice));
    } else {
        let _ = writeln!(text, "| key | value | default | meaning |\n|---|---|---|---|");
        let required: Vec<&str> =
            part["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
        for (key, value) in part["properties"].as_object().into_iter().flatten() {
            let default = match value.get("default") {
                _ if required.contains(&key.as_str()) => "needed".to_owned(),
                None | Some(Value::Null | Value::Object(_)) => "-".to_owned(),
                Some(default) => format!("`{default}`"),
            };
            let _ = writeln!(text, "| `{key}` | {} | {default} | {} |", kind(value), words(value));
        }
    }
    text.push('\n');
}

/// A row for a choice: a word, or a word with what belongs to it.
fn choice(text: &mut String, choice: &Value) {
    let meaning = words(choice);
    if let Some(word) = choice["const"].as_str() {
        let _ = writeln!(text, "| `\"{word}\"` | {meaning} |");
    }
    for (key, value) in choice["properties"].as_object().into_iter().flatten() {
        let _ = writeln!(text, "| `{{ {key} = ... }}` with {} | {meaning} |", kind(value));
    }
}

/// The description in one line.
fn words(value: &Value) -> String {
    value["description"]
        .as_str()
        .unwrap_or_default()
        .lines()
        .collect::<Vec<_>>()
        .join(" ")
        .replace("|", "\\|")
}

/// What a value is: a number, a text, a list of something, another part.
fn kind(value: &Value) -> String {
    if let Some(target) = value["$ref"].as_str() {
        let name = target.rsplit('/').next().unwrap_or(target);
        return format!("[{name}](#{})", name.to_lowercase());
    }
    // What may be left out is itself or nothing.
    if let Some(kinds) = value["anyOf"].as_array() {
        return kinds.iter().find(|kind| kind["type"] != "null").map(kind_of).unwrap_or_default();
    }
    kind_of(value)
}

fn kind_of(value: &Value) -> String {
    if value.get("$ref").is_some() {
        return kind(value);
    }
    let name = match &value["type"] {
        Value::Array(names) => names.iter().find_map(Value::as_str),
        name => name.as_str(),
    };
    match name {
        Some("array") => match value["items"]["type"].as_str() {
            Some("number") => "point".to_owned(),
            Some("array") => "list of points".to_owned(),
            _ => format!("list of {}", kind(&value["items"])),
        },
        Some("integer") => "whole number".to_owned(),
        Some("boolean") => "`true` or `false`".to_owned(),
        Some("string") => "text".to_owned(),
        Some(other) => other.to_owned(),
        None => String::new(),
    }
}
