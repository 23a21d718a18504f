//! Tables as NumPy files: binary rows for runs whose text would be long to write and slow to read.
//!
//! ```text
//! magic     93 4E 55 4D 50 59 03 00     format 3.0 of NumPy: the header is UTF-8
//! length    u32 little-endian           of the header
//! header    {'descr': [('time [s]', '<f8'), ...], 'fortran_order': False, 'shape': (       12,), }
//! rows      f64 little-endian           one number a column
//! ```
//!
//! `numpy.load("probes.npy")["time [s]"]` is a column. The number of rows has a fixed width, so that it can grow in place.

use std::fmt::Write as _;
use std::fs::{File, OpenOptions};
use std::io::{Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};

use crate::{CsvTable, OutputError};

const MAGIC: &[u8; 8] = b"\x93NUMPY\x03\x00";
/// Digits of the number of rows.
const DIGITS: usize = 20;
/// The header ends at a multiple of this.
const ALIGN: usize = 64;

/// A table that grows by one row at a time, complete after every row.
pub(crate) struct NpyWriter {
    path: PathBuf,
    file: File,
    columns: usize,
    rows: u64,
    head: Head,
}

/// The beginning of a file.
struct Head {
    bytes: Vec<u8>,
    /// Where the number of rows stands.
    count: usize,
}

impl Head {
    fn new(columns: &[&str]) -> Self {
        let mut text = String::from("{'descr': [");
        for name in columns {
            let name = name.replace('\\', "\\\\").replace('\'', "\\'");
            // Writing into a String cannot fail.
            let _ = write!(text, "('{name}', '<f8'), ");
        }
        text += "], 'fortran_order': False, 'shape': (";
        let start = MAGIC.len() + 4;
        let count = start + text.len();
        let _ = write!(text, "{:>DIGITS$},), }}", 0);
        // NumPy wants a line end as the last byte.
        let length = (start + text.len() + 1).next_multiple_of(ALIGN) - start;
        let _ = writeln!(text, "{:1$}", "", length - text.len() - 1);
        let mut bytes = MAGIC.to_vec();
        bytes.extend_from_slice(&(length as u32).to_le_bytes());
        bytes.extend_from_slice(text.as_bytes());
        Self { bytes, count }
    }

    fn position(&self, row: u64, columns: usize) -> u64 {
        self.bytes.len() as u64 + 8 * row * columns as u64
    }
}

impl NpyWriter {
    pub(crate) fn create(path: &Path, columns: &[&str]) -> Result<Self, OutputError> {
        let mut file = File::create(path).map_err(OutputError::file("create", path))?;
        let head = Head::new(columns);
        file.write_all(&head.bytes).map_err(OutputError::file("write", path))?;
        Ok(Self { path: path.to_path_buf(), file, columns: columns.len(), rows: 0, head })
    }

    pub(crate) fn resume(path: &Path, columns: &[&str]) -> Result<Self, OutputError> {
        let open = OpenOptions::new().read(true).write(true).open(path);
        let mut file = open.map_err(OutputError::file("open", path))?;
        let head = Head::new(columns);
        let mut found = vec![0; head.bytes.len()];
        file.read_exact(&mut found).map_err(OutputError::file("read", path))?;
        let count = found.get(head.count..head.count + DIGITS).and_then(|digits| str::from_utf8(digits).ok());
        let told: Option<u64> = count.and_then(|digits| digits.trim().parse().ok());
        // A file that was cut short has fewer rows than its head says.
        let length = file.metadata().map_err(OutputError::file("read", path))?.len();
        let whole = (length - head.bytes.len() as u64) / (8 * columns.len().max(1) as u64);
        let rows = told.map(|rows| rows.min(whole));
        let zeroed = |mut bytes: Vec<u8>| {
            bytes[head.count..head.count + DIGITS].fill(b' ');
            bytes
        };
        let Some(rows) = rows.filter(|_| zeroed(found) == zeroed(head.bytes.clone())) else {
            let problem = "does not have the columns of this run: put the file of the run back".to_owned();
            return Err(OutputError::Table { path: path.to_path_buf(), line: 1, problem });
        };
        Ok(Self { path: path.to_path_buf(), file, columns: columns.len(), rows, head })
    }

    /// Goes back to this many rows.
    pub(crate) fn cut(&mut self, rows: u64) -> Result<(), OutputError> {
        if rows > self.rows {
            let problem = format!(
                "the file has {} rows, and the checkpoint is of a run with {rows} rows: put it back",
                self.rows
            );
            return Err(OutputError::Table { path: self.path.clone(), line: 1, problem });
        }
        let length = self.head.position(rows, self.columns);
        self.file.set_len(length).map_err(OutputError::file("cut", &self.path))?;
        self.rows = rows;
        self.count().map_err(OutputError::file("write", &self.path))
    }

    pub(crate) fn row(&mut self, values: &[f64]) -> Result<(), OutputError> {
        if values.len() != self.columns {
            let (path, row) = (self.path.clone(), self.rows + 1);
            return Err(OutputError::RowLength { path, expected: self.columns, found: values.len(), row });
        }
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        let end = self.head.position(self.rows, self.columns);
        let written = self.file.seek(SeekFrom::Start(end)).and_then(|_| self.file.write_all(&bytes));
        written.map_err(OutputError::file("write", &self.path))?;
        // Behind the row: what counts is there.
        self.rows += 1;
        self.count().map_err(OutputError::file("write", &self.path))
    }

    pub(crate) fn rows(&self) -> u64 {
        self.rows
    }

    pub(crate) fn sync(&self) -> Result<(), OutputError> {
        self.file.sync_data().map_err(OutputError::file("write", &self.path))
    }

    fn count(&mut self) -> std::io::Result<()> {
        self.file.seek(SeekFrom::Start(self.head.count as u64))?;
        self.file.write_all(format!("{:>DIGITS$}", self.rows).as_bytes())
    }
}

/// Reads a file that this module wrote.
pub(crate) fn read(path: &Path) -> Result<CsvTable, OutputError> {
    let bytes = std::fs::read(path).map_err(OutputError::file("read", path))?;
    parse(&bytes).ok_or_else(|| OutputError::Table {
        path: path.to_path_buf(),
        line: 1,
        problem: "is no table of named columns of f64 in the format 3.0 of NumPy".to_owned(),
    })
}

fn parse(bytes: &[u8]) -> Option<CsvTable> {
    let (length, rest) = bytes.strip_prefix(MAGIC)?.split_first_chunk()?;
    let (head, data) = rest.split_at_checked(u32::from_le_bytes(*length) as usize)?;
    let text = str::from_utf8(head).ok()?;
    let (columns, shape) =
        text.strip_prefix("{'descr': [")?.rsplit_once("], 'fortran_order': False, 'shape': (")?;
    let names: Vec<String> = columns
        .split_terminator("', '<f8'), ")
        .map(|name| Some(name.strip_prefix("('")?.replace("\\'", "'").replace("\\\\", "\\")))
        .collect::<Option<_>>()?;
    let rows: usize = shape.split(',').next()?.trim().parse().ok()?;
    let numbers = data.as_chunks().0.get(..rows.checked_mul(names.len())?)?;
    let column =
        |k: usize| numbers.iter().skip(k).step_by(names.len()).map(|b| f64::from_le_bytes(*b)).collect();
    Some(CsvTable { columns: (0..names.len()).map(column).collect(), names })
}
