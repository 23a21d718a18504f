//! Walls along a line: rows of points to its right, mitred at the corners.

use super::lattice::Place;

/// Rounding, over the spacing.
const ROUNDING: f64 = 1e-6;

/// The points along one side of a line.
pub(super) struct SidePoints {
    /// Places \[m\].
    pub(super) points: Vec<Place<2>>,
    /// Area a point stands for \[m^2\].
    pub(super) area: f64,
}

/// Rows of points about `spacing` \[m\] apart to the right of the line through `corners`, until they are `depth` \[m\]
/// deep, the first row half a spacing behind the line.
///
/// Along a side the spacing is fitted to whole cells. Where sides meet, each row goes on (or ends early) to the line
/// that halves the angle; centres on that line belong to the side before it. So a right angle is filled as by a
/// square lattice. At the ends of an open line rows end with it.
pub(super) fn along(corners: &[Place<2>], closed: bool, spacing: f64, depth: f64) -> Vec<SidePoints> {
    let count = corners.len();
    let sides: Vec<Place<2>> = (0..if closed { count } else { count.saturating_sub(1) })
        .map(|k| {
            let (a, b) = (corners[k], corners[(k + 1) % count]);
            [b[0] - a[0], b[1] - a[1]]
        })
        .collect();
    // Tangent of half the angle by which the line turns to the left in front of side k.
    let turn = |k: usize| {
        if !closed && (k == 0 || k == sides.len()) {
            return 0.0;
        }
        let ([px, py], [qx, qy]) = (sides[(k + sides.len() - 1) % sides.len()], sides[k % sides.len()]);
        (0.5 * (px * qy - py * qx).atan2(px * qx + py * qy)).tan()
    };
    let rows = (depth / spacing - ROUNDING).ceil().max(1.0) as usize;
    sides
        .iter()
        .enumerate()
        .map(|(k, [dx, dy])| {
            let length = dx.hypot(*dy);
            let cells = (length / spacing).round().max(1.0);
            let (step, [tx, ty]) = (length / cells, [dx / length, dy / length]);
            let mut points = Vec::new();
            for row in 0..rows {
                let off = (row as f64 + 0.5) * spacing;
                let margin = ROUNDING * spacing;
                let (from, to) = (-off * turn(k) + margin, length + off * turn(k + 1) + margin);
                // Centres s = (c + 1/2) step with from < s <= to.
                let first = (from / step - 0.5).floor() as i64 + 1;
                let last = (to / step - 0.5).floor() as i64;
                for column in first..=last {
                    let s = (column as f64 + 0.5) * step;
                    points.push([corners[k][0] + tx * s + ty * off, corners[k][1] + ty * s - tx * off]);
                }
            }
            SidePoints { points, area: step * spacing }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All points in units of the spacing, sorted.
    fn points(corners: &[Place<2>], closed: bool, depth: f64) -> Vec<[i64; 2]> {
        let all = along(corners, closed, 1.0, depth);
        let grid = |p: &Place<2>| p.map(|x| (2.0 * x).round() as i64);
        let mut points: Vec<_> = all.iter().flat_map(|side| side.points.iter().map(grid)).collect();
        points.sort_unstable();
        points
    }

    #[test]
    fn a_basin_has_a_square_lattice_around_it_once() {
        let found = points(&[[0.0, 5.0], [0.0, 0.0], [7.0, 0.0], [7.0, 5.0]], false, 3.0);
        let mut wanted = Vec::new();
        for x in -3..10_i64 {
            for y in -3..5_i64 {
                if !((0..7).contains(&x) && y >= 0) {
                    wanted.push([2 * x + 1, 2 * y + 1]);
                }
            }
        }
        assert_eq!(found, wanted);
    }

    #[test]
    fn a_corner_that_stands_into_the_fluid_is_filled_once() {
        // A step: the fluid is above, the line turns to the right at its edge.
        let found = points(&[[0.0, 0.0], [6.0, 0.0], [6.0, -6.0]], false, 3.0);
        let mut wanted = Vec::new();
        for x in 0..6_i64 {
            for y in -6..0_i64 {
                if y >= -3 || x >= 3 {
                    wanted.push([2 * x + 1, 2 * y + 1]);
                }
            }
        }
        assert_eq!(found, wanted);
    }

    #[test]
    fn a_ring_has_the_area_of_its_wall_whatever_its_angles() {
        // A hexagon of side 40: outside it within a depth of 3 lie 6 (40 3 + 3^2 tan 30).
        let corner = |k: i32| {
            let (sin, cos) = (f64::from(k) * core::f64::consts::FRAC_PI_3).sin_cos();
            [40.0 * cos, 40.0 * sin]
        };
        let ring: Vec<Place<2>> = (0..6).map(corner).collect();
        let area: f64 =
            along(&ring, true, 0.5, 3.0).iter().map(|side| side.points.len() as f64 * side.area).sum();
        let exact = 6.0 * (40.0 * 3.0 + 9.0 * (30.0_f64).to_radians().tan());
        assert!((area / exact - 1.0).abs() < 5e-3, "{area} {exact}");
    }
}
