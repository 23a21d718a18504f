//! Instructions a particle and step, counted by valgrind: a price without noise, which does not ask how busy the machine is.
//!
//! - `recipe`: what a counted fluid has and what it has not.
//! - `lean`: the two sweeps of a fluid that has nothing, written by hand, to be held against those of the library.
//! - `subjects`: everything that is counted, by name.
//! - `cachegrind`: how it is counted, in all and by file of the source.
//! - `table`: what was counted before, kept in `benches/counts.csv`; `compare`: what has changed since.

mod cachegrind;
mod compare;
mod lean;
mod recipe;
mod subjects;
mod table;

pub use cachegrind::{Count, CountError, available, instruction_set, per_step};
pub use compare::{Difference, differences};
pub use lean::Lean;
pub use recipe::{Physics, Recipe};
pub use subjects::{Entry, Subject, entries};
pub use table::{Row, Table, TableError};
