//! Watches a run, remembers its last steps and its last good states.

use super::super::World;
use super::alarm::Alarm;
use super::measure::Measures;
use super::pace::{Pace, Setback};
use super::post_mortem::failed;
use super::remarks::Remarks;
use super::ring::{Ring, Step};
use crate::Failure;
use mps_io::scene_file::Watch;
use mps_kernel::{Kernel, Real, State, Transfer};
use mps_neighbors::Parallel;

/// A state to go back to.
pub(in crate::scene) struct Good {
    /// Of what is stepped, and of the guard.
    pub(in crate::scene) course: State,
    /// Of what has been written.
    pub(in crate::scene) output: State,
    /// Steps done.
    pub(in crate::scene) steps: u64,
}

/// What watches a run.
pub(in crate::scene) struct Guard {
    watch: Watch,
    ring: Ring,
    pace: Pace,
    remarks: Remarks,
    /// The last two good states, the older one first: going back to it leaves as many steps as are remembered, at least.
    good: [Option<Good>; 2],
}

impl Guard {
    pub(in crate::scene) fn new(watch: &Watch) -> Self {
        let ring = Ring::new(watch.steps as usize);
        let (pace, remarks) = (Pace::default(), Remarks::default());
        Self { watch: watch.clone(), ring, pace, remarks, good: [None, None] }
    }

    /// The last steps.
    pub(super) fn ring(&self) -> &Ring {
        &self.ring
    }

    /// Remarks for the summary.
    pub(in crate::scene) fn notes(&self) -> impl Iterator<Item = String> {
        self.remarks.lines.lines().map(str::to_owned)
    }

    /// Takes note of a step that has led to the present state.
    ///
    /// # Errors
    /// If something is wrong with the state.
    pub(in crate::scene) fn look<T: Real, const D: usize, K: Kernel<T>>(
        &mut self,
        world: &World<T, D, K>,
        parallel: &Parallel,
        dt: f64,
    ) -> Result<(), Failure> {
        let measures = Measures::of(world, self.watch.region.as_ref(), parallel);
        let energy = match self.watch.energy_rise {
            Some(_) => {
                let (fluid, solid) = world.energy(parallel);
                (fluid.total() + solid.total()).to_double()
            }
            None => f64::NAN,
        };
        let step = Step::new([world.count() as f64, world.time(), dt, energy], world.limit(), &measures);
        // Steps that are shorter on purpose have not collapsed.
        let collapse = self.watch.collapse * 0.5_f64.powi(self.pace.halvings as i32);
        let alarm =
            Alarm::after::<D>(&step, &measures, &self.ring, &Watch { collapse, ..self.watch.clone() });
        if alarm.is_none()
            && !self.remarks.too_fast
            && let Some(warning) = Alarm::of_speed(&step, &measures, &self.watch)
        {
            self.remarks.warn(&warning);
        }
        self.ring.push(step);
        alarm.map_or(Ok(()), |alarm| Err(alarm.into()))
    }

    /// Whether the state after this many steps is to be kept. While steps are shorter, the state from before the failure stays.
    pub(in crate::scene) fn wants_state(&self, steps: u64) -> bool {
        match &self.good {
            [_, None] => true,
            [_, Some(newer)] => !self.pace.is_slow() && steps >= newer.steps + u64::from(self.watch.steps),
        }
    }

    pub(in crate::scene) fn keep(&mut self, good: Good) {
        let newer = self.good[1].replace(good);
        self.good[0] = newer.or(self.good[0].take());
    }

    /// Takes out the state to go back to.
    pub(in crate::scene) fn take_good(&mut self) -> Option<Good> {
        let [older, newer] = &mut self.good;
        older.take().or_else(|| newer.take())
    }

    /// What the pace has to be after a failure that has left the world as it is now, if it goes back to the good state after `from` steps;
    /// `None` if the run is to stop.
    pub(in crate::scene) fn setback<T: Real, const D: usize, K: Kernel<T>>(
        &self,
        failure: &Failure,
        world: &World<T, D, K>,
        from: u64,
    ) -> Option<Setbacks> {
        let (failed, substeps) = (failed(failure, world), world.substeps() as u64);
        let steps_for_one = if world.fluid().is_some() { 2 } else { 1 };
        let setback = Setback { failed, from, substeps, steps_for_one };
        let pace = self.pace.after(setback, self.watch.on_failure)?;
        Some(Setbacks { pace, remarks: self.remarks.clone() })
    }

    /// Begins again at a state that has been brought back.
    pub(in crate::scene) fn begin_again<T: Real, const D: usize, K: Kernel<T>>(
        &mut self,
        world: &mut World<T, D, K>,
        good: Good,
        Setbacks { pace, remarks }: Setbacks,
        failure: &Failure,
    ) -> Result<(), Failure> {
        self.pace = pace;
        let time = world.time();
        let what = failure.to_string().replace('\n', " ");
        tracing::warn!(time, tries = pace.tries, halvings = pace.halvings, "goes back after: {what}");
        self.remarks = remarks;
        self.remarks.lines += &format!(
            "retry {}: went back to t = {time:e} s, with {} of the {} until step {}, after: {what}\n",
            pace.tries,
            0.5_f64.powi(pace.halvings as i32),
            if world.fluid().is_some() { "Courant number" } else { "sub-step" },
            pace.until
        );
        self.good = [None, Some(good)];
        self.apply_pace(world)
    }

    /// Lets the world go at the pace of the guard.
    pub(in crate::scene) fn apply_pace<T: Real, const D: usize, K: Kernel<T>>(
        &self,
        world: &mut World<T, D, K>,
    ) -> Result<(), Failure> {
        world.slow_down(self.pace.halvings, self.pace.substeps as usize)
    }

    /// Ends shorter steps when it is time.
    pub(in crate::scene) fn recover<T: Real, const D: usize, K: Kernel<T>>(
        &mut self,
        world: &mut World<T, D, K>,
    ) -> Result<(), Failure> {
        if !self.pace.is_slow() || world.count() < self.pace.until {
            return Ok(());
        }
        self.pace = self.pace.recovered();
        // What lies before the failure has been passed.
        self.good = [None, None];
        self.apply_pace(world)
    }

    /// Pace, last steps and remarks, as they are kept while a failure is gone through again.
    pub(in crate::scene) fn memory(&self) -> Memory {
        Memory { pace: self.pace, ring: self.ring.clone(), remarks: self.remarks.clone() }
    }

    /// Brings them back.
    pub(in crate::scene) fn remember(&mut self, memory: Memory) {
        let Memory { pace, ring, remarks } = memory;
        (self.pace, self.ring, self.remarks) = (pace, ring, remarks);
    }

    pub(in crate::scene) fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { watch: _, ring, pace, remarks, good: _ } = self;
        ring.transfer(transfer);
        pace.transfer(transfer);
        remarks.transfer(transfer);
    }
}

/// Pace and remarks of a run that goes back, which must outlast the state that is brought back.
pub(in crate::scene) struct Setbacks {
    pace: Pace,
    remarks: Remarks,
}

/// Pace, last steps and remarks at a failure, which must outlast the state that is brought back to examine it.
pub(in crate::scene) struct Memory {
    pace: Pace,
    ring: Ring,
    remarks: Remarks,
}
