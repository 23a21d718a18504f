//! The appended binary section of a VTK file: blocks of little-endian numbers, raw or zlib.
//!
//! Layout, with 64-bit headers (`header_type="UInt64"`; VTK file formats, "XML File Formats"):
//! - raw: byte count, bytes;
//! - zlib: block count, block length, length of the last block if shorter (else 0), compressed
//!   length of each block, then the compressed blocks one after another.

use std::io::{self, Write};

use flate2::Compression;
use flate2::write::ZlibEncoder;
use mps_kernel::{Real, Tensor, Vector};

use super::cloud::Values;

/// Uncompressed bytes a block. VTK's own default is 32 KiB; larger blocks compress a little better
/// and cost the reader nothing.
const BLOCK: usize = 1 << 18;

/// Collects the appended section in memory: its offsets stand in the XML before it.
pub(super) struct Appended {
    compress: bool,
    single: bool,
    /// The section as it will be in the file, after the underscore.
    pub(super) bytes: Vec<u8>,
    /// One array before compression, kept between arrays for its capacity.
    plain: Vec<u8>,
}

impl Appended {
    pub(super) fn new(compress: bool, single: bool) -> Self {
        Self { compress, single, bytes: Vec::new(), plain: Vec::new() }
    }

    /// Forgets all but the first `length` bytes.
    pub(super) fn truncate(&mut self, length: usize) {
        self.bytes.truncate(length);
    }

    pub(super) fn is_compressed(&self) -> bool {
        self.compress
    }

    /// VTK's name of the type in which reals of type `T` are written.
    pub(super) fn real_type<T: Real>(&self) -> &'static str {
        if self.is_single::<T>() { "Float32" } else { "Float64" }
    }

    /// Appends points or vectors, padded to three components; returns their offset.
    pub(super) fn vectors<T: Real, const D: usize>(&mut self, values: &[Vector<T, D>]) -> io::Result<usize> {
        let zero = T::zero();
        self.reals(values, |v: &Vector<T, D>| -> [T; 3] {
            std::array::from_fn(|c| if c < D { v[c] } else { zero })
        })
    }

    /// Appends one field; returns its offset.
    pub(super) fn values<T: Real, const D: usize>(&mut self, values: &Values<'_, T, D>) -> io::Result<usize> {
        match values {
            Values::Scalar(values) => self.reals(values, |v| [*v]),
            Values::Vector(values) => self.vectors(values),
            Values::Tensor(values) => self.reals(values, |t: &Tensor<T, D>| -> [T; 9] {
                std::array::from_fn(|c| {
                    let (row, column) = (c / 3, c % 3);
                    if row < D && column < D { t[(row, column)] } else { T::zero() }
                })
            }),
            Values::Integer(values) => self.integers(values.iter().copied()),
        }
    }

    /// Appends unsigned 32-bit numbers; returns their offset.
    pub(super) fn integers(&mut self, values: impl Iterator<Item = u32>) -> io::Result<usize> {
        self.plain.clear();
        self.plain.extend(values.flat_map(u32::to_le_bytes));
        self.seal()
    }

    /// Appends signed 64-bit numbers; returns their offset.
    pub(super) fn wide_integers(&mut self, values: impl Iterator<Item = i64>) -> io::Result<usize> {
        self.plain.clear();
        self.plain.extend(values.flat_map(i64::to_le_bytes));
        self.seal()
    }

    /// Appends bytes; returns their offset.
    pub(super) fn octets(&mut self, values: impl Iterator<Item = u8>) -> io::Result<usize> {
        self.plain.clear();
        self.plain.extend(values);
        self.seal()
    }

    fn is_single<T: Real>(&self) -> bool {
        self.single || size_of::<T>() == 4
    }

    fn reals<V, T: Real, const C: usize>(
        &mut self,
        values: &[V],
        components: impl Fn(&V) -> [T; C],
    ) -> io::Result<usize> {
        self.plain.clear();
        if self.is_single::<T>() {
            self.plain.reserve(values.len() * C * 4);
            for value in values {
                let c = components(value).map(|c| (c.to_double() as f32).to_le_bytes());
                self.plain.extend_from_slice(c.as_flattened());
            }
        } else {
            self.plain.reserve(values.len() * C * 8);
            for value in values {
                let c = components(value).map(|c| c.to_double().to_le_bytes());
                self.plain.extend_from_slice(c.as_flattened());
            }
        }
        self.seal()
    }

    /// Moves the collected array into the section and returns the offset at which it starts.
    fn seal(&mut self) -> io::Result<usize> {
        let offset = self.bytes.len();
        if !self.compress {
            self.bytes.extend_from_slice(&(self.plain.len() as u64).to_le_bytes());
            self.bytes.extend_from_slice(&self.plain);
            return Ok(offset);
        }
        let blocks = self.plain.len().div_ceil(BLOCK);
        let last = self.plain.len() % BLOCK;
        for header in [blocks, BLOCK, last] {
            self.bytes.extend_from_slice(&(header as u64).to_le_bytes());
        }
        let table = self.bytes.len();
        self.bytes.resize(table + 8 * blocks, 0);
        for (k, block) in self.plain.chunks(BLOCK).enumerate() {
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
