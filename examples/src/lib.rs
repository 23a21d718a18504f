//! Shared parts of the example programs: the flags they have in common, how a run is refused, when
//! something is due in a time loop, and the closing words.

mod cli;
mod schedule;
mod words;

pub use cli::{Common, Precision, Refused};
pub use schedule::{Due, Moments};
pub use words::{closing_words, report_failure};

/// Any error of an example, already worded for the user.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;

/// The code of the front page compiles.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
