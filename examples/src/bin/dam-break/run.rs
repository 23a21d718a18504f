//! A run with everything that watches it.

use crate::fields::Fields;
use crate::observe::Observer;
use crate::setup::{DamBreak, TIME};
use crate::{FRAME_INTERVAL, PROBE_INTERVAL, SNAPSHOTS, WATCH_EVERY};
use mps_examples::{Due, Failure, Moments, Recorded};
use mps_kernel::{Kernel, Real};
use mps_neighbors::Parallel;
use std::fmt;

/// The water, its observer, and what is drawn and when.
pub(crate) struct Run<'a, T: Real, K: Kernel<T>> {
    dam: &'a mut DamBreak<T, K>,
    observer: &'a mut Observer,
    fields: Option<Fields>,
    parallel: &'a Parallel,
    probe: Due,
    frame: Due,
    snapshots: Moments,
}

impl<'a, T: Real, K: Kernel<T>> Run<'a, T, K> {
    pub(crate) fn new(
        dam: &'a mut DamBreak<T, K>,
        observer: &'a mut Observer,
        fields: Option<Fields>,
        parallel: &'a Parallel,
    ) -> Self {
        let [probe, frame] = [PROBE_INTERVAL, FRAME_INTERVAL].map(Due::every);
        let snapshots = Moments::at(SNAPSHOTS.map(|t| t * TIME).to_vec());
        Self { dam, observer, fields, parallel, probe, frame, snapshots }
    }
}

impl<T: Real, K: Kernel<T>> Recorded for Run<'_, T, K> {
    fn time(&self) -> f64 {
        self.dam.fluid().time().to_double()
    }

    fn steps(&self) -> u64 {
        self.dam.fluid().steps()
    }

    fn look(&mut self, dt: f64, last: bool) -> Result<(), Failure> {
        let (time, parallel) = (self.time(), self.parallel);
        if self.probe.is_due(time) || last {
            self.observer.record(self.dam, parallel, dt)?;
        }
        if self.steps().is_multiple_of(WATCH_EVERY) || last {
            self.observer.watch(self.dam, parallel);
        }
        if let Some(fields) = &mut self.fields {
            if self.frame.is_due(time) || last {
                fields.write(self.dam, parallel)?;
                fields.frame(self.dam)?;
            }
            if let Some(moment) = self.snapshots.due(time) {
                fields.snapshot(self.dam, moment / TIME)?;
            }
        }
        if last {
            self.observer.finish(self.dam, parallel)?;
        }
        Ok(())
    }

    fn step(&mut self) -> Result<f64, Failure> {
        Ok(self.dam.step(self.parallel)?.to_double())
    }

    fn keep_wreck(&mut self) -> Result<(), Failure> {
        let time = self.time();
        if let Some(fields) = &mut self.fields {
            fields.write(self.dam, self.parallel)?;
            fields.snapshot(self.dam, time / TIME)?;
        }
        Ok(())
    }

    fn remark(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "t √(g/H) = {:.2}", self.time() / TIME)
    }
}
