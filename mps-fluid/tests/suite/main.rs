//! Everything the fluid promises, one idea a file.
//!
//! One program instead of one a file: what the fluid is compiled to is the same in most of them, and compiling it is most of
//! the time. `cargo test -p mps-fluid --test suite basins` runs one file. `allocations.rs` beside this folder needs a
//! program of its own.

mod common;

mod basins;
mod budget;
mod collisions;
mod compressibility;
mod conservation;
mod corrected;
mod determinism;
mod explained;
mod free_surface;
mod gaps;
mod halves;
mod hydrostatic;
mod impacts;
mod leaks;
mod moving_walls;
mod narrow;
mod openings;
mod packing;
mod parameters;
mod plates;
mod refusals;
mod relaxing;
mod restart;
mod resting;
mod robustness;
mod shifting;
mod sliding;
mod slip;
mod smoothing;
mod surface_pressure;
mod time_step;
mod wall_consistency;
mod wall_law;
mod walls;
