//! What is read off the particles of the fluid.

use crate::{GAP, connected};
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Kernel, Real, Vector};

/// How far around a place values are taken from, in spacings.
const REACH: f64 = 2.0;

/// Mean of the values around a place, weighted by nearness; zero where there are none.
pub(super) fn mean_around<T: Real, const N: usize>(
    at: &Vector<T, 2>,
    l0: f64,
    positions: &[Vector<T, 2>],
    value: impl Fn(usize) -> [f64; N],
) -> [f64; N] {
    let reach = REACH * l0;
    let (mut sum, mut weights) = ([0.0; N], 0.0);
    for (k, r) in positions.iter().enumerate() {
        let distance = (r - at).norm().to_double();
        if distance < reach {
            let weight = WendlandC2.weight(distance.max(1e-6 * l0), reach);
            sum.iter_mut().zip(value(k)).for_each(|(sum, value)| *sum += weight * value);
            weights += weight;
        }
    }
    if weights > 0.0 { sum.map(|sum| sum / weights) } else { sum }
}

pub(super) fn front<T: Real>(
    positions: &[Vector<T, 2>],
    l0: f64,
    start: [f64; 2],
    height: f64,
    sign: f64,
) -> f64 {
    let low = positions.iter().filter(|r| {
        let y = r[1].to_double() - start[1];
        y < height && y > -l0
    });
    let ahead = low.map(|r| sign * (r[0].to_double() - start[0]));
    connected(ahead.filter(|x| *x > -GAP * l0).collect(), -0.5 * l0, l0)
}

pub(super) fn level<T: Real>(positions: &[Vector<T, 2>], l0: f64, foot: [f64; 2]) -> f64 {
    let near = positions.iter().filter(|r| (r[0].to_double() - foot[0]).abs() < 2.0 * l0);
    let above = near.map(|r| r[1].to_double() - foot[1]);
    connected(above.filter(|y| *y > -l0).collect(), -0.5 * l0, l0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn front_level_and_means_of_a_block_of_water_with_spray() {
        let l0 = 0.01;
        let mut water: Vec<Vector<f64, 2>> = (0..140 * 30)
            .map(|k| Vector::from([(0.5 + f64::from(k % 140)) * l0, (0.5 + f64::from(k / 140)) * l0]))
            .collect();
        water.push(Vector::from([1.5, 0.02]));
        water.push(Vector::from([0.6, 0.4]));
        assert!((front(&water, l0, [1.2, 0.0], 0.06, 1.0) - 0.2).abs() < 1e-9);
        assert!((front(&water, l0, [0.3, 0.0], 0.06, -1.0) - 0.3).abs() < 1e-9);
        assert!((level(&water, l0, [0.6, 0.0]) - 0.3).abs() < 1e-9);
        assert!(level(&water, l0, [1.6, 0.0]).abs() < 1e-9, "dry");
        let values = |k: usize| [7.0 - water[k].y, 2.0 * water[k].x];
        let [a, b] = mean_around(&Vector::from([0.5, 0.1]), l0, &water, values);
        assert!((a - 6.9).abs() < 1e-9 && (b - 1.0).abs() < 1e-9, "{a} and {b}");
        assert_eq!(mean_around(&Vector::from([3.0, 0.1]), l0, &water, values), [0.0; 2]);
    }
}
