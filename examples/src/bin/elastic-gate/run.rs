//! A run with everything that watches it.

use crate::fields::Fields;
use crate::observe::Observer;
use crate::setup::GateScene;
use crate::{FIELD_INTERVAL, FRAME_INTERVAL, PROBE_INTERVAL, SNAPSHOT_INTERVAL, WATCH_EVERY};
use mps_examples::{Due, Failure, Recorded};
use mps_kernel::{Kernel, Real};
use mps_neighbors::Parallel;
use std::fmt;

/// Water and gate, their observer, and what is drawn and when.
pub(crate) struct Run<'a, T: Real, K: Kernel<T>> {
    scene: &'a mut GateScene<T, K>,
    observer: &'a mut Observer<T>,
    fields: Option<Fields<T>>,
    parallel: &'a Parallel,
    probe: Due,
    frame: Due,
    field: Due,
    snapshot: Due,
}

impl<'a, T: Real, K: Kernel<T>> Run<'a, T, K> {
    pub(crate) fn new(
        scene: &'a mut GateScene<T, K>,
        observer: &'a mut Observer<T>,
        fields: Option<Fields<T>>,
        parallel: &'a Parallel,
    ) -> Self {
        let [probe, frame, field, snapshot] =
            [PROBE_INTERVAL, FRAME_INTERVAL, FIELD_INTERVAL, SNAPSHOT_INTERVAL].map(Due::every);
        Self { scene, observer, fields, parallel, probe, frame, field, snapshot }
    }
}

impl<T: Real, K: Kernel<T>> Recorded for Run<'_, T, K> {
    fn time(&self) -> f64 {
        self.scene.fluid().time().to_double()
    }

    fn steps(&self) -> u64 {
        self.scene.fluid().steps()
    }

    fn look(&mut self, dt: f64, last: bool) -> Result<(), Failure> {
        let (time, parallel) = (self.time(), self.parallel);
        if self.probe.is_due(time) || last {
            self.observer.record(self.scene, parallel, dt)?;
        }
        if self.steps().is_multiple_of(WATCH_EVERY) || last {
            self.observer.watch(self.scene, parallel);
        }
        if let Some(fields) = &mut self.fields {
            if self.field.is_due(time) || last {
                fields.write(self.scene, parallel)?;
            }
            let picture = self.snapshot.is_due(time) || last;
            if self.frame.is_due(time) || picture {
                fields.draw(self.scene, picture)?;
            }
        }
        Ok(())
    }

    fn step(&mut self) -> Result<f64, Failure> {
        // Whole steps to the end: a shortened one would show as a jump of the energy, whose value
        // at the ends of a symplectic step depends on the length of the step.
        Ok(self.scene.step(self.parallel, T::of(f64::INFINITY))?.to_double())
    }

    fn keep_wreck(&mut self) -> Result<(), Failure> {
        if let Some(fields) = &mut self.fields {
            fields.write(self.scene, self.parallel)?;
            fields.draw(self.scene, true)?;
        }
        Ok(())
    }

    fn remark(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (fluid, gate) = self.scene.energy(self.parallel);
        let energy = (fluid.total() + gate.total()).to_double();
        write!(f, "{} sub-steps, energy {energy:.4e} J/m", self.scene.substeps())
    }
}
