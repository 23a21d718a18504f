//! A table that grows by a row at a time, as text or binary.

use std::path::{Path, PathBuf};

use crate::npy::NpyWriter;
use crate::{CsvTable, CsvWriter, OutputError, npy};
use mps_kernel::Transfer;

/// Form of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TableForm {
    /// Comma-separated text, `.csv`.
    #[default]
    Csv,
    /// Binary, `.npy`: eight bytes a number, read by NumPy with `numpy.load`, each column by its name.
    Npy,
}

/// Both forms.
const FORMS: [TableForm; 2] = [TableForm::Csv, TableForm::Npy];

impl TableForm {
    fn path(self, dir: &Path, name: &str) -> PathBuf {
        dir.join(match self {
            Self::Csv => format!("{name}.csv"),
            Self::Npy => format!("{name}.npy"),
        })
    }
}

/// Writes a table in one of its [forms](TableForm): complete after every row, with the bits of every number.
pub struct TableWriter {
    form: Form,
    path: PathBuf,
}

enum Form {
    Csv(CsvWriter),
    Npy(NpyWriter),
}

impl TableWriter {
    /// Begins the table `name` in `dir`; what an earlier run has left there in either form is replaced.
    ///
    /// # Errors
    /// The file cannot be created or written.
    pub fn create(dir: &Path, name: &str, form: TableForm, columns: &[&str]) -> Result<Self, OutputError> {
        for other in FORMS.into_iter().filter(|other| *other != form) {
            let left = other.path(dir, name);
            if left.exists() {
                std::fs::remove_file(&left).map_err(OutputError::file("remove", &left))?;
            }
        }
        let path = form.path(dir, name);
        let form = match form {
            TableForm::Csv => Form::Csv(CsvWriter::create(&path, columns)?),
            TableForm::Npy => Form::Npy(NpyWriter::create(&path, columns)?),
        };
        Ok(Self { form, path })
    }

    /// Opens the table of a run that goes on; [`transfer`](Self::transfer) says how many of its rows are kept.
    ///
    /// # Errors
    /// The file cannot be read or written, or has other columns.
    pub fn resume(dir: &Path, name: &str, form: TableForm, columns: &[&str]) -> Result<Self, OutputError> {
        let path = form.path(dir, name);
        let form = match form {
            TableForm::Csv => Form::Csv(CsvWriter::resume(&path, columns)?),
            TableForm::Npy => Form::Npy(NpyWriter::resume(&path, columns)?),
        };
        Ok(Self { form, path })
    }

    /// Saves how many rows there are, or goes back to that many.
    pub fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        match &mut self.form {
            Form::Csv(csv) => csv.transfer(transfer),
            Form::Npy(npy) => {
                let mut rows = npy.rows();
                transfer.value("rows", &mut rows);
                if transfer.is_restoring()
                    && transfer.is_good()
                    && let Err(error) = npy.cut(rows)
                {
                    transfer.refuse(error);
                }
            }
        }
    }

    /// Appends one row.
    ///
    /// # Errors
    /// The row has not one value for each column, or the disk refuses.
    pub fn row(&mut self, values: &[f64]) -> Result<(), OutputError> {
        match &mut self.form {
            Form::Csv(csv) => csv.row(values),
            Form::Npy(npy) => npy.row(values),
        }
    }

    /// Number of rows so far.
    pub fn rows(&self) -> u64 {
        match &self.form {
            Form::Csv(csv) => csv.rows(),
            Form::Npy(npy) => npy.rows(),
        }
    }

    /// Forces the rows to the disk, where they outlast a loss of power.
    ///
    /// # Errors
    /// The disk refuses.
    pub fn sync(&self) -> Result<(), OutputError> {
        match &self.form {
            Form::Csv(csv) => csv.sync(),
            Form::Npy(npy) => npy.sync(),
        }
    }

    /// Reads what is in the file.
    ///
    /// # Errors
    /// As [`find_table`].
    pub fn read(&self) -> Result<CsvTable, OutputError> {
        match self.form {
            Form::Csv(_) => CsvTable::read(&self.path),
            Form::Npy(_) => npy::read(&self.path),
        }
    }
}

/// Reads the table `name` in `dir`, whichever form it has; of two the one written last. Returns where it was, too.
///
/// # Errors
/// There is none that can be read.
pub fn find_table(dir: &Path, name: &str) -> Result<(CsvTable, PathBuf), OutputError> {
    let written = FORMS.into_iter().filter_map(|form| {
        let path = form.path(dir, name);
        Some((path.metadata().ok()?.modified().ok()?, form, path))
    });
    match written.max_by_key(|(time, ..)| *time) {
        Some((_, TableForm::Npy, path)) => Ok((npy::read(&path)?, path)),
        Some((_, TableForm::Csv, path)) => Ok((CsvTable::read(&path)?, path)),
        None => {
            let path = TableForm::Csv.path(dir, name);
            Ok((CsvTable::read(&path)?, path))
        }
    }
}
