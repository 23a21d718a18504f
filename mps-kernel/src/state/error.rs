//! Why a state is refused.

use thiserror::Error;

/// A state that cannot be saved, or does not fit what it is to be restored into.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum StateError {
    /// The state has fewer sections than what it is restored into.
    #[error(
        "the saved state ends before '{section}': restore it into a scene built like the one that was saved, by the same program"
    )]
    Missing {
        /// The section that was expected.
        section: String,
    },
    /// Another section is where one was expected.
    #[error(
        "the saved state has '{found}' where '{expected}' belongs: restore it into a scene built like the one that was saved, by the \
         same program"
    )]
    Other {
        /// The section that was expected.
        expected: String,
        /// The section that is there.
        found: String,
    },
    /// The state has more sections than what it is restored into.
    #[error(
        "nothing takes '{section}' of the saved state: restore it into a scene built like the one that was saved, by the same program"
    )]
    Left {
        /// The first section that is left.
        section: String,
    },
    /// Entries of another size.
    #[error(
        "an entry of '{section}' takes {found} bytes in the saved state and {expected} here: use the precision it was saved with"
    )]
    Entry {
        /// The section.
        section: String,
        /// Bytes of an entry of what is restored.
        expected: usize,
        /// Bytes of an entry in the state.
        found: usize,
    },
    /// Another number of entries.
    #[error(
        "'{section}' has {found} entries in the saved state and {expected} here: restore it into a scene built like the one that was saved"
    )]
    Length {
        /// The section.
        section: String,
        /// Entries of what is restored.
        expected: usize,
        /// Entries in the state.
        found: usize,
    },
    /// A part has a reason of its own.
    #[error("{part}{}{reason}", if part.is_empty() { "" } else { ": " })]
    Refused {
        /// The part.
        part: String,
        /// What is wrong and what to do.
        reason: String,
    },
}
