//! Series as sums of harmonics.

mod fit;
mod spectrum;

use fit::{alternating, fitted};
use spectrum::powers;

/// What is left of a noisy series but one harmonic: `mean + amplitude cos(2 pi frequency t + phase) + rest`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    /// Mean of the series without the harmonic.
    pub mean: f64,
    /// Half the height of the harmonic.
    pub amplitude: f64,
    /// Its frequency \[Hz\].
    pub frequency: f64,
    /// Its phase at time zero.
    pub phase: f64,
    /// Root mean square of what it does not explain.
    pub rest: f64,
}

impl Harmonic {
    /// The harmonic without its mean, at time `t` \[s\].
    pub fn swing(&self, t: f64) -> f64 {
        self.amplitude * (core::f64::consts::TAU * self.frequency * t + self.phase).cos()
    }
}

/// The harmonic that explains most of a series in the sense of least squares, with a frequency within a third of `expected`
/// \[Hz\]. Unlike extremes it does not grow with the noise. `None` if the series is shorter than two periods, or explained best at an end of
/// these frequencies: then its own is elsewhere.
pub fn harmonic(time: &[f64], value: &[f64], expected: f64) -> Option<Harmonic> {
    let span = time.last()? - time.first()?;
    if !(expected > 0.0 && span * expected >= 2.0) {
        return None;
    }
    // Half a period more or less in the whole series is another series: half of that cannot be missed.
    let width = expected / 3.0;
    let steps = (width / (expected / 750.0).min(0.25 / span)).ceil() as i32;
    let step = width / f64::from(steps);
    let fit = |frequency: f64| fitted(time, value, frequency);
    let fits = (-steps..=steps).filter_map(|k| Some((k, fit(expected + f64::from(k) * step)?)));
    let (k, best) = fits.min_by(|a, b| a.1.rest.total_cmp(&b.1.rest))?;
    (k.abs() < steps).then(|| refined(best, best.frequency - step, best.frequency + step, fit))
}

/// The `count` harmonics that explain most of a series, one after the other: each is the strongest of what those before it leave. Frequencies lie between
/// one period in the series and half of the rate of its samples, and are told apart from half a period in the series on. At half of the rate itself
/// there is a cosine only: the sine is zero at every sample. Fewer if nothing is left.
pub fn strongest(time: &[f64], value: &[f64], count: usize) -> Vec<Harmonic> {
    let mut rest = value.to_vec();
    let mut found = Vec::new();
    while found.len() < count {
        let Some(next) = strongest_of(time, &rest) else { break };
        for (t, v) in time.iter().zip(&mut rest) {
            *v -= next.swing(*t);
        }
        found.push(next);
    }
    found
}

/// The strongest harmonic of all frequencies a series resolves.
fn strongest_of(time: &[f64], value: &[f64]) -> Option<Harmonic> {
    let span = time.last()? - time.first()?;
    let mean = value.iter().sum::<f64>() / value.len() as f64;
    if span <= 0.0 || value.iter().all(|v| *v == mean) {
        return None;
    }
    let swing: Vec<f64> = value.iter().map(|v| v - mean).collect();
    let powers = powers(time, &swing);
    let highest = powers.len().checked_sub(1)?;
    // A cosine alone explains as much with half of the power of both.
    let explained = |k: usize| if k == highest { 0.5 * powers[k] } else { powers[k] };
    let peak = (2..=highest).max_by(|a, b| explained(*a).total_cmp(&explained(*b)))?;
    let step = 0.5 / span;
    let fit = |frequency: f64| fitted(time, value, frequency);
    // What lies between the frequencies of the search.
    let near = (-20..=20).map(|part| peak as f64 + f64::from(part) / 20.0);
    let near = near.filter(|k| (2.0..highest as f64).contains(k)).filter_map(|k| fit(step * k));
    let better = |a: &Harmonic, b: &Harmonic| a.rest.total_cmp(&b.rest);
    let best = near.min_by(better).map(|best| {
        let [low, high] = [-1.0, 1.0].map(|side| best.frequency + side * step / 20.0);
        refined(best, low.max(2.0 * step), high.min(step * highest as f64), fit)
    });
    let last = if peak + 1 < highest { None } else { alternating(time, value, step * highest as f64) };
    best.into_iter().chain(last).min_by(better)
}

/// The fit with the least rest between two frequencies \[Hz\] beside that of `best`, by the golden section.
fn refined(best: Harmonic, mut low: f64, mut high: f64, fit: impl Fn(f64) -> Option<Harmonic>) -> Harmonic {
    /// Each is shorter by 0.618: to 1e-7 of what they are apart.
    const SECTIONS: usize = 34;
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let mut found = best;
    let rest = |found: &mut Harmonic, frequency: f64| match fit(frequency) {
        Some(tried) => {
            if tried.rest < found.rest {
                *found = tried;
            }
            tried.rest
        }
        None => f64::INFINITY,
    };
    let mut inner = [high - golden * (high - low), low + golden * (high - low)];
    let mut rests = inner.map(|frequency| rest(&mut found, frequency));
    for _ in 0..SECTIONS {
        if rests[0] < rests[1] {
            high = inner[1];
            inner = [high - golden * (high - low), inner[0]];
            rests = [rest(&mut found, inner[0]), rests[0]];
        } else {
            low = inner[0];
            inner = [inner[1], low + golden * (high - low)];
            rests = [rests[1], rest(&mut found, inner[1])];
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_harmonic_is_found_under_noise_larger_than_itself() {
        let time: Vec<f64> = (0..4000).map(|k| f64::from(k) * 1e-3).collect();
        // Far from the harmonic: 130 Hz, and twice its size.
        let noise = |t: f64| 2.0 * (core::f64::consts::TAU * 130.0 * t).sin();
        let value: Vec<f64> = time.iter().map(|t| 5.0 + (34.0 * t + 0.7).cos() + noise(*t)).collect();
        let found = harmonic(&time, &value, 5.0).unwrap();
        assert!((found.mean - 5.0).abs() < 2e-3 && (found.amplitude - 1.0).abs() < 5e-3, "{found:?}");
        assert!((found.frequency * core::f64::consts::TAU / 34.0 - 1.0).abs() < 2e-3, "{found:?}");
        assert!((found.rest - 2.0_f64.sqrt()).abs() < 5e-3, "{found:?}");
        assert_eq!(harmonic(&time[..300], &value[..300], 5.0), None, "not even two periods");
    }

    /// Half way between two frequencies of the search, and in a window of many periods.
    #[test]
    fn a_frequency_is_found_between_those_of_the_search() {
        let (expected, rows) = (10.9, 4000);
        let time: Vec<f64> = (0..=rows).map(|k| 20.0 * f64::from(k) / f64::from(rows)).collect();
        let frequency = expected * (1.0 + 10.5 / 750.0);
        let wave = |t: &f64| (core::f64::consts::TAU * frequency * t - 0.3).cos();
        let value: Vec<f64> = time.iter().map(wave).collect();
        let found = harmonic(&time, &value, expected).unwrap();
        assert!((found.amplitude - 1.0).abs() < 1e-3 && found.rest < 1e-3, "{found:?}");
        assert!((found.frequency / frequency - 1.0).abs() < 1e-5, "{found:?}");
        // A little beyond the highest frequency that counts: nothing is found rather than that.
        assert_eq!(harmonic(&time, &value, frequency / 1.336), None);
    }

    /// At half of the rate of the samples every sine is zero: once an amplitude of 3e11 with a rest of nothing.
    #[test]
    fn noise_from_row_to_row_is_not_taken_for_a_swing_that_is_not_there() {
        // From zero on, from elsewhere on, and even, odd.
        for (start, rows) in [(0.0, 400), (1.7, 400), (1.7, 401)] {
            let time: Vec<f64> = (0..rows).map(|k| start + f64::from(k) * 0.01).collect();
            let odd = |k: usize| if k.is_multiple_of(2) { 1.0 } else { -1.0 };
            let alone: Vec<f64> = (0..time.len()).map(|k| 2.0 + odd(k)).collect();
            let found = strongest(&time, &alone, 1)[0];
            assert!((found.amplitude - 1.0).abs() < 0.1 && (found.mean - 2.0).abs() < 0.1, "{found:?}");
            assert!(found.rest < 0.1 && found.frequency <= 50.0 + 1e-9, "{found:?}");
            assert!((found.swing(start) - 1.0).abs() < 0.1, "{found:?}");
            // Under it a swing that is stronger, and one that grows.
            let wave = |t: f64| (core::f64::consts::TAU * 3.3 * t).cos();
            let mixed: Vec<f64> = time.iter().zip(&alone).map(|(t, v)| 0.5 * v + wave(*t)).collect();
            let both = strongest(&time, &mixed, 2);
            assert!(
                (both[0].frequency - 3.3).abs() < 0.01 && (both[0].amplitude - 1.0).abs() < 0.01,
                "{both:?}"
            );
            assert!((both[1].amplitude - 0.5).abs() < 0.05, "{both:?}");
            let growing: Vec<f64> = (0..time.len()).map(|k| odd(k) * (time[k] - start)).collect();
            let largest = growing.iter().fold(0.0_f64, |largest, v| largest.max(v.abs()));
            assert!(strongest(&time, &growing, 3).iter().all(|found| found.amplitude < 1.1 * largest));
        }
    }

    #[test]
    fn harmonics_are_found_in_the_order_of_their_strength() {
        let time: Vec<f64> = (0..1200).map(|k| f64::from(k) * 2.5e-3).collect();
        let parts = [(3.0, 44.5, 0.4), (2.0, 5.43, -1.0), (0.5, 16.3, 2.0)];
        let at = |t: f64| parts.map(|(a, f, phase)| a * (core::f64::consts::TAU * f * t + phase).cos());
        let value: Vec<f64> = time.iter().map(|t| 1.0 + at(*t).iter().sum::<f64>()).collect();
        let found = strongest(&time, &value, 3);
        for (found, (amplitude, frequency, phase)) in found.iter().zip(parts) {
            assert!((found.amplitude / amplitude - 1.0).abs() < 0.03, "{found:?}");
            assert!((found.frequency / frequency - 1.0).abs() < 2e-3, "{found:?}");
            assert!((found.phase - phase).abs() < 0.1, "{found:?}");
        }
        assert!(found[2].rest < 0.05, "nothing is left: {found:?}");
        let drift: Vec<f64> = time.iter().map(|t| t * t).collect();
        let found = strongest(&time, &drift, 2);
        assert!(found.iter().all(|found| found.frequency >= 1.0 / 3.0), "not half a period: {found:?}");
        assert!(strongest(&time, &vec![2.0; 1200], 3).is_empty() && strongest(&[], &[], 3).is_empty());
    }
}
