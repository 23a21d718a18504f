//! A harmonic of a given frequency in a series, by least squares.

use super::Harmonic;
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};

/// The least squares of a given frequency \[Hz\]; `None` where the samples cannot tell its cosine, its sine and the mean apart: near half of their
/// rate a small rest is then the difference of two large swings.
pub(super) fn fitted(time: &[f64], value: &[f64], frequency: f64) -> Option<Harmonic> {
    /// Least over largest eigenvalue of the normal equations: 1/2 over many periods, 0.4 over one and a third.
    const LEAST: f64 = 0.1;
    let middle = 0.5 * (time.first()? + time.last()?);
    let (mut matrix, mut right) = (Matrix3::<f64>::zeros(), Vector3::<f64>::zeros());
    // From the middle on, about which sines are odd and cosines even.
    let shape = |t: f64| {
        let (sin, cos) = (core::f64::consts::TAU * frequency * (t - middle)).sin_cos();
        Vector3::new(1.0, cos, sin)
    };
    for (t, v) in time.iter().zip(value) {
        let shape = shape(*t);
        matrix += shape * shape.transpose();
        right += shape * *v;
    }
    let sizes = matrix.symmetric_eigenvalues();
    let told_apart = sizes.min() > LEAST * sizes.max();
    let found = matrix.lu().solve(&right).filter(|_| told_apart)?;
    let rest = rest(time, value, |t| found.dot(&shape(t)));
    let amplitude = found[1].hypot(found[2]);
    let phase = at_zero(-found[2].atan2(found[1]), frequency, middle);
    Some(Harmonic { mean: found[0], amplitude, frequency, phase, rest })
}

/// Mean and cosine of half of the rate of the samples \[Hz\], which is the highest frequency they can have.
pub(super) fn alternating(time: &[f64], value: &[f64], frequency: f64) -> Option<Harmonic> {
    let first = *time.first()?;
    let cosine = |t: f64| (core::f64::consts::TAU * frequency * (t - first)).cos();
    let (mut matrix, mut right) = (Matrix2::<f64>::zeros(), Vector2::<f64>::zeros());
    for (t, v) in time.iter().zip(value) {
        let shape = Vector2::new(1.0, cosine(*t));
        matrix += shape * shape.transpose();
        right += shape * *v;
    }
    let found = matrix.lu().solve(&right)?;
    let rest = rest(time, value, |t| found[0] + found[1] * cosine(t));
    let turned = if found[1] < 0.0 { core::f64::consts::PI } else { 0.0 };
    let phase = at_zero(turned, frequency, first);
    Some(Harmonic { mean: found[0], amplitude: found[1].abs(), frequency, phase, rest })
}

/// Root mean square of what `found` leaves.
fn rest(time: &[f64], value: &[f64], found: impl Fn(f64) -> f64) -> f64 {
    let squares: f64 = time.iter().zip(value).map(|(t, v)| (v - found(*t)).powi(2)).sum();
    (squares / value.len() as f64).sqrt()
}

/// A phase that is told at the time `origin` \[s\], at time zero: between `-pi` and `pi`.
fn at_zero(phase: f64, frequency: f64, origin: f64) -> f64 {
    use core::f64::consts::{PI, TAU};
    (phase - TAU * frequency * origin + PI).rem_euclid(TAU) - PI
}
