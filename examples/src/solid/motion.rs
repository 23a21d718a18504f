//! The motion of a body on its own, recorded at even intervals.

use super::Pictures;
use crate::{Cost, Failure, Recorded};
use mps_io::CsvWriter;
use mps_kernel::{Real, Vector};
use mps_neighbors::Parallel;
use mps_solid::{ConstitutiveModel, MaterialPoint, Solid, SolidEnergy};
use std::path::Path;

/// Columns of `probes.csv`.
const COLUMNS: &[&str] = &[
    "time [s]",
    "tip x [m]",
    "tip y [m]",
    "energy [J/m]",
    "kinetic [J/m]",
    "strain [J/m]",
    "bending in the cells [J/m]",
    "potential [J/m]",
];

/// One row of the record.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// \[s\].
    pub time: f64,
    /// Displacement of the tip \[m\].
    pub tip: [f64; 2],
    /// \[J/m\].
    pub energy: SolidEnergy<f64>,
}

/// A body that moves under its own weight or none, and what is kept of it.
///
/// The sub-step is held constant: a symplectic step keeps the energy only as long as it does not change, and the
/// record is even.
pub struct Motion<'a, T: Real, M: ConstitutiveModel<T, 2>> {
    solid: Solid<T, 2, M>,
    tip: MaterialPoint<T, 2>,
    gravity: Vector<T, 2>,
    no_load: Vec<Vector<T, 2>>,
    interval: f64,
    substeps: usize,
    intervals: u64,
    parallel: &'a Parallel,
    samples: Vec<Sample>,
    table: Option<CsvWriter>,
    pictures: Option<Pictures>,
}

impl<'a, T: Real, M: ConstitutiveModel<T, 2>> Motion<'a, T, M> {
    /// Follows the point of `solid` that is at `tip` \[m\] in the undeformed body, with a sample every `interval`
    /// \[s\].
    ///
    /// # Errors
    /// If the point is not of the body.
    pub fn new(
        solid: Solid<T, 2, M>,
        tip: Vector<T, 2>,
        gravity: Vector<T, 2>,
        interval: f64,
        parallel: &'a Parallel,
    ) -> Result<Self, Failure> {
        Ok(Self {
            tip: solid.point(tip)?,
            gravity,
            no_load: vec![Vector::zeros(); solid.len()],
            interval,
            substeps: (interval / solid.max_step(parallel).to_double()).ceil().max(1.0) as usize,
            intervals: 0,
            parallel,
            samples: Vec::new(),
            table: None,
            pictures: None,
            solid,
        })
    }

    /// Writes every sample to `probes.csv` in `dir` as well.
    ///
    /// # Errors
    /// If the file cannot be created.
    pub fn with_table(self, dir: &Path) -> Result<Self, Failure> {
        Ok(Self { table: Some(CsvWriter::create(dir.join("probes.csv"), COLUMNS)?), ..self })
    }

    /// Draws and writes fields.
    pub fn with_pictures(self, pictures: Option<Pictures>) -> Self {
        Self { pictures, ..self }
    }

    /// The body.
    pub fn solid(&self) -> &Solid<T, 2, M> {
        &self.solid
    }

    /// The record so far.
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// What the motion has cost, with the `seconds` that its steps took.
    pub fn cost(&self, seconds: f64) -> Cost {
        Cost {
            threads: self.parallel.threads(),
            steps: self.steps(),
            seconds,
            simulated: self.time(),
            particles: self.solid.len(),
        }
    }

    /// Length of a sub-step \[s\].
    pub fn substep(&self) -> f64 {
        self.interval / self.substeps as f64
    }
}

impl<T: Real, M: ConstitutiveModel<T, 2>> Recorded for Motion<'_, T, M> {
    fn time(&self) -> f64 {
        self.intervals as f64 * self.interval
    }

    fn steps(&self) -> u64 {
        self.intervals * self.substeps as u64
    }

    fn look(&mut self, _: f64, last: bool) -> Result<(), Failure> {
        let time = self.time();
        let tip = (self.tip.value(self.solid.positions()) - self.tip.reference()).map(Real::to_double);
        let energy = self.solid.energy(self.parallel, &self.gravity);
        let energy = SolidEnergy {
            kinetic: energy.kinetic.to_double(),
            strain: energy.strain.to_double(),
            bending: energy.bending.to_double(),
            potential: energy.potential.to_double(),
        };
        self.samples.push(Sample { time, tip: tip.into(), energy });
        if let Some(table) = &mut self.table {
            let SolidEnergy { kinetic, strain, bending, potential } = energy;
            table.row(&[time, tip[0], tip[1], energy.total(), kinetic, strain, bending, potential])?;
        }
        if let Some(pictures) = &mut self.pictures {
            pictures.look(&self.solid, time, last)?;
        }
        Ok(())
    }

    fn step(&mut self) -> Result<f64, Failure> {
        let interval = T::of(self.interval);
        self.solid.advance(self.parallel, &self.no_load, &self.gravity, interval, self.substeps)?;
        self.intervals += 1;
        Ok(self.substep())
    }

    fn keep_wreck(&mut self) -> Result<(), Failure> {
        let time = self.time();
        match &mut self.pictures {
            Some(pictures) => pictures.keep(&self.solid, time, "wreck"),
            None => Ok(()),
        }
    }
}
