//! Tables of numbers: time series of probes, and reference curves to compare them with.

use std::fmt::Write as _;
use std::fs::{File, OpenOptions};
use std::io::{Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};

use crate::OutputError;
use mps_kernel::Transfer;

/// A comma-separated table that grows by one row at a time.
///
/// Every row goes to the operating system in one call, with no buffer in between: a run that is
/// killed keeps all its rows, and a plot of a running job is up to date. A row costs a few
/// microseconds, far less than a time step.
pub struct CsvWriter {
    path: PathBuf,
    file: File,
    columns: usize,
    rows: u64,
    line: String,
}

impl CsvWriter {
    /// Creates the file with its header; an existing file is replaced. Put the unit into the name of
    /// each column: `"time [s]"`.
    ///
    /// # Errors
    /// The file cannot be created or written.
    pub fn create(path: impl AsRef<Path>, columns: &[&str]) -> Result<Self, OutputError> {
        let path = path.as_ref().to_path_buf();
        let file = File::create(&path).map_err(OutputError::file("create", &path))?;
        let mut writer = Self { path, file, columns: columns.len(), rows: 0, line: header(columns) };
        writer.send()?;
        Ok(writer)
    }

    /// Opens the file of a run that goes on, with all its rows; [`transfer`](Self::transfer) says how many of them are kept.
    ///
    /// # Errors
    /// The file cannot be read or written, or has other columns.
    pub fn resume(path: impl AsRef<Path>, columns: &[&str]) -> Result<Self, OutputError> {
        let path = path.as_ref().to_path_buf();
        let text = std::fs::read_to_string(&path).map_err(OutputError::file("read", &path))?;
        if text.lines().next() != Some(&header(columns)) {
            let problem = "does not have the columns of this run: put the file of the run back".to_owned();
            return Err(OutputError::Table { path, line: 1, problem });
        }
        let open = OpenOptions::new().append(true).open(&path);
        let file = open.map_err(OutputError::file("open", &path))?;
        let rows = text.lines().count() as u64 - 1;
        Ok(Self { path, file, columns: columns.len(), rows, line: String::new() })
    }

    /// Saves how many rows there are, or goes back to that many: those written later are cut off.
    pub fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let mut rows = self.rows;
        transfer.value("rows", &mut rows);
        if transfer.is_restoring()
            && transfer.is_good()
            && let Err(error) = self.cut(rows)
        {
            transfer.refuse(error);
        }
    }

    fn cut(&mut self, rows: u64) -> Result<(), OutputError> {
        let path = &self.path;
        let text = std::fs::read_to_string(path).map_err(OutputError::file("read", path))?;
        let kept = text.split_inclusive('\n').filter(|line| line.ends_with('\n')).take(rows as usize + 1);
        let (lines, bytes) = kept.fold((0, 0), |(lines, bytes), line| (lines + 1, bytes + line.len() as u64));
        if lines != rows + 1 {
            let problem =
                format!("the file ends here, and the checkpoint is of a run with {rows} rows: put it back");
            return Err(OutputError::Table { path: path.clone(), line: lines as usize + 1, problem });
        }
        let cut = self.file.set_len(bytes).and_then(|()| self.file.seek(SeekFrom::Start(bytes)));
        cut.map_err(OutputError::file("cut", path))?;
        self.rows = rows;
        Ok(())
    }

    /// Forces the rows to the disk, where they outlast a loss of power.
    ///
    /// # Errors
    /// The disk refuses.
    pub fn sync(&self) -> Result<(), OutputError> {
        self.file.sync_data().map_err(OutputError::file("write", &self.path))
    }

    /// Appends one row. Numbers are written with as many digits as give back the same bits.
    ///
    /// # Errors
    /// The row has not one value for each column, or the disk refuses.
    pub fn row(&mut self, values: &[f64]) -> Result<(), OutputError> {
        if values.len() != self.columns {
            let (path, row) = (self.path.clone(), self.rows + 1);
            return Err(OutputError::RowLength { path, expected: self.columns, found: values.len(), row });
        }
        self.line.clear();
        for (k, value) in values.iter().enumerate() {
            self.line += if k == 0 { "" } else { "," };
            let size = value.abs();
            // Plain decimals where they are short; `{}` alone would write 1e-300 with 300 zeros.
            let plain = size == 0.0 || (1e-4..1e9).contains(&size) || !size.is_finite();
            // Writing into a String cannot fail.
            let _ = if plain { write!(self.line, "{value}") } else { write!(self.line, "{value:e}") };
        }
        self.send()?;
        self.rows += 1;
        Ok(())
    }

    /// Number of rows written so far, without the header.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    fn send(&mut self) -> Result<(), OutputError> {
        self.line.push('\n');
        self.file.write_all(self.line.as_bytes()).map_err(OutputError::file("write", &self.path))
    }
}

/// A table read from a file: a reference curve, or what [`CsvWriter`] wrote.
///
/// Lines that begin with `#` are comments (say there where the data are from), the first other line
/// holds the names of the columns. An empty cell is NaN.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CsvTable {
    /// Names of the columns.
    pub names: Vec<String>,
    /// Values of each column.
    pub columns: Vec<Vec<f64>>,
}

impl CsvTable {
    /// Reads the file.
    ///
    /// # Errors
    /// The file cannot be read, has no header, or a row is not one number for each column; the
    /// message names the line.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, OutputError> {
        let path = path.as_ref();
        let text = std::fs::read_to_string(path).map_err(OutputError::file("read", path))?;
        Self::parse(&text).map_err(|(line, problem)| OutputError::Table {
            path: path.to_path_buf(),
            line,
            problem,
        })
    }

    /// The values of the column with this name.
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        let at = self.names.iter().position(|n| n == name)?;
        self.columns.get(at).map(Vec::as_slice)
    }

    fn parse(text: &str) -> Result<Self, (usize, String)> {
        let lines = text.lines().enumerate().map(|(k, line)| (k + 1, line.trim()));
        let mut rows = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
        let (_, header) = rows.next().ok_or((1, "no line with the names of the columns".to_owned()))?;
        let names: Vec<String> = cells(header);
        let mut columns = vec![Vec::new(); names.len()];
        for (line, row) in rows {
            let found = row.split(',').count();
            if found != names.len() {
                return Err((line, format!("{found} values, but the header has {} columns", names.len())));
            }
            for (column, cell) in columns.iter_mut().zip(row.split(',')) {
                let cell = cell.trim();
                let value = if cell.is_empty() { Ok(f64::NAN) } else { cell.parse() };
                column.push(
                    value.map_err(|_| (line, format!("'{cell}' is not a number (write 0.5, not 0,5)")))?,
                );
            }
        }
        Ok(Self { names, columns })
    }
}

/// Splits a header; commas within double quotes belong to the name.
fn cells(line: &str) -> Vec<String> {
    let (mut cells, mut cell, mut quoted) = (Vec::new(), String::new(), false);
    let mut letters = line.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '"' if quoted && letters.next_if_eq(&'"').is_some() => cell.push('"'),
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(std::mem::take(&mut cell).trim().to_owned()),
            _ => cell.push(letter),
        }
    }
    cells.push(cell.trim().to_owned());
    cells
}

/// The first line, without its end.
fn header(columns: &[&str]) -> String {
    columns.iter().map(|name| quoted(name)).collect::<Vec<_>>().join(",")
}

/// A column name as RFC 4180 wants it.
fn quoted(name: &str) -> String {
    let name = name.replace(['\n', '\r'], " ");
    if name.contains([',', '"', '#']) {
        format!("\"{}\"", name.replace('"', "\"\""))
    } else {
        name.to_owned()
    }
}
