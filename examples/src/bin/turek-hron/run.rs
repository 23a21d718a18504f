//! A run with everything that watches it.

use crate::fields::Fields;
use crate::observe::Observer;
use crate::setup::{Channel, Settings};
use mps_examples::{Due, Failure, Recorded};
use mps_kernel::Real;
use mps_neighbors::Parallel;
use std::fmt;

/// Channel, observer, and what is drawn and when.
pub(crate) struct Run<'a, T: Real> {
    scene: &'a mut Channel<T>,
    observer: &'a mut Observer<T>,
    fields: Option<Fields<T>>,
    parallel: &'a Parallel,
    probe: Due,
    frame: Due,
    field: Due,
}

impl<'a, T: Real> Run<'a, T> {
    pub(crate) fn new(
        scene: &'a mut Channel<T>,
        observer: &'a mut Observer<T>,
        fields: Option<Fields<T>>,
        settings: &Settings,
        parallel: &'a Parallel,
    ) -> Self {
        let every = |share: f64| Due::every(share * settings.passage());
        Self { scene, observer, fields, parallel, probe: every(0.02), frame: every(0.4), field: every(4.0) }
    }
}

impl<T: Real> Recorded for Run<'_, T> {
    fn time(&self) -> f64 {
        self.scene.fluid().time().to_double()
    }

    fn steps(&self) -> u64 {
        self.scene.fluid().steps()
    }

    fn look(&mut self, dt: f64, last: bool) -> Result<(), Failure> {
        let time = self.time();
        if self.probe.is_due(time) || last {
            self.observer.record(self.scene, self.parallel, dt)?;
        }
        if let Some(fields) = &mut self.fields {
            let write = self.field.is_due(time) || last;
            if write {
                fields.write(self.scene, self.parallel)?;
            }
            if self.frame.is_due(time) || write {
                fields.draw(self.scene, self.parallel, write)?;
            }
        }
        Ok(())
    }

    fn step(&mut self) -> Result<f64, Failure> {
        Ok(self.scene.step(self.parallel, T::of(f64::INFINITY))?.to_double())
    }

    fn keep_wreck(&mut self) -> Result<(), Failure> {
        if let Some(fields) = &mut self.fields {
            fields.write(self.scene, self.parallel)?;
            fields.draw(self.scene, self.parallel, true)?;
        }
        Ok(())
    }

    fn remark(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} sub-steps, drag {:.1} N/m", self.scene.substeps(), self.observer.drag())
    }
}
