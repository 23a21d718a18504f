//! From the bytes of a file to a state, or to what is wrong with them.

use super::{Checkpoint, CheckpointError, Identity, MAGIC, ORDER_MARK, PREAMBLE, VERSION};
use mps_kernel::{Section, State};
use std::collections::BTreeMap;
use std::path::Path;
use xxhash_rust::xxh3::xxh3_128;

/// Bytes of a checksum.
const SUM: usize = 16;

/// Reads the checkpoint in `file`, which lies at `path`. Whoever uses it [checks](Identity::check) what it belongs to.
///
/// # Errors
/// If a byte of it is not as it was written, or its layout is of another version. Nothing of it is used then.
pub fn decode(file: &[u8], path: &Path) -> Result<Checkpoint, CheckpointError> {
    let damaged = |part: &str, problem: String| CheckpointError::Damaged {
        path: path.to_path_buf(),
        part: part.to_owned(),
        problem,
    };
    let short =
        |part: &str, needed: usize| damaged(part, format!("ends after {} of {needed} bytes", file.len()));
    let preamble = file.get(..PREAMBLE).ok_or_else(|| short("preamble", PREAMBLE))?;
    if preamble[..8] != MAGIC {
        return Err(damaged("preamble", "does not begin as checkpoints do".to_owned()));
    }
    let mut numbers = Reader(&preamble[8..]);
    let (version, length) = (numbers.u32().unwrap_or(0), numbers.u32().unwrap_or(0) as usize);
    if version != VERSION {
        return Err(CheckpointError::Version { path: path.to_path_buf(), found: version, expected: VERSION });
    }
    let end = PREAMBLE + length;
    let sum = file.get(end..).and_then(|rest| rest.get(..SUM)).ok_or_else(|| short("header", end + SUM))?;
    if xxh3_128(&file[..end]).to_le_bytes() != sum {
        return Err(damaged("header", "does not have its checksum".to_owned()));
    }
    // The bytes are those that were written: what does not fit now was written by another program.
    let (identity, settings, table) = Reader(&file[PREAMBLE..end]).header().ok_or_else(|| {
        damaged("header", "has not the form of this version, or another byte order".to_owned())
    })?;
    let mut at = end + SUM;
    let mut sections = Vec::with_capacity(table.len());
    for Entry { name, entry, bytes: length, sum } in table {
        let part = format!("section '{name}'");
        let bytes = usize::try_from(length).ok().and_then(|length| file.get(at..)?.get(..length));
        let bytes = bytes.ok_or_else(|| short(&part, at.saturating_add(length as usize)))?;
        if xxh3_128(bytes) != sum {
            return Err(damaged(&part, "does not have its checksum".to_owned()));
        }
        at += bytes.len();
        sections.push(Section { name, entry, bytes: bytes.to_vec() });
    }
    match file.len() - at {
        0 => Ok(Checkpoint { identity, settings, state: State::from(sections) }),
        more => Err(damaged("end", format!("{more} bytes follow the last section"))),
    }
}

/// A line of the table of sections.
struct Entry {
    name: String,
    entry: usize,
    bytes: u64,
    sum: u128,
}

/// Takes numbers and texts off the front; `None` where there are none left.
struct Reader<'a>(&'a [u8]);

impl Reader<'_> {
    fn header(mut self) -> Option<(Identity, BTreeMap<String, String>, Vec<Entry>)> {
        if self.take::<4>()? != ORDER_MARK.to_ne_bytes() {
            return None;
        }
        let identity = Identity { program: self.text()?, precision: self.text()?, scene: self.u128()? };
        let settings = (0..self.u32()?).map(|_| Some((self.text()?, self.text()?))).collect::<Option<_>>()?;
        // Not reserved in advance: the number is believed only as far as lines follow.
        let mut table = Vec::new();
        for _ in 0..self.u32()? {
            let (name, entry) = (self.text()?, self.u32()? as usize);
            table.push(Entry { name, entry, bytes: u64::from_le_bytes(self.take()?), sum: self.u128()? });
        }
        self.0.is_empty().then_some((identity, settings, table))
    }

    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (taken, rest) = self.0.split_first_chunk::<N>()?;
        self.0 = rest;
        Some(*taken)
    }

    fn u32(&mut self) -> Option<u32> {
        self.take().map(u32::from_le_bytes)
    }

    fn u128(&mut self) -> Option<u128> {
        self.take().map(u128::from_le_bytes)
    }

    fn text(&mut self) -> Option<String> {
        let length = self.u32()? as usize;
        let (text, rest) = self.0.split_at_checked(length)?;
        self.0 = rest;
        String::from_utf8(text.to_vec()).ok()
    }
}
