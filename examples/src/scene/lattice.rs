//! Regions filled with points.

use mps_io::scene_file::{Corners, Region};

/// A place \[m\].
pub(super) type Place<const D: usize> = [f64; D];

/// Share of a spacing that rounding may move a point on a surface.
const ROUNDING: f64 = 1e-6;

/// Centres of the square (in three dimensions cubic) cells of this `spacing` \[m\] that fill a region.
///
/// The lattice begins at the lower corner of the box around the region, and a cell belongs to it if its centre does;
/// a centre on a surface counts as inside. So a length that is a whole number of spacings is filled exactly, with the
/// outer points half a spacing behind the surface; any other one is rounded to whole cells, the half upwards.
pub(super) fn fill<const D: usize>(region: &Region, spacing: f64) -> Vec<Place<D>> {
    let Some(Corners { lower, upper }) = region.bounds() else { return Vec::new() };
    let count = |axis: usize| ((upper[axis] - lower[axis]) / spacing).ceil().max(0.0) as usize + 1;
    let place = |axis: usize, k: usize| lower[axis] + (k as f64 + 0.5) * spacing;
    let counts: [usize; D] = core::array::from_fn(count);
    let centres = (0..counts.iter().product()).map(|mut k: usize| {
        core::array::from_fn(|axis| {
            let here = k % counts[axis];
            k /= counts[axis];
            place(axis, here)
        })
    });
    centres.filter(|centre| region.contains(centre, ROUNDING * spacing)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use mps_io::scene_file::{Disc, Tube};

    fn cells(width: f64, height: f64) -> usize {
        fill::<2>(&Region::between([0.1, -0.3], [0.1 + width, height - 0.3]), 0.1).len()
    }

    #[test]
    fn whole_cells_are_counted_exactly_and_others_rounded() {
        assert_eq!(cells(0.3, 0.7), 21);
        assert_eq!([cells(0.34, 0.7), cells(0.35, 0.7), cells(0.36, 0.7)], [21, 28, 28]);
        let region = Region::Box(Corners { lower: vec![0.0, 0.0], upper: vec![0.2, 0.1] });
        assert_eq!(fill::<2>(&region, 0.1), [[0.05, 0.05], [0.15000000000000002, 0.05]]);
    }

    #[test]
    fn a_disc_has_its_area() {
        let disc = Region::Circle(Disc { center: vec![0.3, 0.2], radius: 0.5 });
        let area = fill::<2>(&disc, 0.01).len() as f64 * 1e-4;
        assert!((area / (core::f64::consts::PI * 0.25) - 1.0).abs() < 5e-3, "{area}");
    }

    #[test]
    fn a_ball_and_a_cylinder_have_their_volumes() {
        use core::f64::consts::PI;
        let ball = Region::Ball(Disc { center: vec![0.3, 0.2, -0.1], radius: 0.5 });
        let tube = Tube { from: vec![0.0, 0.3, 0.1], to: vec![0.0, 0.3, 0.9], radius: 0.25 };
        for (region, exact) in [(ball, PI / 6.0), (Region::Cylinder(tube), 0.05 * PI)] {
            let volume = fill::<3>(&region, 0.02).len() as f64 * 8e-6;
            assert!((volume / exact - 1.0).abs() < 1e-2, "{volume} and {exact}");
        }
    }
}
