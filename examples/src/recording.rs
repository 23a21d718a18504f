//! The time loop that every program has.

use crate::milestones::Milestones;
use crate::{Failure, Watch};
use std::fmt;
use std::time::Instant;

/// A simulation with everything that watches it.
pub trait Recorded {
    /// Simulated time \[s\].
    fn time(&self) -> f64;

    /// Steps so far.
    fn steps(&self) -> u64;

    /// Length of the step that led to the present state \[s\], of a run that goes on; zero at a start.
    fn last_step(&self) -> f64 {
        0.0
    }

    /// Keeps the present state if that is due, before it is looked at. `dt` \[s\] is the step that led here, `stepping` \[s\] what all steps have
    /// taken; `last` at the end of the run. Nothing by default.
    ///
    /// # Errors
    /// If it cannot be written, or the run is to stop here.
    fn keep(&mut self, _dt: f64, _stepping: f64, _last: bool) -> Result<(), Failure> {
        Ok(())
    }

    /// Looks at the present state and writes what is due. `dt` \[s\] is the step that led here; `last` at the end of
    /// the run.
    ///
    /// # Errors
    /// If something cannot be measured or written.
    fn look(&mut self, dt: f64, last: bool) -> Result<(), Failure>;

    /// One step; returns its length \[s\].
    ///
    /// # Errors
    /// If the simulation breaks off.
    fn step(&mut self) -> Result<f64, Failure>;

    /// Keeps the state after a step that failed, for whoever looks for the reason.
    ///
    /// # Errors
    /// If it cannot be written.
    fn keep_wreck(&mut self) -> Result<(), Failure>;

    /// What is shown beside the time left; nothing by default.
    ///
    /// # Errors
    /// Those of the formatter.
    fn remark(&self, _: &mut fmt::Formatter) -> fmt::Result {
        Ok(())
    }
}

/// Formats the remark only when it is shown.
struct Remark<'a, R>(&'a R);

impl<R: Recorded> fmt::Display for Remark<'_, R> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.0.remark(f)
    }
}

/// Steps until `end` \[s\], in whole steps, shows and logs how far it is, and ends before if it is asked to. `stepping` grows by the
/// seconds that the steps alone have taken.
///
/// # Errors
/// The first error of the run.
pub fn record(run: &mut impl Recorded, end: f64, watch: &Watch, stepping: &mut f64) -> Result<(), Failure> {
    let mut milestones = Milestones::begin(run.time(), end);
    let done = steps(run, end, watch, stepping, &mut milestones);
    milestones.end(run.time(), run.steps(), *stepping, done.as_ref().err());
    done
}

fn steps(
    run: &mut impl Recorded,
    end: f64,
    watch: &Watch,
    stepping: &mut f64,
    milestones: &mut Milestones,
) -> Result<(), Failure> {
    let mut progress = watch.progress(end);
    let mut dt = run.last_step();
    loop {
        let time = run.time();
        // Rounding of the time adds no step.
        let last = time >= end * (1.0 - 1e-12);
        run.keep(dt, *stepping, last)?;
        let stopped = if last { None } else { watch.stopped(time) };
        let clock = Instant::now();
        run.look(dt, last || stopped.is_some())?;
        milestones.looked(clock.elapsed());
        if last || stopped.is_some() {
            progress.finish(time, run.steps());
            return stopped.map_or(Ok(()), Err);
        }
        let clock = Instant::now();
        let step = run.step();
        *stepping += clock.elapsed().as_secs_f64();
        match step {
            Ok(taken) => dt = taken,
            Err(failure) => {
                run.keep_wreck()?;
                return Err(failure);
            }
        }
        // The time before the step, as the step is shown when it is known.
        progress.update(time, run.steps(), dt, Remark(run));
        milestones.pass(time, run.steps(), dt, Remark(run));
    }
}
