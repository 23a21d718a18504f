//! Every search equals trying all pairs.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{Shape, brute_between, brute_within, cloud, jittered, plain, seeds, shape};
use mps_kernel::{Real, Vector};
use mps_neighbors::{Cells, NeighborError, Open, Parallel, Permutation, Rows};
use proptest::prelude::*;

/// Searches within `points` in the order they have and in spatial order.
fn check_within<T: Real, const D: usize>(mut points: Vec<Vector<T, D>>, size: f64, reach: f64) {
    let (parallel, size, reach) = (Parallel::serial(), T::of(size), T::of(reach));
    let (mut cells, mut rows) = (Cells::new(), Rows::default());
    cells.build(&parallel, &Open, &points, size).unwrap();
    rows.build_within(&parallel, &Open, &cells, &points, reach).unwrap();
    let expected = brute_within(Open, &points, reach);
    assert_eq!(plain(&rows), expected);
    assert_eq!(rows.pairs(), expected.iter().map(Vec::len).sum::<usize>());
    for i in 0..rows.len() {
        assert!(rows.row(i).is_sorted_by(|a, b| a < b), "row {i} ascends");
        for &j in rows.row(i) {
            assert!(rows.row(j as usize).contains(&(i as u32)), "{j} sees {i} as well");
        }
    }

    Permutation::default().apply_to(&mut points, cells.order()).unwrap();
    cells.settle();
    rows.build_within(&parallel, &Open, &cells, &points, reach).unwrap();
    assert_eq!(plain(&rows), brute_within(Open, &points, reach));
    // What is sorted is found to be sorted: building again gives the same order.
    cells.build(&parallel, &Open, &points, size).unwrap();
    assert!(cells.order().is_sorted());
}

fn check_between<T: Real, const D: usize>(queries: &[Vector<T, D>], targets: &[Vector<T, D>], reach: f64) {
    let (parallel, reach) = (Parallel::serial(), T::of(reach));
    let (mut cells, mut rows, mut back) = (Cells::new(), Rows::default(), Rows::default());
    cells.build(&parallel, &Open, targets, reach).unwrap();
    rows.build_between(&parallel, &Open, &cells, queries, targets, reach).unwrap();
    assert_eq!(plain(&rows), brute_between(Open, queries, targets, reach));
    back.transpose_of(&rows, targets.len()).unwrap();
    assert_eq!(plain(&back), brute_between(Open, targets, queries, reach));
}

fn offset() -> impl Strategy<Value = f64> {
    proptest::sample::select(vec![0.0, 1e6, -1e6])
}

proptest! {
    #[test]
    fn within_2d(s in seeds(), shape in shape(), offset in offset(), reach in 0.5..1.0) {
        check_within::<f64, 2>(cloud(&s, shape, offset), 1.0, 1.0);
        check_within::<f64, 2>(cloud(&s, shape, offset), 1.0, reach);
        check_within::<f32, 2>(cloud(&s, shape, offset), 1.0, 1.0);
    }

    #[test]
    fn within_3d(s in seeds(), shape in shape(), offset in offset(), reach in 0.1..2.0) {
        check_within::<f64, 3>(cloud(&s, shape, offset), 2.0, 2.0);
        check_within::<f64, 3>(cloud(&s, shape, offset), 2.0, reach);
        check_within::<f32, 3>(cloud(&s, shape, offset), 2.0, 2.0);
    }

    #[test]
    fn between_two_sets(a in seeds(), b in seeds(), here in shape(), there in shape(), offset in offset()) {
        check_between::<f64, 2>(&cloud(&a, here, offset), &cloud(&b, there, offset), 1.0);
        check_between::<f32, 2>(&cloud(&a, here, offset), &cloud(&b, there, offset), 1.0);
        check_between::<f64, 3>(&cloud(&a, here, offset), &cloud(&b, there, offset), 2.0);
        check_between::<f32, 3>(&cloud(&a, here, offset), &cloud(&b, there, offset), 2.0);
    }
}

/// Several blocks of rows, and grids in which every cell is occupied.
#[test]
fn lattices_of_many_blocks() {
    check_within::<f64, 2>(jittered(40, 3), 3.3, 3.3);
    check_within::<f64, 3>(jittered(12, 4), 2.1, 2.1);
    check_between::<f64, 2>(&jittered(30, 5), &jittered(30, 6), 3.3);
}

/// A dense table over the bounding box would have asked for 10^12 cells and more.
#[test]
fn memory_depends_on_the_number_of_particles_alone() {
    let mut random = common::Random(1);
    let s: Vec<[f64; 3]> = (0..3000).map(|_| core::array::from_fn(|_| random.next())).collect();
    let bytes = |far: f64| {
        let points = cloud::<f64, 3>(&s, Shape::Flyer(far), 0.0);
        let mut cells = Cells::new();
        cells.build(&Parallel::serial(), &Open, &points, 0.5).unwrap();
        cells.bytes()
    };
    for far in [0.0, 1e6, -1e6, 1e12, -1e12, 1e300] {
        assert!(bytes(far) < 64 * s.len() + 4096, "{} bytes with a particle {far} m away", bytes(far));
    }
}

#[test]
fn positions_that_are_no_numbers_are_named() {
    let mut points = cloud::<f64, 2>(&[[0.5; 3]; 9], Shape::Uniform, 0.0);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        points[7][1] = bad;
        let mut cells = Cells::new();
        match cells.build(&Parallel::serial(), &Open, &points, 1.0) {
            Err(NeighborError::NotFinite { particle: 7, axis: 1, value }) => {
                assert!(value == bad || value.is_nan() && bad.is_nan());
            }
            other => panic!("{other:?}"),
        }
        assert!(cells.is_empty());
    }
}

#[test]
fn misuse_is_an_error() {
    let parallel = Parallel::serial();
    let points = cloud::<f64, 2>(&[[0.1; 3], [0.9; 3]], Shape::Uniform, 0.0);
    let mut moved = points.clone();
    moved[1][0] += 0.5;
    let (mut cells, mut rows) = (Cells::new(), Rows::default());
    for size in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(cells.build(&parallel, &Open, &points, size), Err(NeighborError::Size(_))));
    }
    cells.build(&parallel, &Open, &points, 1.0).unwrap();
    assert_eq!(
        rows.build_within(&parallel, &Open, &cells, &points, 1.1),
        Err(NeighborError::Reach { reach: 1.1, size: 1.0 })
    );
    assert_eq!(
        rows.build_within(&parallel, &Open, &cells, &moved, 1.0),
        Err(NeighborError::Stale { particle: 1 })
    );
    assert_eq!(
        rows.build_within(&parallel, &Open, &cells, &points[..1], 1.0),
        Err(NeighborError::Stale { particle: 1 })
    );
    moved[0][1] = f64::NAN;
    assert!(matches!(
        rows.build_between(&parallel, &Open, &cells, &moved, &points, 1.0),
        Err(NeighborError::NotFinite { particle: 0, axis: 1, .. })
    ));
    assert!(rows.is_empty());
    rows.build_within(&parallel, &Open, &cells, &points, 1.0).unwrap();
    assert!(rows.len() == 2);
}

#[test]
fn transposing_into_too_small_a_set_is_an_error() {
    let points = [Vector::<f64, 2>::zeros(); 3];
    let (parallel, mut cells, mut rows, mut back) =
        (Parallel::serial(), Cells::new(), Rows::default(), Rows::default());
    cells.build(&parallel, &Open, &points, 1.0).unwrap();
    rows.build_within(&parallel, &Open, &cells, &points, 1.0).unwrap();
    assert_eq!(back.transpose_of(&rows, 2), Err(NeighborError::NoTarget { row: 0, particle: 2, targets: 2 }));
    back.transpose_of(&rows, 5).unwrap();
    assert_eq!(plain(&back), [vec![1, 2], vec![0, 2], vec![0, 1], vec![], vec![]]);
}
