//! The solid at its extremes: where it is stable, where it collapses, and why.
//!
//! `cargo run --release -p mps-solid --features matrix --example extremes -- [step] [collapse] [stretch] [single]`
//!
//! prints the tables of section 14 of `docs/solid.md`, all of them without a word. Lengths are in spacings, times in
//! `l0/c_p`, the density is 1.
#![allow(clippy::print_stdout)]

mod bodies;
mod border;
mod collapse;
mod laws;
mod single;
mod step;
mod stretch;

use std::error::Error;

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> Outcome<()> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let wanted = |name: &str| words.is_empty() || words.iter().any(|word| word == name);
    if wanted("step") {
        step::table()?;
    }
    if wanted("collapse") {
        collapse::table()?;
    }
    if wanted("stretch") {
        stretch::table()?;
    }
    if wanted("single") {
        single::table()?;
    }
    Ok(())
}
