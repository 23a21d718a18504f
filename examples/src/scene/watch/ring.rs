//! The last steps of a run.

use super::measure::Measures;
use super::particle::Particle;
use mps_fluid::Limit;
use mps_kernel::Transfer;

/// One step, as numbers that a state can hold.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    /// Steps done after it.
    pub(super) count: u64,
    /// Time after it \[s\].
    pub(super) time: f64,
    /// Its length \[s\].
    pub(super) dt: f64,
    /// What the length followed from; `None` for bodies alone.
    pub(super) limit: Option<Limit>,
    /// Energy of fluid and bodies \[J, in two dimensions J/m\]; no number if it is not watched.
    pub(super) energy: f64,
    /// Kinetic energy of fluid and bodies \[J, in two dimensions J/m\].
    pub(super) kinetic: f64,
    /// The fastest particle and its speed \[m/s\].
    pub(super) fastest: (Particle, f64),
    /// The fluid particle with the largest pressure, and that \[Pa\].
    pub(super) pressure: (u32, f64),
}

/// Numbers of a step.
const NUMBERS: usize = 11;

const LIMITS: [Option<Limit>; 5] =
    [None, Some(Limit::Sound), Some(Limit::Viscosity), Some(Limit::Acceleration), Some(Limit::Diffusion)];

impl Step {
    pub(super) fn new(
        [count, time, dt, energy]: [f64; 4],
        limit: Option<Limit>,
        measures: &Measures,
    ) -> Self {
        let Measures { kinetic, fastest, pressure, .. } = *measures;
        Self { count: count as u64, time, dt, limit, energy, kinetic, fastest, pressure }
    }

    fn numbers(&self) -> [f64; NUMBERS] {
        let limit = LIMITS.iter().position(|limit| *limit == self.limit).unwrap_or(0) as f64;
        let [body, id] = self.fastest.0.code();
        let (number, pressure) = self.pressure;
        let Self { count, time, dt, energy, kinetic, fastest: (_, speed), .. } = *self;
        [count as f64, time, dt, limit, energy, kinetic, body, id, speed, f64::from(number), pressure]
    }

    fn of(numbers: &[f64; NUMBERS]) -> Self {
        let [count, time, dt, limit, energy, kinetic, body, id, speed, number, pressure] = *numbers;
        Self {
            count: count as u64,
            time,
            dt,
            limit: LIMITS.get(limit as usize).copied().flatten(),
            energy,
            kinetic,
            fastest: (Particle::of([body, id]), speed),
            pressure: (number as u32, pressure),
        }
    }
}

/// The last steps, the newest at the end.
#[derive(Clone, Debug)]
pub(super) struct Ring {
    room: usize,
    steps: Vec<Step>,
}

impl Ring {
    /// For this many steps.
    pub(super) fn new(room: usize) -> Self {
        Self { room, steps: Vec::with_capacity(room) }
    }

    pub(super) fn push(&mut self, step: Step) {
        if self.steps.len() >= self.room {
            self.steps.remove(0);
        }
        self.steps.push(step);
    }

    /// The steps, the newest at the end.
    pub(super) fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Mean length of the steps \[s\]; `None` before the first.
    pub(super) fn mean_step(&self) -> Option<f64> {
        let sum: f64 = self.steps.iter().map(|step| step.dt).sum();
        (!self.steps.is_empty()).then(|| sum / self.steps.len() as f64)
    }

    pub(super) fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { room: _, steps } = self;
        let mut numbers: Vec<[f64; NUMBERS]> = steps.iter().map(Step::numbers).collect();
        transfer.list("last steps", &mut numbers);
        steps.clear();
        steps.extend(numbers.iter().map(Step::of));
    }
}
