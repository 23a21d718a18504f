//! Curves of earlier runs, drawn beside the present one: other spacings, other rubbers.

use mps_examples::Refused;
use mps_io::CsvTable;
use std::path::Path;

/// Free end of an earlier run, read back from its probes.csv.
pub(crate) struct Earlier {
    /// Name of its directory.
    pub(crate) label: String,
    /// \[s\].
    pub(crate) time: Vec<f64>,
    /// Displacement of the outer corner \[mm\].
    pub(crate) x: Vec<f64>,
    /// \[mm\].
    pub(crate) y: Vec<f64>,
}

impl Earlier {
    /// Reads `dir/probes.csv`.
    ///
    /// # Errors
    /// If there is no such file, or it is not one of this program.
    pub(crate) fn read(dir: &Path) -> Result<Self, Refused> {
        let refused = |reason: String| Refused {
            flag: "--beside",
            value: dir.display().to_string(),
            remedy: format!("give the --out directory of an earlier run of this program ({reason})"),
        };
        let table = CsvTable::read(dir.join("probes.csv")).map_err(|e| refused(e.to_string()))?;
        let column = |name: &str, unit: f64| {
            let values = table.column(name).ok_or_else(|| refused(format!("no column {name}")))?;
            Ok(values.iter().map(|value| value * unit).collect())
        };
        Ok(Self {
            label: dir.file_name().unwrap_or(dir.as_os_str()).to_string_lossy().into_owned(),
            time: column("time [s]", 1.0)?,
            x: column("gate corner x [m]", 1e3)?,
            y: column("gate corner y [m]", 1e3)?,
        })
    }
}
