//! From the record of a run to numbers that can be held against the experiment.
//!
//! A number whose part of the run has not been reached is `None`.

use crate::observe::Sample;
use crate::reference::{Band, FRONT, SensorRecord};
use crate::setup::{HEIGHT, LENGTH};

/// `p/(rho g H)` at which the water counts as arrived at a sensor.
const ARRIVED: f64 = 0.1;
/// Part of the run in which pressures are compared with the band: from the impact to the returning
/// wave, over `sqrt(H/g)`.
pub(crate) const COMPARED: [f64; 2] = [2.4, 6.0];
/// Between the first impact and that of the returning wave.
const CALM: [f64; 2] = [3.0, 5.5];
/// What changes faster than this is noise, over `sqrt(H/g)`.
const NOISE_WINDOW: f64 = 0.1;
/// How long the first impact lasts, over `sqrt(H/g)`: the median of the experiments stays above 2 for a tenth.
const IMPACT: f64 = 0.1;
/// End of the first peak.
const FIRST_PEAK_ENDS: f64 = 3.0;

/// When the pressure on a sensor first passes [`ARRIVED`], over `sqrt(H/g)`.
pub(crate) fn arrival(samples: &[Sample], sensor: usize) -> Option<f64> {
    let after = samples.iter().position(|s| s.pressure[sensor] > ARRIVED)?;
    let (a, b) = (samples.get(after.checked_sub(1)?)?, &samples[after]);
    let share = (ARRIVED - a.pressure[sensor]) / (b.pressure[sensor] - a.pressure[sensor]);
    Some(a.time + share * (b.time - a.time))
}

/// Largest pressure before the first peak is over, over `rho g H`.
pub(crate) fn first_peak(samples: &[Sample], sensor: usize) -> Option<f64> {
    reached(samples, FIRST_PEAK_ENDS)?;
    let before = samples.iter().take_while(|s| s.time < FIRST_PEAK_ENDS);
    Some(before.map(|s| s.pressure[sensor]).fold(0.0, f64::max))
}

/// Mean pressure over [`IMPACT`] from the arrival on, over `rho g H`. Unlike the largest value it does not hang on the particle that comes first.
pub(crate) fn impact_mean(samples: &[Sample], sensor: usize) -> Option<f64> {
    let from = arrival(samples, sensor)?;
    reached(samples, from + IMPACT)?;
    Some(mean(between(samples, [from, from + IMPACT]), |s| s.pressure[sensor]))
}

/// The same of the median of the experiments.
pub(crate) fn measured_impact(record: &SensorRecord) -> Option<f64> {
    const TIMES: u32 = 100;
    let time = |k: u32| record.arrival + IMPACT * (f64::from(k) + 0.5) / f64::from(TIMES);
    let medians = (0..TIMES).map(|k| Some(Band::at(record.points, time(k))?[0]));
    Some(medians.sum::<Option<f64>>()? / f64::from(TIMES))
}

/// Share of the time in [`COMPARED`] in which the pressure lies inside the band of the experiments.
pub(crate) fn band_fraction(samples: &[Sample], sensor: usize, band: &[Band]) -> Option<f64> {
    reached(samples, COMPARED[1])?;
    let inside = |s: &Sample| {
        let [_, low, high] = Band::at(band, s.time)?;
        Some((low..=high).contains(&s.pressure[sensor]))
    };
    let compared: Vec<bool> = between(samples, COMPARED).iter().filter_map(inside).collect();
    Some(compared.iter().filter(|inside| **inside).count() as f64 / compared.len() as f64)
}

/// Mean pressure on the large sensor between 3.5 and 4.5, over `rho g H`.
pub(crate) fn large_sensor_mean(samples: &[Sample]) -> Option<f64> {
    const SPAN: [f64; 2] = [3.5, 4.5];
    reached(samples, SPAN[1])?;
    Some(mean(between(samples, SPAN), |s| s.large))
}

/// Root mean square of what is faster than [`NOISE_WINDOW`] in the pressure between the impacts, over
/// `rho g H`: the signal less its moving mean. The noisiest sensor counts.
pub(crate) fn pressure_noise(samples: &[Sample]) -> Option<f64> {
    reached(samples, CALM[1] + NOISE_WINDOW)?;
    (0..4)
        .map(|sensor| {
            let calm = between(samples, CALM);
            let squares = calm.iter().map(|s| {
                let around = between(samples, [s.time - 0.5 * NOISE_WINDOW, s.time + 0.5 * NOISE_WINDOW]);
                (s.pressure[sensor] - mean(around, |a| a.pressure[sensor])).powi(2)
            });
            (squares.sum::<f64>() / calm.len() as f64).sqrt()
        })
        .reduce(f64::max)
}

/// How far the front is from that of the experiment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FrontError {
    /// Root mean square of the difference, over the length of the column, with the run shifted by `shift`.
    pub(crate) rms: f64,
    /// The same without a shift.
    pub(crate) rms_unshifted: f64,
    /// By how much the run is started later, over `sqrt(H/g)`: at most the opening time of the gate.
    pub(crate) shift: f64,
    /// Mean of the absolute difference over the length of the column: the relative error of paper 1.
    pub(crate) mean: f64,
    /// How much later the experiment is on average, over `sqrt(H/g)`.
    pub(crate) lead: f64,
}

/// Compares the front with the experiment at all its points, up to the wall.
///
/// Times are as published, from the moment the gate starts to move. A run whose gate is gone at once may start
/// any time until the gate of the experiment is open, `opening` later: the one that fits best counts. The
/// other figures are not shifted.
pub(crate) fn front_error(samples: &[Sample], opening: f64) -> Option<FrontError> {
    reached(samples, FRONT.last()?.0)?;
    let (mut sum, mut lead) = (0.0, 0.0);
    for &(time, measured) in FRONT {
        sum += (interpolate(samples, time, |s| s.time, |s| s.front)? - measured).abs();
        lead += time - interpolate(samples, measured, |s| s.front, |s| s.time)?;
    }
    let count = FRONT.len() as f64;
    let column = LENGTH / HEIGHT;
    let rms = |shift: f64| {
        let squares = FRONT.iter().map(|&(time, measured)| {
            let there = interpolate(samples, (time - shift).max(0.0), |s| s.time, |s| s.front)?;
            Some((there - measured).powi(2))
        });
        Some((squares.sum::<Option<f64>>()? / count).sqrt() / column)
    };
    const SHIFTS: u32 = 100;
    let mut best = (rms(0.0)?, 0.0);
    for k in 1..=SHIFTS {
        let shift = opening * f64::from(k) / f64::from(SHIFTS);
        let found = rms(shift)?;
        if found < best.0 {
            best = (found, shift);
        }
    }
    Some(FrontError {
        rms: best.0,
        rms_unshifted: rms(0.0)?,
        shift: best.1,
        mean: sum / count / column,
        lead: lead / count,
    })
}

/// `Some` if the run has come as far as `time`.
fn reached(samples: &[Sample], time: f64) -> Option<()> {
    samples.last().filter(|s| s.time >= time).map(|_| ())
}

/// The samples of a stretch of time.
fn between(samples: &[Sample], [from, to]: [f64; 2]) -> &[Sample] {
    let first = samples.partition_point(|s| s.time < from);
    let last = samples.partition_point(|s| s.time <= to);
    &samples[first..last]
}

/// Mean over the samples.
fn mean(samples: &[Sample], value: impl Fn(&Sample) -> f64) -> f64 {
    samples.iter().map(value).sum::<f64>() / samples.len() as f64
}

/// `y` where `x` first comes to `at`.
fn interpolate(
    samples: &[Sample],
    at: f64,
    x: impl Fn(&Sample) -> f64,
    y: impl Fn(&Sample) -> f64,
) -> Option<f64> {
    let after = samples.iter().position(|s| x(s) >= at)?;
    let (a, b) = (&samples[after.saturating_sub(1)], &samples[after]);
    let share = if x(b) > x(a) { (at - x(a)) / (x(b) - x(a)) } else { 1.0 };
    Some(y(a) + share * (y(b) - y(a)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::SENSORS;

    fn record(pressure: impl Fn(f64) -> f64, front: impl Fn(f64) -> f64) -> Vec<Sample> {
        (0..3500)
            .map(|k| 0.002 * f64::from(k))
            .map(|time| Sample {
                time,
                front: front(time),
                pressure: [pressure(time); 4],
                large: 0.0,
                energy: [0.0; 3],
                received: [0.0; 5],
            })
            .collect()
    }

    fn measured_front(time: f64) -> f64 {
        let after = FRONT.partition_point(|p| p.0 < time).clamp(1, FRONT.len() - 1);
        let (a, b) = (FRONT[after - 1], FRONT[after]);
        a.1 + (b.1 - a.1) * (time - a.0) / (b.0 - a.0)
    }

    #[test]
    fn the_experiment_agrees_with_itself() {
        for (sensor, reference) in SENSORS.iter().enumerate() {
            let median = |t| Band::at(reference.points, t).map_or(0.0, |[median, ..]| median);
            let run = record(median, measured_front);
            assert_eq!(band_fraction(&run, sensor, reference.points), Some(1.0));
            let arrived = arrival(&run, sensor).unwrap();
            assert!((arrived - reference.arrival).abs() < 0.01, "{sensor}: {arrived}");
            let error = front_error(&run, 0.5).unwrap();
            assert!(error.rms_unshifted < 1e-3 && error.shift < 1e-2, "{error:?}");
            assert!(error.rms < 1e-3 && error.mean < 1e-3 && error.lead.abs() < 1e-2, "{error:?}");
        }
    }

    /// Of the lowest sensor, where the pressure is there at once.
    #[test]
    fn the_first_impact_of_the_experiment_is_that_of_its_median() {
        let run = record(|t| Band::at(SENSORS[0].points, t).map_or(0.0, |[median, ..]| median), |_| 0.0);
        let (impact, measured) = (impact_mean(&run, 0).unwrap(), measured_impact(&SENSORS[0]).unwrap());
        assert!((impact / measured - 1.0).abs() < 0.05, "{impact}, {measured}");
        // The median stays above 2 that long.
        assert!((2.2..2.3).contains(&measured), "{measured}");
    }

    #[test]
    fn a_front_that_is_early_by_a_tenth_leads_by_a_tenth() {
        let run = record(|_| 0.0, |t| measured_front(t + 0.1));
        let error = front_error(&run, 0.5).unwrap();
        assert!((error.lead - 0.1).abs() < 0.02 && (error.shift - 0.1).abs() < 0.02, "{error:?}");
        assert!(error.rms_unshifted >= error.mean && (0.05..0.1).contains(&error.mean), "{error:?}");
        assert!(error.rms < 5e-3, "{error:?}");
        // No further than the gate takes to open.
        let error = front_error(&run, 0.04).unwrap();
        assert!(error.shift <= 0.04 && error.rms > 0.03, "{error:?}");
    }

    #[test]
    fn noise_is_what_is_fast() {
        let slow = record(|t| 0.7 + 0.2 * t.sin(), |_| 0.0);
        assert!(pressure_noise(&slow).unwrap() < 2e-4);
        let fast = record(|t| 0.7 + 0.05 * (300.0 * t).sin(), |_| 0.0);
        let rms = pressure_noise(&fast).unwrap();
        assert!((rms - 0.05 / 2.0_f64.sqrt()).abs() < 2e-3, "{rms}");
    }

    #[test]
    fn what_has_not_been_reached_is_not_claimed() {
        let run = record(|_| 0.0, |_| 0.0);
        let short = &run[..500];
        assert!(arrival(short, 0).is_none() && first_peak(short, 0).is_none());
        assert!(impact_mean(short, 0).is_none());
        assert!(band_fraction(short, 0, SENSORS[0].points).is_none());
        assert!(large_sensor_mean(short).is_none());
        assert!(front_error(short, 0.5).is_none() && pressure_noise(short).is_none());
    }
}
