//! The gap between neighbours is the largest angle, in space the largest cone, in which nobody stands.

use crate::common::{Noise, lattice};
use core::f64::consts::PI;
use mps_fluid::surface::{GAP_LIMIT, has_gap, largest_gap};
use mps_kernel::Vector;

#[test]
fn the_largest_gap_is_the_angle_nobody_stands_in() {
    let at = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Vector::<f64, 2>::new(cos, sin)
    };
    let gap = |angles: &[f64]| largest_gap(&angles.iter().map(|&a| at(a)).collect::<Vec<_>>()).to_degrees();
    assert_eq!(gap(&[]), 360.0);
    assert!((gap(&[77.0]) - 360.0).abs() < 1e-9);
    assert!((gap(&[0.0, 90.0, 180.0, 270.0]) - 90.0).abs() < 1e-9);
    assert!((gap(&[170.0, -170.0, 30.0]) - 200.0).abs() < 1e-9, "from -170 on, not from 170");
    assert!((gap(&[-100.0, 0.0, 100.0]) - 160.0).abs() < 1e-9, "across the cut of atan2");
    // A turn of everything changes nothing.
    for turn in [13.0, 95.0, 180.0, 271.0] {
        assert!((gap(&[turn, turn + 50.0, turn + 200.0]) - 160.0).abs() < 1e-9);
    }
}

/// Share of the full solid angle of a cone of this half-angle \[rad\].
fn share(half: f64) -> f64 {
    0.5 * (1.0 - half.cos())
}

/// Whether the largest cone has this half-angle, to a thousandth of a radian, wherever one looks first.
fn opens(neighbors: &[Vector<f64, 3>], half: f64) -> bool {
    [Vector::zeros(), Vector::x(), -Vector::<f64, 3>::y()].iter().all(|lean| {
        has_gap(neighbors, lean, share(half - 1e-3)) && !has_gap(neighbors, lean, share(half + 1e-3))
    })
}

/// The neighbours of a point of a lattice, those of them that are inside.
fn neighbors(inside: impl Fn(&Vector<f64, 3>) -> bool) -> Vec<Vector<f64, 3>> {
    let ball = |r: &Vector<f64, 3>| r.norm() > 0.5 && r.norm() < 2.1;
    lattice::<f64, 3>([-2.5; 3], [5; 3], 1.0).into_iter().filter(|r| ball(r) && inside(r)).collect()
}

#[test]
fn faces_edges_and_corners_have_the_cones_of_their_geometry() {
    let quarter = 0.5 * PI;
    assert!(opens(&neighbors(|r| r.z < 0.5), quarter), "a face");
    assert!(opens(&neighbors(|r| r.x + r.y + r.z < 0.5), quarter), "a face across the lattice");
    // Whoever stands on the edge itself leaves no more than a face does.
    assert!(opens(&neighbors(|r| r.z < 0.5 && r.x > -0.5), quarter), "an edge");
    let corner = PI - (1.0 / 3.0_f64.sqrt()).acos();
    assert!(opens(&neighbors(|r| r.iter().all(|x| *x < 0.5)), corner), "a corner");
    assert!(opens(&neighbors(|r| r.z.abs() < 0.5), quarter), "a sheet");
    assert!(opens(&neighbors(|r| r.x.abs() + r.y.abs() < 0.5), quarter), "a thread");
    let end = neighbors(|r| r.x.abs() + r.y.abs() < 0.5 && r.z > 0.0);
    assert!(has_gap(&end, &Vector::zeros(), 1.0 - 1e-5), "the end of a thread");
    assert!(opens(&[Vector::x(), Vector::y()], 0.75 * PI), "two at a right angle");
    // The hole in the middle of (1 0 0), (1 1 0) and (1 1 1), equally far from the three.
    let middle = Vector::<f64, 3>::new(1.0, 2.0_f64.sqrt() - 1.0, 3.0_f64.sqrt() - 2.0_f64.sqrt());
    assert!(opens(&neighbors(|_| true), (1.0 / middle.norm()).acos()), "all around");
}

#[test]
fn a_missing_neighbour_and_an_inner_edge_are_no_gaps() {
    let found =
        |inside: &dyn Fn(&Vector<f64, 3>) -> bool| has_gap(&neighbors(inside), &Vector::zeros(), GAP_LIMIT);
    assert!(!found(&|_| true));
    assert!(!found(&|r| r.y.abs() + r.z.abs() > 0.5 || r.x < 0.0), "those along an axis");
    assert!(!found(&|r| r.x < 0.5 || r.y < 0.5), "a quarter of the space");
    assert!(found(&|r| r.x + r.y < 0.5), "half of it");
    assert!(has_gap::<f64, 3>(&[], &Vector::zeros(), 0.99));
    assert!(has_gap(&[Vector::<f32, 3>::z()], &Vector::zeros(), 0.99));
}

/// Against forty thousand axes tried one by one.
#[test]
fn in_a_random_cloud_the_largest_cone_is_found() {
    let axes: Vec<_> = (0..40_000)
        .map(|k| {
            // Evenly over the sphere, along a spiral.
            let (z, turn) = (1.0 - (f64::from(k) + 0.5) / 20_000.0, 2.399_963_229_728_653 * f64::from(k));
            let ring = (1.0 - z * z).sqrt();
            Vector::<f64, 3>::new(ring * turn.cos(), ring * turn.sin(), z)
        })
        .collect();
    let mut noise = Noise::new(17);
    for count in [2, 3, 4, 7, 12, 20, 50] {
        for _ in 0..4 {
            let cloud: Vec<Vector<f64, 3>> = (0..count).map(|_| noise.vector(1.0)).collect();
            let nearest = |axis: &Vector<f64, 3>| {
                cloud.iter().map(|r| r.dot(axis) / r.norm()).fold(-1.0, f64::max).clamp(-1.0, 1.0).acos()
            };
            let widest = axes.iter().map(nearest).fold(0.0, f64::max);
            // The axes are a hundredth of a radian apart.
            assert!(has_gap(&cloud, &Vector::zeros(), share(widest - 1e-3)), "{count}: {widest}");
            assert!(!has_gap(&cloud, &Vector::zeros(), share((widest + 0.015).min(PI))), "{count}: {widest}");
        }
    }
}
