//! The table of a run: probes, energies, steps.

use super::World;
use super::probes::Probe;
use crate::Failure;
use mps_io::CsvWriter;
use mps_io::scene_file::SceneFile;
use mps_kernel::{Kernel, Real};
use mps_neighbors::Parallel;
use std::path::Path;

/// Columns that every scene has, behind those of its probes.
const COLUMNS: [&str; 10] = [
    "energy [J/m]",
    "fluid kinetic [J/m]",
    "fluid potential [J/m]",
    "fluid compression [J/m]",
    "solid kinetic [J/m]",
    "solid strain [J/m]",
    "solid potential [J/m]",
    "work on solids [J/m]",
    "time step [s]",
    "sub-steps [-]",
];

/// The record of a run.
pub(super) struct Observer<T: Real> {
    csv: CsvWriter,
    probes: Vec<Probe<T>>,
    /// Names of the columns, the time first.
    pub(super) names: Vec<String>,
    /// Number of columns of the time and the probes.
    pub(super) measured: usize,
    /// All rows so far.
    pub(super) rows: Vec<Vec<f64>>,
}

impl<T: Real> Observer<T> {
    pub(super) fn new<K: Kernel<T>>(
        dir: &Path,
        scene: &SceneFile,
        world: &World<T, K>,
    ) -> Result<Self, Failure> {
        let probes = Probe::all(scene, world)?;
        let mut names = vec!["time [s]".to_owned()];
        names.extend(probes.iter().flat_map(Probe::columns));
        let measured = names.len();
        names.extend(COLUMNS.map(str::to_owned));
        let headings: Vec<&str> = names.iter().map(String::as_str).collect();
        let csv = CsvWriter::create(dir.join("probes.csv"), &headings)?;
        Ok(Self { csv, probes, names, measured, rows: Vec::new() })
    }

    /// Writes a row of `probes.csv`; `dt` \[s\] is the step that led here.
    pub(super) fn record<K: Kernel<T>>(
        &mut self,
        world: &World<T, K>,
        parallel: &Parallel,
        dt: f64,
    ) -> Result<(), Failure> {
        let mut row = vec![world.time()];
        self.probes.iter().for_each(|probe| probe.measure(world, &mut row));
        let (fluid, solid) = world.energy(parallel);
        let work = world.coupled().map_or(0.0, |scene| scene.budget().work.to_double());
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
        self.csv.row(&row)?;
        self.rows.push(row);
        Ok(())
    }

    /// A column of the record.
    pub(super) fn column(&self, k: usize) -> Vec<f64> {
        self.rows.iter().map(|row| row[k]).collect()
    }
}
