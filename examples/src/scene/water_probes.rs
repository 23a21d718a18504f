//! What is read off the particles of the fluid.

use super::lattice::Place;
use crate::{GAP, connected};
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Kernel, Real, Vector};

/// How far around a place values are taken from, in spacings.
const REACH: f64 = 2.0;

/// Mean of the values around a place, weighted by nearness; zero where there are none.
pub(super) fn mean_around<T: Real, const D: usize, const N: usize>(
    at: &Vector<T, D>,
    l0: f64,
    positions: &[Vector<T, D>],
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

pub(super) fn front<T: Real, const D: usize>(
    positions: &[Vector<T, D>],
    l0: f64,
    start: Place<D>,
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

pub(super) fn level<T: Real, const D: usize>(positions: &[Vector<T, D>], l0: f64, foot: Place<D>) -> f64 {
    let beside = |r: &Vector<T, D>, axis: usize| (r[axis].to_double() - foot[axis]).abs() < 2.0 * l0;
    let near = positions.iter().filter(|r| (0..D).all(|axis| axis == 1 || beside(r, axis)));
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

    #[test]
    fn the_level_of_a_trough_is_that_above_its_foot() {
        let l0 = 0.01;
        // Ten deep where z is below a tenth, twenty deep beyond.
        let water: Vec<Vector<f64, 3>> = (0..4 * 20 * 20)
            .map(|k| [k % 4, (k / 4) % 20, k / 80])
            .filter(|[_, y, z]| *z >= 10 || *y < 10)
            .map(|cell| Vector::from(cell.map(|k| (0.5 + f64::from(k)) * l0)))
            .collect();
        for (z, depth) in [(0.05, 0.1), (0.15, 0.2)] {
            let found = level(&water, l0, [0.02, 0.0, z]);
            assert!((found - depth).abs() < 1e-9, "{found} at {z}");
        }
    }
}
