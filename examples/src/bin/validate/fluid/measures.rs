//! Numbers read off a fluid or a series.

use mps_fluid::FluidParticles;
use mps_kernel::Vector;

/// Root mean square over the particles of `found(i) - exact(r_i)`.
pub(crate) fn rms<const D: usize>(
    particles: &FluidParticles<f64, D>,
    found: impl Fn(usize) -> f64,
    exact: impl Fn(&Vector<f64, D>) -> f64,
) -> f64 {
    let square = |(i, r): (usize, &Vector<f64, D>)| (found(i) - exact(r)).powi(2);
    let sum: f64 = particles.position.iter().enumerate().map(square).sum();
    (sum / particles.position.len() as f64).sqrt()
}

/// Level of an open tank \[m\]: mean over columns two spacings wide of the highest particle, plus the
/// half spacing by which a surface lies above its particles.
pub(crate) fn level<const D: usize>(particles: &FluidParticles<f64, D>, width: f64, l0: f64) -> f64 {
    let columns = ((width / (2.0 * l0)).floor() as usize).max(1);
    let mut tops = vec![0.0_f64; columns.pow(D as u32 - 1)];
    for r in &particles.position {
        let place = (0..D - 1).rev().fold(0, |place, axis| {
            let column = (r[axis] / width * columns as f64).max(0.0) as usize;
            place * columns + column.min(columns - 1)
        });
        tops[place] = tops[place].max(r[D - 1]);
    }
    tops.iter().sum::<f64>() / tops.len() as f64 + 0.5 * l0
}

/// `sum r x u` of plane particles over the sum of the sizes of its terms at most, and that sum.
pub(crate) fn angular_momentum(particles: &FluidParticles<f64, 2>) -> f64 {
    let moment = |(r, u): (&Vector<f64, 2>, &Vector<f64, 2>)| r.x * u.y - r.y * u.x;
    particles.position.iter().zip(&particles.velocity).map(moment).sum()
}

/// Sum of the sizes of the terms of [`angular_momentum`].
pub(crate) fn angular_size(particles: &FluidParticles<f64, 2>) -> f64 {
    particles.position.iter().zip(&particles.velocity).map(|(r, u)| r.norm() * u.norm()).sum()
}

/// Times at which a series passes zero, by linear interpolation.
pub(crate) fn zeros(time: &[f64], value: &[f64]) -> Vec<f64> {
    let pairs = time.windows(2).zip(value.windows(2));
    pairs
        .filter(|(_, v)| v[0] != 0.0 && v[0] * v[1] <= 0.0)
        .map(|(t, v)| t[0] + (t[1] - t[0]) * v[0] / (v[0] - v[1]))
        .collect()
}

/// Largest size of the series between consecutive times of `at`, with the time it is reached, by a
/// parabola through the highest three samples.
pub(crate) fn peaks_between(time: &[f64], value: &[f64], at: &[f64]) -> Vec<(f64, f64)> {
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
pub(crate) fn slope(x: &[f64], y: &[f64]) -> f64 {
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
pub(crate) fn decay_rate(time: &[f64], value: &[f64]) -> f64 {
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
    fn the_level_is_that_of_the_highest_particles() {
        let points = super::super::scene::lattice([0.0; 3], [4, 4, 6], 0.5);
        let particles = FluidParticles::at_rest(points);
        assert!((level(&particles, 2.0, 0.5) - 3.0).abs() < 1e-12);
    }
}
