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
/// square lattice. At the ends of an open line rows end with it. Where other sides are nearer, rows have ended as well: an obstacle
/// that is narrower than two depths is filled once, each half from its own side, and nothing stands out of it.
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
                    let point = [corners[k][0] + tx * s + ty * off, corners[k][1] + ty * s - tx * off];
                    if is_nearest(corners, sides.len(), k, &point, margin) {
                        points.push(point);
                    }
                }
            }
            SidePoints { points, area: step * spacing }
        })
        .collect()
}

/// Whether no other side is nearer to a point than side `own`; of two equally near ones the first has it. With the sides beside it
/// the mitres have settled that.
fn is_nearest(corners: &[Place<2>], sides: usize, own: usize, point: &Place<2>, margin: f64) -> bool {
    let count = corners.len();
    let distance = |k: usize| from_side(&corners[k], &corners[(k + 1) % count], point);
    let beside = |k: usize| k.abs_diff(own) <= 1 || (sides == count && k.abs_diff(own) == sides - 1);
    let mine = distance(own);
    (0..sides).filter(|k| !beside(*k)).all(|k| {
        let theirs = distance(k);
        theirs > mine + margin || (theirs > mine - margin && own < k)
    })
}

/// Distance of a point from a side between two corners \[m\].
fn from_side(a: &Place<2>, b: &Place<2>, point: &Place<2>) -> f64 {
    let ([dx, dy], [x, y]) = ([b[0] - a[0], b[1] - a[1]], [point[0] - a[0], point[1] - a[1]]);
    let along = ((x * dx + y * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
    (x - along * dx).hypot(y - along * dy)
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

    /// Sills on a bed, 10 cells high, with walls four cells deep: from narrower than a depth to wider than two.
    #[test]
    fn a_narrow_obstacle_is_filled_once_and_nothing_stands_out_of_it() {
        for width in [1, 2, 3, 5, 6, 8, 11] {
            let (left, right) = (20.0, 20.0 + f64::from(width));
            let sill =
                [[0.0, 0.0], [left, 0.0], [left, 10.0], [right, 10.0], [right, 0.0], [right + 20.0, 0.0]];
            let found = points(&sill, false, 4.0);
            let width = i64::from(width);
            let filled = |x: i64, y: i64| x < 4 || width - x <= 4 || y >= 6;
            let cells = (0..width).flat_map(|x| (0..10).map(move |y| (x, y)));
            let wanted: Vec<_> =
                cells.filter(|(x, y)| filled(*x, *y)).map(|(x, y)| [2 * (x + 20) + 1, 2 * y + 1]).collect();
            let mut once = found.clone();
            once.dedup();
            assert_eq!(once, found, "{width}: twice");
            // Nothing but the sill stands above the bed.
            let above: Vec<_> = found.iter().filter(|p| p[1] > 0).copied().collect();
            assert_eq!(above, wanted, "{width}");
        }
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
