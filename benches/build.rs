//! Tells the program `count` which compiler and which profile it was built with: counts of instructions depend on both.

#![allow(clippy::print_stdout, reason = "how a build script talks to cargo")]

use std::path::Path;
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let variable = |name: &str| std::env::var(name).unwrap_or_default();
    let version = Command::new(variable("RUSTC")).arg("--version").output();
    let version =
        version.map_or_else(|_| String::new(), |output| String::from_utf8_lossy(&output.stdout).into());
    println!("cargo::rustc-env=MPS_RUSTC={}", version.trim());
    // Cargo names only the profile one inherits from; the folder has the name of its own: <profile>/build/<package>/out.
    let out = variable("OUT_DIR");
    let folder = Path::new(&out).ancestors().nth(3).and_then(Path::file_name);
    println!("cargo::rustc-env=MPS_PROFILE={}", folder.unwrap_or_default().to_string_lossy());
}
