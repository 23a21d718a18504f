//! Bodies alone.

use super::Elastic;
use crate::Failure;
use mps_coupling::{CouplingError, Structure, StructureEnergy};
use mps_kernel::{Real, Transfer, Vector};
use mps_neighbors::Parallel;

/// Bodies that do not know of each other.
pub struct Dry<T: Real, const D: usize> {
    pub(super) bodies: Vec<Elastic<T, D>>,
    pub(super) no_force: Vec<Vec<Vector<T, D>>>,
    pub(super) gravity: Vector<T, D>,
    /// Sub-steps of each body in an interval, held constant: a symplectic step keeps the energy only as long as it
    /// does not change.
    pub(super) substeps: Vec<usize>,
    pub(super) interval: f64,
    pub(super) intervals: u64,
    /// Sub-steps so far, of the body that takes the most.
    pub(super) steps: u64,
    /// How often the sub-steps are halved at present.
    pub(super) halvings: u32,
}

impl<T: Real, const D: usize> Dry<T, D> {
    pub(super) fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        // Sub-steps are found from the bodies at the start, as in the run that was saved.
        let Self { bodies, no_force: _, gravity: _, substeps: _, interval: _, intervals, steps, halvings: _ } =
            self;
        transfer.same("bodies", bodies.len());
        bodies.iter_mut().for_each(|body| body.transfer(transfer));
        transfer.value("intervals", intervals);
        transfer.value("sub-steps", steps);
    }

    pub(super) fn new(
        bodies: Vec<Elastic<T, D>>,
        gravity: Vector<T, D>,
        interval: f64,
        parallel: &Parallel,
    ) -> Self {
        let substeps = |body: &Elastic<T, D>| {
            (interval / body.solid().max_step(parallel).to_double()).ceil().max(1.0) as usize
        };
        Self {
            no_force: bodies.iter().map(|body| vec![Vector::zeros(); body.solid().len()]).collect(),
            substeps: bodies.iter().map(substeps).collect(),
            bodies,
            gravity,
            interval,
            intervals: 0,
            steps: 0,
            halvings: 0,
        }
    }

    pub(super) fn step(&mut self, parallel: &Parallel) -> Result<f64, Failure> {
        let (dt, time) = (T::of(self.interval), self.intervals as f64 * self.interval);
        let bodies = self.bodies.iter_mut().zip(&self.no_force).zip(&self.substeps);
        for (index, ((body, no_force), substeps)) in bodies.enumerate() {
            body.advance(parallel, no_force, &self.gravity, dt, substeps << self.halvings)
                .map_err(|source| CouplingError::Structure { index, time, source })?;
        }
        self.intervals += 1;
        let most = self.most_substeps() << self.halvings;
        self.steps += most as u64;
        Ok(self.interval / most as f64)
    }

    fn most_substeps(&self) -> usize {
        self.substeps.iter().copied().max().unwrap_or(1)
    }

    pub(super) fn energy(&self, parallel: &Parallel) -> StructureEnergy<T> {
        let mut sum = StructureEnergy::default();
        for body in &self.bodies {
            let energy = body.energy(parallel, &self.gravity);
            sum.kinetic += energy.kinetic;
            sum.strain += energy.strain;
            sum.potential += energy.potential;
        }
        sum
    }
}
