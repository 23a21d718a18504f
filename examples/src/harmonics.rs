//! Series as sums of harmonics.

use nalgebra::{Matrix3, Vector3};

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
/// \[Hz\]. Unlike extremes it does not grow with the noise. `None` if the series is shorter than two periods.
pub fn harmonic(time: &[f64], value: &[f64], expected: f64) -> Option<Harmonic> {
    /// Steps of the search on either side.
    const STEPS: i32 = 250;
    let span = time.last()? - time.first()?;
    if !(expected > 0.0 && span * expected >= 2.0) {
        return None;
    }
    let at = |step: i32| expected * (1.0 + f64::from(step) / f64::from(3 * STEPS));
    let fits = (-STEPS..=STEPS).filter_map(|step| fitted(time, value, at(step)));
    fits.min_by(|a, b| a.rest.total_cmp(&b.rest))
}

/// The `count` harmonics that explain most of a series, one after the other: each is the strongest of what those before it leave. Frequencies lie between
/// one period in the series and half of the rate of its samples, and are told apart from half a period in the series on. Fewer if nothing is left.
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
    let step = 0.5 / span;
    let power = |k: usize| {
        let omega = core::f64::consts::TAU * step * k as f64;
        let (mut re, mut im) = (0.0, 0.0);
        for (t, v) in time.iter().zip(value) {
            let (sin, cos) = (omega * t).sin_cos();
            re += (v - mean) * cos;
            im += (v - mean) * sin;
        }
        (k, re * re + im * im)
    };
    let (peak, _) = (2..time.len()).map(power).max_by(|a, b| a.1.total_cmp(&b.1))?;
    // What lies between the frequencies of the search.
    let ends = 2.0..=(time.len() - 1) as f64;
    let near = (-20..=20).map(|part| peak as f64 + f64::from(part) / 20.0);
    let near = near.filter(|k| ends.contains(k)).map(|k| step * k);
    near.filter_map(|frequency| fitted(time, value, frequency)).min_by(|a, b| a.rest.total_cmp(&b.rest))
}

/// The least squares of a given frequency \[Hz\].
fn fitted(time: &[f64], value: &[f64], frequency: f64) -> Option<Harmonic> {
    let (mut matrix, mut right) = (Matrix3::<f64>::zeros(), Vector3::<f64>::zeros());
    let shape = |t: f64| {
        let (sin, cos) = (core::f64::consts::TAU * frequency * t).sin_cos();
        Vector3::new(1.0, cos, sin)
    };
    for (t, v) in time.iter().zip(value) {
        let shape = shape(*t);
        matrix += shape * shape.transpose();
        right += shape * *v;
    }
    let found = matrix.lu().solve(&right)?;
    let squares: f64 = time.iter().zip(value).map(|(t, v)| (v - found.dot(&shape(*t))).powi(2)).sum();
    let rest = (squares / value.len() as f64).sqrt();
    let phase = -found[2].atan2(found[1]);
    Some(Harmonic { mean: found[0], amplitude: found[1].hypot(found[2]), frequency, phase, rest })
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
