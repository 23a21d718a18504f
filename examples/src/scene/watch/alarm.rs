//! What is wrong with a state although the step had no error.

use super::super::units;
use super::measure::Measures;
use super::particle::Particle;
use super::ring::{Ring, Step};
use mps_io::scene_file::{OnMach, Watch};
use thiserror::Error;

/// Why a run is stopped that could go on.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub(super) enum Alarm {
    /// A value is no number.
    #[error(
        "{particle} has a position, velocity, density or pressure that is no finite number after step {step}, at t = {time:e} s: \
         reduce cfl, raise the sound speed above ten times the largest velocity, or switch collisions on"
    )]
    NotFinite { particle: Particle, step: u64, time: f64 },
    /// A step has collapsed.
    #[error(
        "step {step}, to t = {time:e} s, was {dt:e} s short, which is {share:e} of the mean of the last ones; the fastest is {particle}: something \
         has hit it or was started inside it (`watch.collapse` of the scene says how short a step may be)"
    )]
    Collapsed { particle: Particle, step: u64, time: f64, dt: f64, share: f64 },
    /// Energy without a cause.
    #[error(
        "the energy rose by {rise:e} {unit} in step {step}, to t = {time:e} s, where `watch.energy_rise` of the scene allows {allowed:e}; the fastest is \
         {particle}: reduce cfl, or allow what walls and inlets bring"
    )]
    Energy { particle: Particle, step: u64, time: f64, rise: f64, allowed: f64, unit: &'static str },
    /// The fluid is too fast for its speed of sound.
    #[error(
        "{particle} is {mach:.3} times as fast as sound after step {step}, at t = {time:e} s, where `watch.mach` of the scene allows {allowed}: raise the \
         sound speed to ten times the largest velocity, or allow more"
    )]
    TooFast { particle: Particle, step: u64, time: f64, mach: f64, allowed: f64 },
    /// A particle has left the region.
    #[error(
        "{particle} has left the region of `watch.region` in step {step}, to t = {time:e} s: look for a gap or a wall that is too thin, or make the \
         region larger"
    )]
    Escaped { particle: Particle, step: u64, time: f64 },
}

impl Alarm {
    /// Whom it is about.
    pub(super) fn particle(&self) -> Particle {
        match self {
            Self::NotFinite { particle, .. }
            | Self::Collapsed { particle, .. }
            | Self::Energy { particle, .. }
            | Self::TooFast { particle, .. }
            | Self::Escaped { particle, .. } => *particle,
        }
    }

    /// What is wrong in `D` dimensions after `now`, which follows the steps of the ring.
    pub(super) fn after<const D: usize>(
        now: &Step,
        measures: &Measures,
        ring: &Ring,
        watch: &Watch,
    ) -> Option<Self> {
        let (step, time, dt, (fastest, _)) = (now.count, now.time, now.dt, now.fastest);
        if let Some(particle) = measures.broken {
            return Some(Self::NotFinite { particle, step, time });
        }
        let share = ring.mean_step().map_or(1.0, |mean| dt / mean);
        if share < watch.collapse {
            return Some(Self::Collapsed { particle: fastest, step, time, dt, share });
        }
        if let (Some(allowed), Some(before)) = (watch.energy_rise, ring.steps().last()) {
            let rise = now.energy - before.energy;
            if rise > allowed {
                let unit = units::energy::<D>();
                return Some(Self::Energy { particle: fastest, step, time, rise, allowed, unit });
            }
        }
        if watch.on_mach == OnMach::Stop
            && let Some(alarm) = Self::of_speed(now, measures, watch)
        {
            return Some(alarm);
        }
        measures.outside.map(|particle| Self::Escaped { particle, step, time })
    }

    /// Whether the fluid is too fast, alarming or not.
    pub(super) fn of_speed(now: &Step, measures: &Measures, watch: &Watch) -> Option<Self> {
        let ((particle, mach), allowed) = (measures.mach, watch.mach);
        let too_fast = Self::TooFast { particle, step: now.count, time: now.time, mach, allowed };
        (mach > allowed).then_some(too_fast)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CALM: Measures = Measures {
        kinetic: 1.0,
        fastest: (Particle::Fluid(7), 2.0),
        pressure: (8, 3.0),
        mach: (Particle::Fluid(7), 0.2),
        broken: None,
        outside: None,
    };

    fn step(count: f64, dt: f64, energy: f64) -> Step {
        Step::new([count, 0.1 * count, dt, energy], None, &CALM)
    }

    /// What is said of a step after three of one second, with an energy of 5 J/m.
    fn after(dt: f64, energy: f64, measures: &Measures, watch: &Watch) -> Option<Alarm> {
        let mut ring = Ring::new(3);
        (1..4).for_each(|k| ring.push(step(f64::from(k), 1.0, 5.0)));
        Alarm::after::<2>(&step(4.0, dt, energy), measures, &ring, watch)
    }

    #[test]
    fn every_alarm_has_its_border() {
        let watch = Watch { energy_rise: Some(0.5), ..Watch::default() };
        assert_eq!(after(0.011, 5.4, &CALM, &watch), None);
        let (particle, step, time) = (Particle::Fluid(7), 4, 0.4);
        let collapsed = Alarm::Collapsed { particle, step, time, dt: 0.009, share: 0.009 };
        assert_eq!(after(0.009, 5.0, &CALM, &watch), Some(collapsed));
        assert_eq!(after(0.009, 5.0, &CALM, &Watch { collapse: 0.0, ..watch.clone() }), None);
        let rise = after(1.0, 5.75, &CALM, &watch);
        assert_eq!(rise, Some(Alarm::Energy { particle, step, time, rise: 0.75, allowed: 0.5, unit: "J/m" }));
        assert_eq!(after(1.0, 5.75, &CALM, &Watch::default()), None);
        let particle = Particle::Solid { body: 1, id: 3 };
        let outside = Measures { outside: Some(particle), ..CALM };
        assert_eq!(after(1.0, 5.0, &outside, &watch), Some(Alarm::Escaped { particle, step, time }));
        let fast = Measures { mach: (Particle::Fluid(7), 0.4), ..CALM };
        assert_eq!(after(1.0, 5.0, &fast, &watch), None);
        let stop = Watch { on_mach: OnMach::Stop, ..watch.clone() };
        let too_fast = Alarm::TooFast { particle: Particle::Fluid(7), step, time, mach: 0.4, allowed: 0.3 };
        assert_eq!(after(1.0, 5.0, &fast, &stop), Some(too_fast));
        assert_eq!(after(1.0, 5.0, &CALM, &stop), None);
        // The first reason is the one to tell.
        let broken = Measures { broken: Some(Particle::Fluid(2)), ..outside };
        let (particle, all) = (Particle::Fluid(2), after(0.001, 9.0, &broken, &watch));
        assert_eq!(all, Some(Alarm::NotFinite { particle, step, time }));
    }
}
