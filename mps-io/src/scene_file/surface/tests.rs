use super::*;
use crate::scene_file::{Disc, HalfSpace, Tube};

fn cube<const D: usize>(lower: [f64; D], upper: [f64; D]) -> Region {
    Region::between(lower, upper)
}

fn circle(x: f64, y: f64, radius: f64) -> Region {
    Region::Circle(Disc { center: vec![x, y], radius })
}

/// Depth at a place, after a look whether the foot is as far away as it says.
fn depth(region: &Region, point: &[f64]) -> f64 {
    let Foot { place: foot, depth } = region.surface().unwrap().nearest(point).unwrap();
    let off = (place(point) - Place::from(foot)).norm();
    assert!((off - depth.abs()).abs() < 1e-12, "{foot:?} is {off} away, not {depth}");
    depth
}

fn assert_depths<const D: usize>(region: &Region, wanted: &[([f64; D], f64)]) {
    for (point, wanted) in wanted {
        let found = depth(region, point);
        assert!((found - wanted).abs() < 1e-8, "{point:?}: {found}, not {wanted}");
    }
}

#[test]
fn simple_shapes_have_the_distances_of_their_formulas() {
    let root = 2.0_f64.sqrt();
    assert_depths(
        &cube([0.0, 0.0], [2.0, 1.0]),
        &[([1.0, 0.4], 0.4), ([1.8, 0.5], 0.2), ([3.0, 2.0], -root)],
    );
    assert_depths(&circle(1.0, 1.0, 0.5), &[([1.0, 1.0], 0.5), ([1.3, 1.4], 0.0), ([1.6, 1.8], -0.5)]);
    let tip = Region::Polygon(vec![vec![0.0, 0.0], vec![1.0, 0.0], vec![0.0, 1.0]]);
    assert_depths(&tip, &[([0.25, 0.25], 0.25), ([1.0, 1.0], -0.5 * root), ([0.1, 0.4], 0.1)]);
    let ball = Region::Ball(Disc { center: vec![0.0; 3], radius: 1.0 });
    assert_depths(&ball, &[([0.0, 0.6, 0.0], 0.4), ([2.0, 2.0, 1.0], -2.0)]);
    let tube = Region::Cylinder(Tube { from: vec![0.0; 3], to: vec![0.0, 2.0, 0.0], radius: 0.5 });
    let outside = -0.5 * root;
    assert_depths(&tube, &[([0.0, 1.0, 0.0], 0.5), ([0.1, 0.2, 0.0], 0.2), ([1.0, 2.5, 0.0], outside)]);
    assert_depths(
        &cube([0.0; 3], [1.0, 2.0, 3.0]),
        &[([0.5, 1.0, 2.9], 0.1), ([2.0, 3.0, 4.0], -3.0_f64.sqrt())],
    );
}

/// Parts that touch or overlap have nothing of their surfaces left where they do: the depth is not that of the deeper part.
#[test]
fn a_union_has_no_surface_inside() {
    let touching = Region::Union(vec![cube([0.0, 0.0], [1.0, 1.0]), cube([1.0, 0.0], [2.0, 1.0])]);
    assert_depths(&touching, &[([1.0, 0.5], 0.5), ([0.9, 0.4], 0.4), ([0.7, 0.7], 0.3)]);
    let tee = Region::Union(vec![cube([0.0, 0.0], [2.0, 1.0]), cube([0.0, 0.0], [1.0, 2.0])]);
    assert_depths(
        &tee,
        &[([0.5, 0.8], 0.5), ([0.6, 0.8], 0.2_f64.sqrt()), ([0.7, 0.6], 0.5), ([0.8, 0.5], 0.5)],
    );
    assert_depths(
        &tee,
        &[([1.2, 1.5], -0.2), ([1.0 - 0.2, 1.0 - 0.5], 0.5), ([0.95, 0.95], 0.05 * 2.0_f64.sqrt())],
    );
    // Two discs that cross at (0, -0.6) and (0, 0.6).
    let lens = Region::Union(vec![circle(-0.8, 0.0, 1.0), circle(0.8, 0.0, 1.0)]);
    assert_depths(
        &lens,
        &[([0.0, 0.0], 0.6), ([0.1, 0.0], 0.37_f64.sqrt()), ([0.0, 1.0], 1.0 - 1.64_f64.sqrt())],
    );
}

#[test]
fn a_difference_ends_where_something_was_taken_away() {
    let ring = Region::Difference(vec![circle(0.0, 0.0, 1.0), circle(0.0, 0.0, 0.4)]);
    assert_depths(&ring, &[([0.7, 0.0], 0.3), ([0.0, 0.5], 0.1), ([0.1, 0.0], -0.3), ([0.0, 1.5], -0.5)]);
    let half = HalfSpace { through: vec![0.0, 0.0, 0.0], toward: vec![0.0, 3.0, 0.0] };
    let ball = Region::Ball(Disc { center: vec![0.0; 3], radius: 1.0 });
    let bowl = Region::Difference(vec![ball, Region::HalfSpace(half)]);
    // Above the flat side, beyond its rim, and below.
    assert_depths(&bowl, &[([0.5, 0.3, 0.0], -0.3), ([0.0, -0.2, 0.1], 0.2), ([0.0, -0.9, 0.0], 0.1)]);
    assert_depths(&bowl, &[([2.0, 0.0, 0.0], -1.0), ([1.5, 0.5, 0.0], -0.5_f64.sqrt())]);
    // A notch, whose corners point into what is left.
    let notch = Region::Difference(vec![cube([0.0, 0.0], [3.0, 2.0]), cube([1.0, 1.0], [2.0, 3.0])]);
    assert_depths(
        &notch,
        &[([0.7, 0.6], 0.5), ([1.5, 0.8], 0.2), ([1.5, 1.9], -0.5), ([1.5, 2.5], -0.5_f64.hypot(0.5))],
    );
}

/// Against the least distance to many points of the surface, found by walking along rays.
#[test]
fn a_heap_of_shapes_is_as_far_as_its_nearest_point() {
    let heap = Region::Difference(vec![
        Region::Union(vec![
            cube([0.0, 0.0], [2.0, 1.0]),
            circle(2.0, 0.9, 0.5),
            Region::Polygon(vec![vec![0.2, 0.8], vec![1.1, 0.9], vec![0.5, 1.7]]),
        ]),
        circle(1.0, 0.0, 0.4),
        Region::HalfSpace(HalfSpace { through: vec![2.3, 0.0], toward: vec![1.0, -0.3] }),
    ]);
    let surface = heap.surface().unwrap();
    let (n, width) = (240, 0.0125);
    let at = |k: usize| [(k % n) as f64 * width - 0.25, (k / n) as f64 * width - 0.5];
    let inside: Vec<bool> = (0..n * n).map(|k| heap.contains(&at(k), 0.0)).collect();
    for k in (0..n * n).step_by(331) {
        let point = at(k);
        let found = surface.nearest(&point).unwrap().depth;
        assert_eq!(found > 0.0, inside[k]);
        // The nearest place of the lattice that is on the other side is at most a cell beyond the surface.
        let other = (0..n * n).filter(|j| inside[*j] != inside[k]);
        let least =
            other.map(|j| (at(j)[0] - point[0]).hypot(at(j)[1] - point[1])).fold(f64::INFINITY, f64::min);
        assert!(
            found.abs() <= least + 1e-9 && found.abs() >= least - 1.5 * width,
            "{point:?}: {found}, {least}"
        );
    }
}

/// Shapes that cross at 18 degrees: going from one to the other and back alone comes nowhere near.
#[test]
fn a_flat_hump_has_its_corner() {
    let hump = Region::Union(vec![cube([0.0, 0.0], [4.0, 1.0]), circle(2.0, -3.0, 4.2)]);
    let corner = [2.0 - 1.64_f64.sqrt(), 1.0];
    let bisector = [0.154, -0.988];
    let length = f64::hypot(bisector[0], bisector[1]);
    for away in [0.02, 0.05, 0.1, 0.2] {
        let place = [0, 1].map(|axis| corner[axis] + away * bisector[axis] / length);
        let found = depth(&hump, &place);
        assert!((found - away).abs() < 1e-7, "{found}, not {away}");
    }
}
