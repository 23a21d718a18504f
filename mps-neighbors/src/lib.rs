//! Who is paired with whom, and how all pairs are visited.
//!
//! - [`Cells`] sorts particles by place, [`Rows`] holds the neighbours found among them, [`Skin`]
//!   says when they must be searched again, [`Permutation`] moves particles into spatial order.
//! - [`RowView`] shows rows to the operators of `mps-kernel`; [`BruteForce`] shows the same pairs
//!   by trying all of them.
//! - [`Open`] and [`PeriodicBox`] are the [`Domain`]s a search can be in.
//! - [`FrozenPairs`] are the reference pairs of a solid, found once.
//! - [`fit`](mod@fit) fills a shape with particles that follow its surface.
//! - [`Parallel`] runs loops whose results do not depend on the number of threads, which
//!   [`state_hash`] makes visible.

mod awake;
mod fields;
pub mod fit;
mod frozen;
mod halves;
mod parallel;
mod parts;

pub use fields::Fields;
pub use frozen::{FrozenError, FrozenPair, FrozenPairs};
pub use parallel::{Parallel, ParallelError, Sweep};

mod brute;
mod cells;
mod domain;
mod error;
mod grid;
mod hash;
mod periodic;
mod permutation;
mod rows;
mod search;
mod skin;
mod view;

pub use brute::BruteForce;
pub use cells::Cells;
pub use domain::{Domain, Open};
pub use error::NeighborError;
pub use hash::state_hash;
pub use periodic::PeriodicBox;
pub use permutation::Permutation;
pub use rows::Rows;
pub use skin::Skin;
pub use view::{Packs, Placed, RowView};
