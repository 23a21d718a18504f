//! The appended binary section of a VTK file: blocks of little-endian numbers, raw or zlib.
//!
//! Layout, with 64-bit headers (`header_type="UInt64"`; VTK file formats, "XML File Formats"):
//! - raw: byte count, bytes;
//! - zlib: block count, block length, length of the last block if shorter (else 0), compressed
//!   length of each block, then the compressed blocks one after another.

use std::io::{self, Write};

use flate2::Compression;
use flate2::write::ZlibEncoder;

/// Uncompressed bytes a block. VTK's own default is 32 KiB; larger blocks compress a little better
/// and cost the reader nothing.
const BLOCK: usize = 1 << 18;

/// Collects the appended section in memory: its offsets stand in the XML before it.
pub(super) struct Appended {
    compress: bool,
    /// The section as it will be in the file, after the underscore.
    pub(super) bytes: Vec<u8>,
}

impl Appended {
    pub(super) fn new(compress: bool) -> Self {
        Self { compress, bytes: Vec::new() }
    }

    /// Forgets all but the first `length` bytes.
    pub(super) fn truncate(&mut self, length: usize) {
        self.bytes.truncate(length);
    }

    pub(super) fn is_compressed(&self) -> bool {
        self.compress
    }

    /// Appends an array and returns the offset at which it starts.
    pub(super) fn push(&mut self, plain: &[u8]) -> io::Result<usize> {
        let offset = self.bytes.len();
        if !self.compress {
            self.bytes.extend_from_slice(&(plain.len() as u64).to_le_bytes());
            self.bytes.extend_from_slice(plain);
            return Ok(offset);
        }
        let blocks = plain.len().div_ceil(BLOCK);
        let last = plain.len() % BLOCK;
        for header in [blocks, BLOCK, last] {
            self.bytes.extend_from_slice(&(header as u64).to_le_bytes());
        }
        let table = self.bytes.len();
        self.bytes.resize(table + 8 * blocks, 0);
        for (k, block) in plain.chunks(BLOCK).enumerate() {
            let start = self.bytes.len();
            let mut encoder = ZlibEncoder::new(&mut self.bytes, Compression::fast());
            encoder.write_all(block)?;
            encoder.finish()?;
            let length = (self.bytes.len() - start) as u64;
            self.bytes[table + 8 * k..table + 8 * (k + 1)].copy_from_slice(&length.to_le_bytes());
        }
        Ok(offset)
    }
}
