//! The surface of bodies of known shape is found, with its normals, in the plane and in space.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{lattice, rubber};
use mps_coupling::{CouplingError, Fixed, Interface, Scene, Structure};
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidParticles, Slip};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Open, Parallel};

const L0: f64 = 0.01;

/// The points of a lattice that are `inside`, in units of the spacing, and what is found of them.
fn registered<const D: usize>(
    counts: [usize; D],
    inside: impl Fn(&Vector<f64, D>) -> bool,
) -> (Vec<Vector<f64, D>>, Interface<f64, D>) {
    let points: Vec<_> = lattice([0.0; D], counts, L0).into_iter().filter(|r| inside(&(r / L0))).collect();
    let interface = Interface::register(&Parallel::serial(), &points, &Vector::repeat(L0), 3.1 * L0).unwrap();
    (points, interface)
}

/// On which sides of the box a point is: -1, 0 or 1 along each axis.
fn sides<const D: usize>(r: &Vector<f64, D>, counts: [usize; D]) -> Vector<f64, D> {
    Vector::from_fn(|axis, _| match (r[axis] / L0) as usize {
        0 => -1.0,
        k if k + 1 == counts[axis] => 1.0,
        _ => 0.0,
    })
}

/// A box whose points lie closer along some axes than along others.
fn a_stretched_box_is_found<const D: usize>(counts: [usize; D], spacing: [f64; D]) {
    let upper = core::array::from_fn(|axis| counts[axis] as f64 * spacing[axis]);
    let body = rubber([0.0; D], upper, counts, &[], 1e6);
    let points = body.positions();
    let serial = Parallel::serial();
    let interface = Interface::register(&serial, points, &body.spacings(), 3.1 * body.spacing()).unwrap();
    for (i, r) in points.iter().enumerate() {
        let at = |axis: usize| (r[axis] / spacing[axis]) as usize;
        let sides = Vector::<f64, D>::from_fn(|axis, _| match at(axis) {
            0 => -1.0,
            k if k + 1 == counts[axis] => 1.0,
            _ => 0.0,
        });
        let kind = sides.iter().filter(|side| **side != 0.0).count();
        assert_eq!(interface.surface[i], kind > 0, "{spacing:?}: {sides}");
        let clear = (0..D).all(|axis| sides[axis] != 0.0 || (2..counts[axis] - 2).contains(&at(axis)));
        if kind == 1 && clear {
            let defect = (interface.normal[i] - sides).norm();
            assert!(defect < 1e-12, "{spacing:?}, {sides}: {}", interface.normal[i]);
        }
    }
}

/// A plate whose thickness is no whole number of its spacings once had no surface, and the water ran through it.
#[test]
fn boxes_of_unequal_spacings_have_the_surface_of_those_of_equal_ones() {
    for thin in [0.9, 0.8, 0.6, 0.3] {
        a_stretched_box_is_found([20, 6], [L0, thin * L0]);
        a_stretched_box_is_found([20, 2], [L0, thin * L0]);
        a_stretched_box_is_found([9, 8, 7], [L0, thin * L0, L0]);
        a_stretched_box_is_found([9, 8, 3], [L0, thin * L0, thin * L0]);
    }
}

#[test]
fn a_spacing_that_is_not_that_of_the_points_is_refused() {
    let points = lattice([0.0; 2], [12, 9], L0);
    let register = |spacing: [f64; 2]| {
        Interface::register(&Parallel::serial(), &points, &Vector::from(spacing), 3.1 * L0)
    };
    for wrong in [[1.5 * L0; 2], [L0, 1.5 * L0]] {
        let error = register(wrong).unwrap_err();
        assert!(matches!(error, CouplingError::Crowded { density, .. } if density > 1.3), "{error}");
    }
    assert!(register([1.01 * L0; 2]).is_ok());
}

/// Faces, edges and corners, with the normals that symmetry gives them where no other edge is near.
fn a_box_is_found<const D: usize>(counts: [usize; D]) {
    let (points, interface) = registered(counts, |_| true);
    let mut kinds = [0; 4];
    for (i, r) in points.iter().enumerate() {
        let sides = sides(r, counts);
        let kind = sides.iter().filter(|side| **side != 0.0).count();
        assert_eq!(interface.surface[i], kind > 0, "{sides}");
        let at = |axis: usize| (r[axis] / L0) as usize;
        let clear = (0..D).all(|axis| sides[axis] != 0.0 || (2..counts[axis] - 2).contains(&at(axis)));
        if kind > 0 && clear {
            let defect = (interface.normal[i] - sides.normalize()).norm();
            assert!(defect < 1e-12, "{sides}: {}", interface.normal[i]);
            kinds[kind] += 1;
        }
    }
    assert!(kinds[1..=D].iter().all(|&found| found > 0) && kinds[D] == 1 << D, "{kinds:?}");
}

#[test]
fn boxes_have_their_faces_edges_and_corners_as_surface() {
    a_box_is_found([12, 9]);
    a_box_is_found([9, 7, 8]);
}

/// The last layer is surface wherever the centre lies (layers across the diagonal are `1/sqrt(D)` apart), what has two layers around it is
/// not, and normals point away from the centre.
fn a_ball_is_found<const D: usize>(radius: f64, shift: f64) {
    let center = Vector::<f64, D>::from_fn(|axis, _| 10.0 + shift * (axis as f64 + 1.0));
    let (points, interface) = registered([20; D], |r| (r - center).norm() < radius);
    let (mut turned, mut count) = (0.0, 0.0);
    let layer = 0.99 / (D as f64).sqrt();
    for (i, r) in points.iter().enumerate() {
        let out = r / L0 - center;
        let depth = radius - out.norm();
        assert!(depth > layer || interface.surface[i], "{D}D, radius {radius}, depth {depth}");
        assert!(depth < 2.0 || !interface.surface[i], "{D}D, radius {radius}, depth {depth}");
        if interface.surface[i] {
            let angle = interface.normal[i].dot(&out.normalize()).clamp(-1.0, 1.0).acos().to_degrees();
            assert!(angle < 40.0, "{D}D, radius {radius}: {angle} degrees");
            turned += angle;
            count += 1.0;
        }
    }
    assert!(turned / count < 15.0, "{D}D, radius {radius}: {} degrees on the mean", turned / count);
}

#[test]
fn balls_have_their_last_layer_as_surface_wherever_they_lie() {
    for (radius, shift) in [(6.3, 0.0), (6.0, 0.17), (7.7, 0.31), (9.2, 0.05)] {
        a_ball_is_found::<2>(radius, shift);
        a_ball_is_found::<3>(radius, shift);
    }
}

#[test]
fn a_cylinder_has_its_mantle_and_its_ends_as_surface() {
    let (radius, length) = (6.4, 12);
    let off = |r: &Vector<f64, 3>| Vector::<f64, 3>::new(r.x - 8.1, r.y - 7.8, 0.0);
    let (points, interface) = registered([16, 16, length], |r| off(r).norm() < radius);
    for (i, r) in points.iter().enumerate() {
        let r = r / L0;
        let (depth, layer) = (radius - off(&r).norm(), r.z as usize);
        let end = layer == 0 || layer + 1 == length;
        assert!(!(end || depth < 0.7) || interface.surface[i], "depth {depth}, layer {layer}");
        assert!(end || depth < 2.0 || !interface.surface[i], "depth {depth}, layer {layer}");
        if end && depth > 3.0 {
            assert!((interface.normal[i].z.abs() - 1.0).abs() < 1e-12, "{}", interface.normal[i]);
        }
        if interface.surface[i] && (3..length - 3).contains(&layer) {
            assert!(interface.normal[i].z.abs() < 1e-12, "mantle: {}", interface.normal[i]);
        }
    }
}

/// Only the ends of a plate two points thick were once found. Along the last axis.
fn plates_are_found<const D: usize>() {
    for layers in 1..=3 {
        let mut counts = [12; D];
        counts[D - 1] = layers;
        let (points, interface) = registered(counts, |_| true);
        assert_eq!(interface.visible.len(), points.len(), "{layers} layers: the fluid sees all of them");
        for (i, r) in points.iter().enumerate() {
            let sides = sides(r, counts);
            let rim = (0..D - 1).any(|axis| sides[axis] != 0.0);
            let inside = layers == 3 && sides[D - 1] == 0.0 && !rim;
            assert_eq!(interface.surface[i], !inside, "{D}D, {layers} layers: {sides}");
            let middle = (0..D - 1).all(|axis| (2.0..10.0).contains(&(r[axis] / L0)));
            if middle {
                let normal = Vector::from_fn(|axis, _| f64::from(axis == D - 1) * sides[axis]);
                // Of a single layer both sides are outward.
                let expected = if layers == 1 { Vector::zeros() } else { normal };
                let defect = (interface.normal[i] - expected).norm();
                assert!(defect < 1e-12, "{D}D, {layers} layers: {}", interface.normal[i]);
            }
        }
    }
}

#[test]
fn plates_of_one_and_two_layers_are_all_surface_and_of_three_have_an_inside() {
    plates_are_found::<2>();
    plates_are_found::<3>();
}

/// Behind an inner edge no side is open; the points beside it are surface up to the edge.
fn an_inner_edge_is_found<const D: usize>() {
    let out = |r: &Vector<f64, D>| r[0] > 6.0 && r[1] > 6.0;
    let (points, interface) = registered([12; D], |r| !out(r));
    for (i, r) in points.iter().enumerate() {
        let r = r / L0;
        let box_side = (0..D).any(|axis| !(1.0..11.0).contains(&r[axis]));
        let beside = (5.0..6.0).contains(&r[0]) && r[1] > 6.0 || (5.0..6.0).contains(&r[1]) && r[0] > 6.0;
        assert_eq!(interface.surface[i], box_side || beside, "{D}D: {r}");
    }
}

#[test]
fn inner_edges_belong_to_the_inside() {
    an_inner_edge_is_found::<2>();
    an_inner_edge_is_found::<3>();
}

#[test]
fn the_inside_of_a_thick_body_is_not_shown_to_the_fluid() {
    let (points, interface) = registered([20; 2], |_| true);
    assert_eq!(points.len() - interface.visible.len(), 12_usize.pow(2), "four layers deep are visible");
    let (points, interface) = registered([12; 3], |_| true);
    assert_eq!(points.len() - interface.visible.len(), 4_usize.pow(3), "in space as well");
}

/// A post of 4 x 4 x 14 points stands in water of 12 x 12 x 6 particles, one particle above its bottom.
#[test]
fn the_wet_part_of_a_post_is_what_stands_in_the_water() {
    let parallel = Parallel::serial();
    let post =
        |r: &Vector<f64, 3>| [r.x, r.y].iter().all(|x| (4.0..8.0).contains(&(x / L0))) && r.z > 1.0 * L0;
    let water = lattice([0.0; 3], [12, 12, 6], L0).into_iter().filter(|r| !post(r)).collect();
    let config = FluidConfig::water(L0, 10.0);
    let particles = FluidParticles::at_rest(water);
    let fluid = Fluid::new(config, Rational, |_| (), Open, particles, Boundary::default()).unwrap();
    let mut scene: Scene<f64, 3> = Scene::new(fluid);
    let points = lattice([4.0 * L0, 4.0 * L0, 1.0 * L0], [4, 4, 14], L0);
    let volumes = vec![L0.powi(3); points.len()];
    let body = Fixed::new(points.clone(), volumes, L0);
    scene.add_structure(&parallel, Box::new(body), Slip::Free).unwrap();
    scene.step(&parallel, f64::INFINITY).unwrap();
    scene.update_interfaces(&parallel);
    let interface = scene.interface(0).unwrap();
    for (i, r) in points.iter().enumerate() {
        let layer = (r.z / L0) as usize;
        let side = [r.x, r.y].iter().any(|x| !(5.0..7.0).contains(&(x / L0)));
        // The water ends with layer 5; seen from layer 8 three spacings up, inside the effective radius of 3.1.
        let expected = interface.surface[i] && (layer <= 7 && side || layer == 1);
        assert_eq!(interface.wetted[i], expected, "{r}, {} particles around it", scene.fluid().contacts(i));
    }
    assert!(interface.wetted_count() > 80);
}
