//! Whether commands name what is there: packages, targets, features, flags, choices, files.

use super::common::{packages, root, words};
use mps_io::Value;
use std::path::Path;
use std::process::Command;

/// What can be run in the workspace.
pub(crate) struct Programs {
    packages: Vec<Value>,
}

/// A fault, worded; nothing if there is none.
type Fault = Option<String>;

fn unless(good: bool, fault: impl FnOnce() -> String) -> Fault {
    (!good).then(fault)
}

impl Programs {
    pub(crate) fn of_the_workspace() -> Self {
        Self { packages: packages() }
    }

    /// Whether a piece of code within a text is a command.
    pub(crate) fn is_command(&self, span: &str) -> bool {
        let mut parts = span.split(' ').skip_while(|word| is_setting(word));
        let program = parts.next().unwrap_or_default();
        parts.next().is_some() && (matches!(program, "cargo" | "--bin") || self.is_program(program))
    }

    fn is_program(&self, name: &str) -> bool {
        self.has_target(None, "bin", name)
    }

    /// The first fault of a script of one command a line.
    pub(crate) fn fault_of_script(&self, script: &str) -> Fault {
        let script = script.replace("\\\n", " ");
        let lines = script.lines().map(|line| {
            line.split(" #").next().unwrap_or_default().split(" > ").next().unwrap_or_default().trim()
        });
        lines.filter(|line| !line.is_empty() && !line.starts_with('#')).find_map(|line| self.fault(line))
    }

    /// What is wrong with a command.
    pub(crate) fn fault(&self, command: &str) -> Fault {
        let words: Vec<&str> = command.split_whitespace().skip_while(|word| is_setting(word)).collect();
        let (program, rest) = words.split_first()?;
        let name = program.rsplit('/').next().unwrap_or_default();
        match name {
            "cargo" => self.fault_of_cargo(rest),
            // The text often leaves out what all commands begin with.
            "--bin" => self.fault_of_cargo(&[&["run"], &words[..]].concat()),
            "cd" => None,
            "cp" => rest.first().and_then(|file| fault_of_file(file)),
            name if self.is_program(name) => fault_of_program(name, rest),
            name => Some(format!("`{name}` is no program of the workspace")),
        }
    }

    fn fault_of_cargo(&self, words: &[&str]) -> Fault {
        let end = words.iter().position(|word| *word == "--").unwrap_or(words.len());
        let (own, handed) = (&words[..end], words.get(end + 1..).unwrap_or_default());
        let (task, own) = own.split_first()?;
        let mut package = None;
        let mut program = None;
        let mut words = own.iter();
        while let Some(word) = words.next() {
            let mut value = || words.next().copied().unwrap_or_default();
            let fault = match (*task, *word) {
                (_, "-p") => {
                    package = Some(value());
                    unless(self.package(package).is_some(), || format!("there is no package {package:?}"))
                }
                (_, kind @ ("--bin" | "--example" | "--test")) => {
                    let (kind, name) = (&kind[2..], value());
                    program = (kind == "bin").then_some(name);
                    unless(self.has_target(package, kind, name), || format!("there is no {kind} {name}"))
                }
                (_, "--features") => {
                    let feature = value();
                    unless(self.has_feature(package, feature), || format!("there is no feature {feature}"))
                }
                ("add", "--path") => {
                    let name = value().rsplit('/').next();
                    unless(self.package(name).is_some(), || format!("there is no package {name:?}"))
                }
                (_, "--release" | "--workspace" | "--all-targets" | "--doc") => None,
                // The filter of a test, the name of a new package.
                ("test" | "bench" | "new" | "init", word) if !word.starts_with('-') => None,
                (task, word) => Some(format!("`{word}` of `cargo {task}` is not known here")),
            };
            if fault.is_some() {
                return fault;
            }
        }
        program.filter(|_| *task == "run").and_then(|program| fault_of_program(program, handed))
    }

    fn package(&self, name: Option<&str>) -> Option<&Value> {
        self.packages.iter().find(|package| package["name"].as_str() == name)
    }

    fn has_target(&self, package: Option<&str>, kind: &str, name: &str) -> bool {
        let members =
            self.packages.iter().filter(|member| package.is_none() || member["name"].as_str() == package);
        members
            .flat_map(|member| member["targets"].as_array().unwrap())
            .any(|target| target["name"].as_str() == Some(name) && target["kind"][0].as_str() == Some(kind))
    }

    fn has_feature(&self, package: Option<&str>, feature: &str) -> bool {
        let (package, feature) = match feature.split_once('/') {
            Some((package, feature)) => (Some(package), feature),
            None => (package, feature),
        };
        self.package(package).is_some_and(|package| !package["features"][feature].is_null())
    }
}

/// `POISSON=0.3`, before a command.
fn is_setting(word: &str) -> bool {
    word.split_once('=').is_some_and(|(name, _)| name.chars().all(|c| c.is_ascii_uppercase() || c == '_'))
}

/// What stands for something the reader fills in: `DIR`, `OPTIONS`.
fn is_placeholder(word: &str) -> bool {
    word.chars().any(|c| c.is_ascii_uppercase())
}

/// What is wrong with the arguments of a program, as its help has them.
fn fault_of_program(name: &str, words: &[&str]) -> Fault {
    // What may be left out stands in brackets.
    let mut words: Vec<&str> = words.iter().map(|word| word.trim_matches(['[', ']'])).collect();
    let has_commands = help(name, None).is_some_and(|text| text.contains("\nCommands:"));
    let command = if has_commands && !words.is_empty() { Some(words.remove(0)) } else { None };
    let Some(help) = help(name, command) else { return Some(format!("{name} has no command {command:?}")) };
    let mut words = words.into_iter();
    while let Some(word) = words.next() {
        let fault = if let Some(line) = help.lines().find(|line| flag_of(line) == Some(word)) {
            let takes_value = line.contains(&format!("{word} <"));
            takes_value.then(|| words.next()).flatten().and_then(|value| fault_of_choice(line, value))
        } else if word.starts_with('-') {
            Some(format!("{name} has no flag {word}"))
        } else if word.starts_with("examples/") {
            fault_of_file(word)
        } else {
            // Files of the reader, for programs that take some.
            unless(is_placeholder(word) || help.contains("Arguments:"), || format!("{name} takes no {word}"))
        };
        if fault.is_some() {
            return fault;
        }
    }
    None
}

fn fault_of_file(file: &str) -> Fault {
    unless(root().join(file).exists(), || format!("there is no file {file}"))
}

/// The short help of a program, or of one of its commands.
fn help(name: &str, command: Option<&str>) -> Option<String> {
    let path = Path::new(env!("CARGO_BIN_EXE_mps")).with_file_name(name);
    let output = Command::new(path).args(command).arg("-h").output().unwrap();
    output.status.success().then(|| words(&output.stdout))
}

/// `--spacing` of a line of the help that begins with this flag.
fn flag_of(line: &str) -> Option<&str> {
    line.split_whitespace().find(|word| word.starts_with("--") && line.trim_start().starts_with('-'))
}

/// A choice that the line of the help does not have.
fn fault_of_choice(line: &str, value: &str) -> Fault {
    let choices = line.split_once("[possible values: ")?.1.split(']').next()?;
    let known = |choice: &str| is_placeholder(choice) || choices.split(", ").any(|known| known == choice);
    value.split('|').find(|choice| !known(choice)).map(|choice| format!("{choice} is none of {choices}"))
}
