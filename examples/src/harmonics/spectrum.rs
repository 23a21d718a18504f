//! How much of a series swings with each frequency, for tables of any length: by a fast Fourier transform of the series spread over even times
//! (Press and Rybicki 1989, Fast algorithm for spectral analysis of unevenly sampled data).

use nalgebra::Complex;

/// Square of the sum of `value exp(-i omega t)` at the frequencies `k/(2 span)`, `k` from 0 to one less than there are samples, the last of which is
/// half of the rate of the samples. To find where a series swings: within a part in a thousand of the strongest.
pub(super) fn powers(time: &[f64], value: &[f64]) -> Vec<f64> {
    let (Some(first), Some(last)) = (time.first(), time.last()) else { return Vec::new() };
    // Twice the span, so that the transform has these frequencies, and the highest of them sixteen points in a period.
    let points = (16 * time.len()).next_power_of_two();
    let scale = 0.5 * points as f64 / (last - first);
    let mut mesh = vec![Complex::new(0.0, 0.0); points];
    for (t, v) in time.iter().zip(value) {
        spread(&mut mesh, (t - first) * scale, *v);
    }
    transform(&mut mesh);
    mesh[..time.len()].iter().map(Complex::norm_sqr).collect()
}

/// Adds a value between points to the four next to it, so that sums with what is smooth over a few points stay: the weights of cubic interpolation.
fn spread(mesh: &mut [Complex<f64>], place: f64, value: f64) {
    // The transform goes round: before the first point is the last.
    let (base, part) = (place.floor(), place - place.floor());
    let weights = [
        -part * (part - 1.0) * (part - 2.0) / 6.0,
        (part + 1.0) * (part - 1.0) * (part - 2.0) / 2.0,
        -(part + 1.0) * part * (part - 2.0) / 2.0,
        (part + 1.0) * part * (part - 1.0) / 6.0,
    ];
    let len = mesh.len();
    for (k, weight) in weights.into_iter().enumerate() {
        mesh[(base as usize + len + k - 1) % len] += Complex::new(value * weight, 0.0);
    }
}

/// The discrete Fourier transform in place, of a power of two of points (Cooley and Tukey 1965).
fn transform(mesh: &mut [Complex<f64>]) {
    let len = mesh.len();
    let bits = len.trailing_zeros();
    for k in 0..len {
        let turned = k.reverse_bits().checked_shr(usize::BITS - bits).unwrap_or(0);
        if k < turned {
            mesh.swap(k, turned);
        }
    }
    // The roots of the largest part serve the smaller ones as well.
    let root = |k: usize| Complex::from_polar(1.0, -core::f64::consts::TAU * k as f64 / len as f64);
    let roots: Vec<Complex<f64>> = (0..len / 2).map(root).collect();
    let mut half = 1;
    while half < len {
        for part in mesh.chunks_exact_mut(2 * half) {
            let (even, odd) = part.split_at_mut(half);
            for (k, (even, odd)) in even.iter_mut().zip(odd).enumerate() {
                let turned = *odd * roots[k * (len / (2 * half))];
                (*even, *odd) = (*even + turned, *even - turned);
            }
        }
        half *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::powers;

    /// Against the sums, of a series with uneven times.
    #[test]
    fn the_powers_are_those_of_the_sums() {
        let time: Vec<f64> =
            (0..200).map(|k| 3.0 + 0.01 * f64::from(k) + 2e-3 * f64::from(k * k).sin()).collect();
        let value: Vec<f64> = time.iter().map(|t| (40.0 * t).cos() + 0.3 * (250.0 * t).sin()).collect();
        let found = powers(&time, &value);
        assert_eq!(found.len(), time.len());
        let largest = found.iter().copied().fold(0.0, f64::max);
        for (k, found) in found.iter().enumerate() {
            let omega = core::f64::consts::PI * k as f64 / (time[199] - time[0]);
            let (mut re, mut im) = (0.0, 0.0);
            for (t, v) in time.iter().zip(&value) {
                re += v * (omega * t).cos();
                im += v * (omega * t).sin();
            }
            assert!((found - re * re - im * im).abs() < 1e-3 * largest, "{k}: {found}");
        }
    }
}
