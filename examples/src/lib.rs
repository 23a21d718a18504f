//! Shared parts of the example programs: the flags they have in common and how a run is refused.

mod cli;

pub use cli::{Common, Precision, Refused};

/// Any error of an example, already worded for the user.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;

/// The code of the front page compiles.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
