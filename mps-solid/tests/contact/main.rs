//! Contact of bodies with each other and with themselves.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod collisions;
#[path = "../common/mod.rs"]
mod common;
mod contract;
mod failure;
mod folded;
mod refusal;
mod rest;
mod scene;
mod sliding;
