//! Both sides of the borders of section 14 of `docs/solid.md`: the step, the stretch, failures, scales.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

#[path = "../common/mod.rs"]
mod common;
mod failure;
mod scales;
mod scene;
mod step;
mod strain;
