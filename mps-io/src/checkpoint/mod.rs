//! Checkpoints: the state of a run in a file from which it goes on with the same bits.
//!
//! ```text
//! magic          8 bytes  89 4D 50 53 0D 0A 1A 0A: text programs and transfers that change line ends spoil it visibly
//! version        u32      of this layout
//! header length  u32      bytes of the header that follows
//! header         byte order mark u32; program, precision: u32 length and text each; scene: u128 checksum of its text;
//!                number of settings u32, of each name and value; number of sections u32; of each section its name (u32 length and text), bytes of an entry u32,
//!                bytes u64, checksum u128
//! checksum       u128     of everything before
//! sections       one after the other, nothing behind the last
//! ```
//!
//! Numbers are little-endian; sections are as they lie in the memory of the machine, whose byte order the mark tells. Checksums are
//! XXH3-128: no bit of the file is without one.
//!
//! | file | what it does |
//! |---|---|
//! | `identity` | what a checkpoint belongs to, and how it is refused |
//! | `format`, `parse` | bytes from a state, and back |
//! | `rotation` | the two files of a run, written so that one is always whole |
//! | `error` | what can be wrong |

mod error;
mod format;
mod identity;
mod parse;
mod rotation;

pub use error::CheckpointError;
pub use format::encode;
pub use identity::Identity;
pub use parse::decode;
pub use rotation::Rotation;

use mps_kernel::State;
use std::collections::BTreeMap;

/// What a run can go on from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Checkpoint {
    /// What it belongs to.
    pub identity: Identity,
    /// What has to be known before anything is built into which the state can be restored.
    pub settings: BTreeMap<String, String>,
    /// The state.
    pub state: State,
}

const MAGIC: [u8; 8] = [0x89, b'M', b'P', b'S', b'\r', b'\n', 0x1A, b'\n'];
const VERSION: u32 = 1;
const ORDER_MARK: u32 = 0x0102_0304;
/// Bytes before the header.
const PREAMBLE: usize = 16;
