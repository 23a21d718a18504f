//! The table of a run: probes, energies, steps.

use super::probes::Probe;
use super::{World, units};
use crate::Failure;
use mps_io::scene_file::{ProbeForm, SceneFile};
use mps_io::{CsvTable, TableForm, TableWriter};
use mps_kernel::{Kernel, Real, Transfer};
use mps_neighbors::Parallel;
use std::path::Path;

/// Columns that every scene has, behind those of its probes:
/// first energies, which have their unit from the dimension.
const ENERGIES: [&str; 8] = [
    "energy",
    "fluid kinetic",
    "fluid potential",
    "fluid compression",
    "solid kinetic",
    "solid strain",
    "solid potential",
    "work on solids",
];
const STEPS: [&str; 2] = ["time step [s]", "sub-steps [-]"];

/// Name of the table.
pub(super) const TABLE: &str = "probes";

/// Number of columns of the time and the probes, in a table with these names.
pub(super) fn measured(names: &[String]) -> usize {
    names.len().saturating_sub(ENERGIES.len() + STEPS.len())
}

/// The record of a run.
pub(super) struct Observer<T: Real, const D: usize> {
    written: TableWriter,
    probes: Vec<Probe<T, D>>,
    /// Names of the columns, the time first.
    pub(super) names: Vec<String>,
    /// Number of columns of the time and the probes.
    pub(super) measured: usize,
    /// All rows so far.
    pub(super) rows: Vec<Vec<f64>>,
}

impl<T: Real, const D: usize> Observer<T, D> {
    /// Begins the table, or goes on with that of a run that `resumes`.
    pub(super) fn new(
        dir: &Path,
        scene: &SceneFile,
        probes: Vec<Probe<T, D>>,
        resumes: bool,
    ) -> Result<Self, Failure> {
        let mut names = vec!["time [s]".to_owned()];
        names.extend(probes.iter().flat_map(Probe::columns).cloned());
        let measured = names.len();
        names.extend(ENERGIES.map(|name| format!("{name} [{}]", units::energy::<D>())));
        names.extend(STEPS.map(str::to_owned));
        let headings: Vec<&str> = names.iter().map(String::as_str).collect();
        let form = match scene.output.probe_form.unwrap_or_default() {
            ProbeForm::Csv => TableForm::Csv,
            ProbeForm::Npy => TableForm::Npy,
        };
        let open = if resumes { TableWriter::resume } else { TableWriter::create };
        let written = open(dir, TABLE, form, &headings)?;
        Ok(Self { written, probes, names, measured, rows: Vec::new() })
    }

    /// Writes a row of the table; `dt` \[s\] is the step that led here.
    pub(super) fn record<K: Kernel<T>>(
        &mut self,
        world: &World<T, D, K>,
        parallel: &Parallel,
        dt: f64,
    ) -> Result<(), Failure> {
        let mut row = vec![world.time()];
        self.probes.iter_mut().for_each(|probe| probe.measure(world, &mut row));
        let (fluid, solid) = world.energy(parallel);
        let work = world.coupled().map_or(0.0, |scene| scene.budget().work().to_double());
        row.extend([
            fluid.total().to_double() + solid.total().to_double(),
            fluid.kinetic.to_double(),
            fluid.potential.to_double(),
            fluid.compression.to_double(),
            solid.kinetic.to_double(),
            solid.strain.to_double(),
            solid.potential.to_double(),
            work,
            dt,
            world.substeps() as f64,
        ]);
        self.written.row(&row)?;
        self.rows.push(row);
        Ok(())
    }

    /// Saves how many rows there are, or goes back to those there were.
    pub(super) fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { written, probes, names: _, measured: _, rows } = self;
        written.transfer(transfer);
        probes.iter_mut().for_each(|probe| probe.transfer(transfer));
        if transfer.is_restoring() && transfer.is_good() {
            match written.read() {
                // The numbers of the table have the bits of those that were written.
                Ok(table) => {
                    let cell = |column: &Vec<f64>, k: usize| column.get(k).copied().unwrap_or(f64::NAN);
                    let row = |k: usize| table.columns.iter().map(|column| cell(column, k)).collect();
                    *rows = (0..written.rows() as usize).map(row).collect();
                }
                Err(error) => transfer.refuse(error),
            }
        }
    }

    /// Forces the rows to the disk.
    pub(super) fn sync(&self) -> Result<(), Failure> {
        Ok(self.written.sync()?)
    }

    /// The record as a table.
    pub(super) fn table(&self) -> CsvTable {
        CsvTable {
            names: self.names.clone(),
            columns: (0..self.names.len()).map(|k| self.column(k)).collect(),
        }
    }

    /// A column of the record.
    pub(super) fn column(&self, k: usize) -> Vec<f64> {
        self.rows.iter().map(|row| row[k]).collect()
    }
}
