//! Numbers read off a series: periods, extremes, slopes.

/// Times at which a series passes zero, by linear interpolation.
pub fn zeros(time: &[f64], value: &[f64]) -> Vec<f64> {
    let pairs = time.windows(2).zip(value.windows(2));
    pairs
        .filter(|(_, v)| v[0] != 0.0 && v[0] * v[1] <= 0.0)
        .map(|(t, v)| t[0] + (t[1] - t[0]) * v[0] / (v[0] - v[1]))
        .collect()
}

/// Smallest and largest value; `None` of nothing.
pub fn extremes(value: &[f64]) -> Option<[f64; 2]> {
    let first = *value.first()?;
    Some(value.iter().fold([first; 2], |[low, high], &v| [low.min(v), high.max(v)]))
}

/// An oscillation about any level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillation {
    /// Half the sum of the largest and the smallest value in the last period.
    pub mean: f64,
    /// Half their difference.
    pub amplitude: f64,
    /// Mean period of the whole series \[s\].
    pub period: f64,
}

/// Takes an oscillation apart as Turek and Hron (2006) do: mean and amplitude from the extremes of the last period.
/// The period is the mean time between upward passages of the level midway between all extremes. `None` if
/// there are fewer than two passages.
pub fn oscillation(time: &[f64], value: &[f64]) -> Option<Oscillation> {
    let [low, high] = extremes(value)?;
    let level = 0.5 * (low + high);
    let swing: Vec<f64> = value.iter().map(|v| v - level).collect();
    // Every other passage is upwards; two make a period whichever way the first one went.
    let zeros = zeros(time, &swing);
    let whole = zeros.len().checked_sub(1)? / 2;
    let period = (zeros.get(2 * whole)? - zeros.first()?) / whole as f64;
    if !period.is_finite() {
        return None;
    }
    let start = time.partition_point(|t| *t < time.last().copied().unwrap_or(0.0) - period);
    let [low, high] = extremes(&value[start..])?;
    Some(Oscillation { mean: 0.5 * (high + low), amplitude: 0.5 * (high - low), period })
}

/// Largest size of the series between consecutive times of `at`, with the time it is reached, by a
/// parabola through the highest three samples.
pub fn peaks_between(time: &[f64], value: &[f64], at: &[f64]) -> Vec<(f64, f64)> {
    let highest = |ends: &[f64]| {
        let inside = (0..time.len()).filter(|k| time[*k] >= ends[0] && time[*k] < ends[1]);
        let k = inside.max_by(|a, b| value[*a].abs().total_cmp(&value[*b].abs()))?;
        let (a, b, c) = (value.get(k.checked_sub(1)?)?, value[k], value.get(k + 1)?);
        let (h, bend) = (0.5 * (time[k + 1] - time[k - 1]), a - 2.0 * b + c);
        let slope = 0.5 * (c - a);
        let shift = if bend == 0.0 { 0.0 } else { -slope / bend };
        Some((time[k] + shift * h, (b + 0.5 * slope * shift).abs()))
    };
    at.windows(2).filter_map(highest).collect()
}

/// Slope of the least-squares line through the points.
pub fn slope(x: &[f64], y: &[f64]) -> f64 {
    let n = x.len() as f64;
    let (mx, my) = (x.iter().sum::<f64>() / n, y.iter().sum::<f64>() / n);
    let (mut xy, mut xx) = (0.0, 0.0);
    for (x, y) in x.iter().zip(y) {
        xy += (x - mx) * (y - my);
        xx += (x - mx) * (x - mx);
    }
    xy / xx
}

/// Rate of an exponential decay `exp(-rate t)` by least squares over the logarithms.
pub fn decay_rate(time: &[f64], value: &[f64]) -> f64 {
    let logarithm: Vec<f64> = value.iter().map(|v| v.abs().ln()).collect();
    -slope(time, &logarithm)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_damped_oscillation_is_taken_apart() {
        let time: Vec<f64> = (0..1000).map(|k| k as f64 * 0.01).collect();
        let value: Vec<f64> = time.iter().map(|t| (-0.2 * t).exp() * (3.0 * t).cos()).collect();
        let zeros = zeros(&time, &value);
        let half_period = (zeros[zeros.len() - 1] - zeros[0]) / (zeros.len() - 1) as f64;
        assert!((half_period * 3.0 / core::f64::consts::PI - 1.0).abs() < 1e-4, "{half_period}");
        let (t, v): (Vec<_>, Vec<_>) = peaks_between(&time, &value, &zeros).into_iter().unzip();
        assert!((decay_rate(&t, &v) - 0.2).abs() < 1e-4);
    }

    #[test]
    fn mean_amplitude_and_period_of_a_swing_about_a_level() {
        let time: Vec<f64> = (0..=4000).map(|k| f64::from(k) * 2.5e-3).collect();
        let value: Vec<f64> = time.iter().map(|t| -0.06 + 0.065 * (6.9 * t).cos()).collect();
        let found = oscillation(&time, &value).unwrap();
        assert!((found.mean + 0.06).abs() < 1e-5 && (found.amplitude - 0.065).abs() < 1e-5, "{found:?}");
        assert!((found.period * 6.9 / core::f64::consts::TAU - 1.0).abs() < 1e-4, "{found:?}");
        assert_eq!(oscillation(&time[..100], &value[..100]), None);
        assert_eq!(oscillation(&[], &[]), None);
    }
}
