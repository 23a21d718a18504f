//! Where the water is: its front on the bed and its level at the gauges. Spray does not count.

use crate::setup::{HEIGHT, LENGTH, TANK};
use mps_examples::{GAP, connected};
use mps_kernel::{Real, Vector};

/// Distance of the level gauges from the back wall \[m\]: 300, 865, 1114 and 1362 mm in the experiment.
pub(crate) const GAUGES: [f64; 4] =
    [HEIGHT * 300.0 / 300.0, HEIGHT * 865.0 / 300.0, HEIGHT * 1114.0 / 300.0, HEIGHT * 1362.0 / 300.0];
/// The front is looked for below this height \[m\].
const BED: f64 = 0.1 * HEIGHT;

/// How far the water has come along the bed \[m\], from where the gate was; at most to the wall.
pub(crate) fn front<T: Real>(positions: &[Vector<T, 2>], l0: f64) -> f64 {
    let low = positions.iter().filter(|r| r[1].to_double() < BED).map(|r| r[0].to_double() - LENGTH);
    connected(low.filter(|x| *x > -GAP * l0).collect(), -0.5 * l0, l0).min(TANK - LENGTH)
}

/// Level of the water \[m\] at each gauge.
pub(crate) fn levels<T: Real>(positions: &[Vector<T, 2>], l0: f64) -> [f64; 4] {
    GAUGES.map(|gauge| {
        let near = positions.iter().filter(|r| (r[0].to_double() - gauge).abs() < 2.0 * l0);
        connected(near.map(|r| r[1].to_double()).collect(), -0.5 * l0, l0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spray_is_neither_front_nor_level() {
        let l0 = 0.01;
        let mut water: Vec<Vector<f64, 2>> = (0..140 * 30)
            .map(|k| Vector::from([(0.5 + f64::from(k % 140)) * l0, (0.5 + f64::from(k / 140)) * l0]))
            .collect();
        water.push(Vector::from([1.5, 0.02]));
        water.push(Vector::from([HEIGHT, 0.4]));
        assert!((front(&water, l0) - 0.2).abs() < 1e-9);
        assert!((levels(&water, l0)[0] - 0.3).abs() < 1e-9);
        assert!(levels(&water, l0)[1].abs() < 1e-9, "dry");
    }
}
