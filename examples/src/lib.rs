//! Shared parts of the example programs: the flags they have in common, how a run is refused, the time loop and when
//! something is due in it, what is read off a series, and the closing words. The bodies that several programs
//! move are in [`solid`], water in a basin in [`basin`], problems with a known solution in [`exact`], and a beam in water in
//! [`submerged`]; scene files become scenes in [`scene`].

pub mod basin;
#[cfg(doctest)]
mod book;
mod cli;
mod conclusion;
mod connected;
pub mod convergence;
pub mod exact;
pub mod harmonics;
mod leftovers;
mod log;
mod milestones;
mod noise;
mod piston;
pub mod poiseuille;
mod preset;
mod recording;
mod released_column;
mod rings;
pub mod scene;
mod schedule;
pub mod series;
pub mod solid;
mod stop;
pub mod submerged;
mod watch;
mod waving;
mod weight;
mod words;

pub use cli::{Common, Precision, Refused};
pub use conclusion::{Cost, conclude, enter_compressibility, enter_results, exit_code};
pub use connected::{GAP, connected};
pub use leftovers::remove_leftovers;
pub use log::LogLevel;
pub use noise::Noise;
pub use piston::Piston;
pub use preset::{Preset, PresetFlag, Settings, parse_with_presets};
pub use recording::{Recorded, record};
pub use released_column::released_column;
pub use rings::rings;
pub use schedule::{Due, Moments};
pub use stop::{Asked, Stop, Stopped};
pub use watch::Watch;
pub use waving::Waving;
pub use weight::Weight;
pub use words::{closing_words, report_failure};

/// Any error of an example, already worded for the user.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;
