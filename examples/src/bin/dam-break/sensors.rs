//! What the pressure sensors in the far wall feel.
//!
//! A sensor is a disc in the wall. Its pressure is the mean over the disc of the pressure on the wall,
//! and that is the mean of the particles near the point on the wall, weighted by distance. Each
//! particle's pressure is first carried to the height of the point hydrostatically, as the walls of the
//! fluid do it; across the wall nothing is added, because a wall at rest has no pressure gradient
//! across it. Nothing is averaged over time.

use crate::setup::{DENSITY, GRAVITY, HEIGHT, TANK};
use mps_fluid::FluidParticles;
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Kernel, Real};

/// Heights of the centres above the bed \[m\]: 3, 15, 30 and 80 mm in the experiment, whose column was half
/// as high.
pub(crate) const HEIGHTS: [f64; 4] = [0.01 * HEIGHT, 0.05 * HEIGHT, 0.1 * HEIGHT, 80.0 / 300.0 * HEIGHT];
/// Radius of the sensing disc \[m\]: 4.2 mm across in the experiment.
const DISC: f64 = 4.2 / 300.0 * HEIGHT / 2.0;
/// Reach of the weight, over the spacing: the particles within two layers.
const REACH: f64 = 2.0;
/// Points on the disc, from the lowest to the highest.
const POINTS: usize = 5;

/// Pressure \[Pa\] on each sensor.
pub(crate) fn pressures<T: Real>(particles: &FluidParticles<T, 2>, l0: f64) -> [f64; 4] {
    let reach = REACH * l0;
    let highest = HEIGHTS[3] + DISC + reach;
    let near: Vec<[f64; 3]> = (particles.position.iter().zip(&particles.pressure))
        .map(|(r, p)| [TANK - r[0].to_double(), r[1].to_double(), p.to_double()])
        .filter(|[off, y, _]| *off < reach && *y < highest)
        .collect();
    HEIGHTS.map(|z| {
        let (mut sum, mut weights) = (0.0, 0.0);
        for k in 0..POINTS {
            let s = (2.0 * k as f64 + 1.0) / POINTS as f64 - 1.0;
            // The disc is widest at its middle.
            let chord = (1.0 - s * s).sqrt();
            sum += chord * on_wall(&near, z + s * DISC, reach, l0);
            weights += chord;
        }
        sum / weights
    })
}

/// Pressure \[Pa\] on the wall at height `z`, from particles given by distance to the wall, height and
/// pressure.
fn on_wall(near: &[[f64; 3]], z: f64, reach: f64, l0: f64) -> f64 {
    let (mut sum, mut weights) = (0.0, 0.0);
    for &[off, y, p] in near {
        let weight = WendlandC2.weight(off.hypot(y - z), reach);
        sum += weight * (p + DENSITY * GRAVITY * (y - z));
        weights += weight;
    }
    // The weight over a quarter of its disc, in particles: what a corner full of water has. A wall
    // with less in front of it is dry in part, and there the pressure is zero.
    let corner = std::f64::consts::PI * (reach / l0).powi(2) / 28.0;
    (sum / weights.max(corner)).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use mps_kernel::Vector;

    /// A lattice against the far wall, filled to `depth`, at rest.
    fn resting(l0: f64, depth: f64) -> FluidParticles<f64, 2> {
        let (across, up) = (8, (depth / l0).round() as usize);
        let place = |k: usize| {
            Vector::from([TANK - (0.5 + (k % across) as f64) * l0, (0.5 + (k / across) as f64) * l0])
        };
        let mut water = FluidParticles::at_rest((0..across * up).map(place).collect());
        for (p, r) in water.pressure.iter_mut().zip(&water.position) {
            *p = DENSITY * GRAVITY * (depth - r.y);
        }
        water
    }

    #[test]
    fn water_at_rest_is_felt_exactly_at_any_spacing() {
        for l0 in [0.02, 0.01, 0.005, 0.0025] {
            let felt = pressures(&resting(l0, 0.4), l0);
            for (p, z) in felt.into_iter().zip(HEIGHTS) {
                let exact = DENSITY * GRAVITY * (0.4 - z);
                assert!((p / exact - 1.0).abs() < 1e-9, "{p} Pa at {z} m, exact {exact} Pa, l0 {l0}");
            }
        }
    }

    #[test]
    fn a_dry_sensor_feels_nothing_and_spray_little() {
        let l0 = 0.005;
        assert_eq!(pressures(&resting(l0, 0.1), l0)[3], 0.0);
        let mut drop = FluidParticles::at_rest(vec![Vector::from([TANK - l0, HEIGHTS[3] + l0])]);
        drop.pressure[0] = 1000.0;
        let felt = pressures(&drop, l0)[3];
        assert!(felt > 0.0 && felt < 500.0, "{felt} Pa of a drop at 1000 Pa");
    }
}
