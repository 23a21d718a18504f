//! What the pressure sensors in the far wall feel.
//!
//! A sensor is a disc in the wall, and its pressure the mean over the disc of the force of the water on
//! the points of the wall, a row of which stands for a stripe of its surface. That is the load the
//! wall really bears, momentum for momentum. (The pressure of the particles next to the wall is not:
//! where water turns at a wall it is higher by a third, and no less so at a finer spacing; see
//! `docs/dam-break.md`.) Nothing is averaged over time.

use crate::setup::{HEIGHT, WALL_SPACING};
use mps_fluid::Boundary;
use mps_kernel::Real;

/// Heights of the centres above the bed \[m\]: 3, 15, 30 and 80 mm in the experiment, whose column was half
/// as high.
pub(crate) const HEIGHTS: [f64; 4] = [0.01 * HEIGHT, 0.05 * HEIGHT, 0.1 * HEIGHT, 80.0 / 300.0 * HEIGHT];
/// Radius of the sensing disc \[m\]: 4.2 mm across in the experiment.
const DISC: f64 = 4.2 / 300.0 * HEIGHT / 2.0;
/// Points on the disc, from the lowest to the highest.
const POINTS: usize = 9;

/// Pressure \[Pa\] on each sensor in the last step.
pub(crate) fn pressures<T: Real>(boundary: &Boundary<T, 2>, l0: f64) -> [f64; 4] {
    let spacing = WALL_SPACING * l0;
    let rows = rows(boundary, spacing, ((HEIGHTS[3] + DISC) / spacing) as usize + 2);
    HEIGHTS.map(|z| {
        let (mut sum, mut weights) = (0.0, 0.0);
        for k in 0..POINTS {
            let s = (2.0 * k as f64 + 1.0) / POINTS as f64 - 1.0;
            // The disc is widest at its middle.
            let chord = (1.0 - s * s).sqrt();
            sum += chord * at(&rows, (z + s * DISC) / spacing);
            weights += chord;
        }
        sum / weights
    })
}

/// Edges \[m\] of the large sensor of Buchner (2002), a disc of 90 mm whose upper edge is 160 mm above the bed: where other
/// simulations have been compared.
const LARGE: [f64; 2] = [0.07, 0.16];

/// Mean pressure \[Pa\] on the wall over the height of the large sensor in the last step.
pub(crate) fn large_sensor<T: Real>(boundary: &Boundary<T, 2>, l0: f64) -> f64 {
    const HEIGHTS: usize = 45;
    let spacing = WALL_SPACING * l0;
    let rows = rows(boundary, spacing, (LARGE[1] / spacing) as usize + 2);
    let step = (LARGE[1] - LARGE[0]) / HEIGHTS as f64;
    let sum: f64 = (0..HEIGHTS).map(|k| at(&rows, (LARGE[0] + (k as f64 + 0.5) * step) / spacing)).sum();
    sum / HEIGHTS as f64
}

/// Pressure \[Pa\] on each of the lowest `count` rows of the far wall. Below the bed the wall goes on; what
/// its points bear there in the corner is the share of the rows above by symmetry.
fn rows<T: Real>(boundary: &Boundary<T, 2>, spacing: f64, count: usize) -> Vec<f64> {
    let mut rows = vec![0.0; count];
    for a in boundary.reactive() {
        let row = (boundary.position[a][1].to_double() / spacing).floor();
        let above = if row < 0.0 { -1.0 - row } else { row };
        if let Some(row) = rows.get_mut(above as usize) {
            *row += boundary.force[a][0].to_double() / spacing;
        }
    }
    rows
}

/// Value at a height, in rows, between the middles of two rows.
fn at(rows: &[f64], height: f64) -> f64 {
    let from = (height - 0.5).max(0.0);
    let below = from.floor();
    let value = |k: usize| rows.get(k).copied().unwrap_or(0.0);
    let (a, b) = (value(below as usize), value(below as usize + 1));
    a + (from - below) * (b - a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::{DENSITY, DamBreak, GRAVITY, LENGTH, Release, Settings, Smoothing, TANK, Walls};
    use mps_fluid::Tension;
    use mps_kernel::weights::WendlandGradient;
    use mps_neighbors::Parallel;

    /// The column moved against the far wall presses on it with its weight. The fine points of the wall
    /// push an eighth harder on a lattice than the lattice going on would; in a flow, particles then move
    /// off by a few hundredths of a spacing.
    #[test]
    fn water_at_rest_is_felt_as_its_weight() {
        for l0 in [0.02, 0.01] {
            let settings = Settings {
                spacing: l0,
                radius: 4.0,
                end_time: 1.0,
                // The pressure of the column at rest.
                release: Release::Lifted,
                walls: Walls::Law,
                sound_ratio: 10.0,
                cfl: 0.5,
                diffusion: Smoothing::Filter(0.5),
                alpha: 0.02,
                tension: Tension::Clip,
                collisions: true,
                shifting: 0,
                pressure_form: mps_fluid::PressureForm::Plain,
            };
            let mut dam = DamBreak::<f64, _>::new(&settings, WendlandGradient).unwrap();
            for r in &mut dam.fluid_mut().particles_mut().position {
                r.x += TANK - LENGTH;
            }
            dam.step(&Parallel::serial()).unwrap();
            for (p, z) in pressures(dam.fluid().boundary(), l0).into_iter().zip(HEIGHTS) {
                let exact = DENSITY * GRAVITY * (HEIGHT - z);
                assert!((0.97..1.13).contains(&(p / exact)), "{p} Pa at {z} m, exact {exact} Pa, l0 {l0}");
            }
        }
    }

    #[test]
    fn between_rows_the_pressure_is_linear_and_at_the_bed_level() {
        let rows = [1.0, 2.0, 4.0];
        assert_eq!([0.0, 0.5, 1.0, 1.5, 2.0].map(|height| at(&rows, height)), [1.0, 1.0, 1.5, 2.0, 3.0]);
    }
}
