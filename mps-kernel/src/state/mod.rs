//! The state of a simulation as named arrays of plain numbers: out of it, and into it again.
//!
//! What has a state lists its parts once, in a function that a [`Transfer`] goes through in both directions; so what is
//! saved and what is restored cannot come to differ. Such a function takes its structure apart *without* `..`: a field
//! that is added later does not compile until somebody has said whether it belongs to the state.
//!
//! ```
//! use mps_kernel::{State, Transfer};
//!
//! #[derive(Debug, PartialEq)]
//! struct Pendulum {
//!     length: f64,
//!     angle: f64,
//!     swings: Vec<f64>,
//! }
//!
//! impl Pendulum {
//!     fn transfer(&mut self, transfer: &mut Transfer<'_>) {
//!         // Whoever builds the pendulum gives the length again.
//!         let Self { length: _, angle, swings } = self;
//!         transfer.value("angle", angle);
//!         transfer.list("swings", swings);
//!     }
//! }
//!
//! let mut pendulum = Pendulum { length: 2.0, angle: 0.1, swings: vec![0.3, 0.2] };
//! let state = State::save(|transfer| pendulum.transfer(transfer))?;
//! let mut twin = Pendulum { length: 2.0, angle: 0.0, swings: Vec::new() };
//! state.restore(|transfer| twin.transfer(transfer))?;
//! assert_eq!(twin, pendulum);
//! # Ok::<(), mps_kernel::StateError>(())
//! ```

mod error;
mod transfer;

pub use error::StateError;
pub use transfer::Transfer;

use transfer::Way;

/// One array of a state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Section {
    /// Its name, with those of the parts around it: `fluid/boundary/position`.
    pub name: String,
    /// Bytes of an entry.
    pub entry: usize,
    /// The entries as they lie in memory.
    pub bytes: Vec<u8>,
}

/// The state of a simulation: what it needs to go on with the same bits.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct State {
    sections: Vec<Section>,
}

impl State {
    /// Collects what `transfer` goes through.
    ///
    /// # Errors
    /// If a part refuses to be saved.
    pub fn save(transfer: impl FnOnce(&mut Transfer<'_>)) -> Result<Self, StateError> {
        let mut sections = Vec::new();
        let mut out = Transfer::new(Way::Out(&mut sections));
        transfer(&mut out);
        out.finish()?;
        Ok(Self { sections })
    }

    /// Gives what `transfer` goes through the values that were saved. What is restored has to be built as what was saved has been;
    /// after an error it is neither the one nor the other, and has to be thrown away.
    ///
    /// # Errors
    /// If sections are missing, left over, of another name, size or number of entries, or a part refuses.
    pub fn restore(&self, transfer: impl FnOnce(&mut Transfer<'_>)) -> Result<(), StateError> {
        let mut back = Transfer::new(Way::In(self.sections.iter()));
        transfer(&mut back);
        back.finish()
    }

    /// The sections in the order in which they were saved.
    pub fn sections(&self) -> &[Section] {
        &self.sections
    }
}

impl From<Vec<Section>> for State {
    fn from(sections: Vec<Section>) -> Self {
        Self { sections }
    }
}
