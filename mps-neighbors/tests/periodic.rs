//! Searches across the edges of a periodic box.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{Shape, brute_between, brute_within, cloud, plain, seeds, shape};
use mps_kernel::{Real, Vector};
use mps_neighbors::{Cells, Domain, NeighborError, Open, Parallel, PeriodicBox, Rows};
use proptest::prelude::*;

fn check<T: Real, const D: usize>(domain: PeriodicBox<T, D>, points: &[Vector<T, D>], reach: T) {
    let parallel = Parallel::serial();
    let (mut cells, mut rows) = (Cells::new(), Rows::default());
    cells.build(&parallel, &domain, points, reach).unwrap();
    rows.build_within(&parallel, &domain, &cells, points, reach).unwrap();
    assert_eq!(plain(&rows), brute_within(domain, points, reach));
    let (queries, targets) = points.split_at(points.len() / 3);
    cells.build(&parallel, &domain, targets, reach).unwrap();
    rows.build_between(&parallel, &domain, &cells, queries, targets, reach).unwrap();
    assert_eq!(plain(&rows), brute_between(domain, queries, targets, reach));
}

/// Boxes of two to many cells, from `lower` on; the last axis may stay open.
fn in_box<T: Real, const D: usize>(lower: f64, length: f64, open: bool) -> PeriodicBox<T, D> {
    let length = core::array::from_fn(|axis| (!open || axis + 1 < D).then_some(T::of(length)));
    PeriodicBox::new(Vector::repeat(T::of(lower)), length).unwrap()
}

fn any_box<T: Real, const D: usize>(
    s: &[[f64; 3]],
    shape: Shape,
    lower: f64,
    length: f64,
    open: bool,
    wrapped: bool,
) {
    let domain = in_box::<T, D>(lower, length, open);
    let far = matches!(shape, Shape::Flyer(far) if far.abs() > 1e7);
    let mut points = cloud::<T, D>(s, if far { Shape::Uniform } else { shape }, lower);
    if wrapped {
        for p in &mut points {
            *p = domain.wrap(*p);
        }
    }
    check(domain, &points, T::one());
}

proptest! {
    #[test]
    fn equals_all_pairs(
        s in seeds(),
        shape in shape(),
        length in prop_oneof![Just(2.0), Just(3.0), Just(4.0), 2.0..9.0],
        lower in proptest::sample::select(vec![0.0, -3.0, 1e3]),
        open: bool,
        wrapped: bool,
    ) {
        any_box::<f64, 2>(&s, shape, lower, length, open, wrapped);
        any_box::<f32, 2>(&s, shape, lower, length, open, wrapped);
        any_box::<f64, 3>(&s, shape, lower, length, open, wrapped);
        any_box::<f32, 3>(&s, shape, lower, length, open, wrapped);
    }

    #[test]
    fn separation_is_odd_and_short(a in -20.0..20.0, b in -20.0..20.0, length in 0.5..9.0) {
        let domain = in_box::<f64, 2>(-1.0, length, true);
        let (p, q) = (Vector::<f64, 2>::new(a, b), Vector::<f64, 2>::new(b, a));
        let d = domain.separation(&p, &q);
        prop_assert_eq!(d, -domain.separation(&q, &p));
        prop_assert!(d[0].abs() <= length / 2.0 * (1.0 + 1e-12));
        prop_assert_eq!(d[1], a - b);
        let images = (d[0] - (b - a)) / length;
        prop_assert!((images - images.round()).abs() < 1e-9, "moved by whole periods");
    }

    #[test]
    fn wrapping_lands_inside_and_stays(x in -1e3..1e3, lower in -5.0..5.0, length in 0.5..9.0) {
        let domain = in_box::<f64, 2>(lower, length, true);
        let p = domain.wrap(Vector::<f64, 2>::new(x, x));
        prop_assert!(p[0] >= lower && p[0] < lower + length);
        prop_assert_eq!(domain.wrap(p), p);
        prop_assert_eq!(p[1], x);
        let images = (p[0] - x) / length;
        prop_assert!((images - images.round()).abs() < 1e-9, "moved by whole periods");
    }
}

/// A particle one rounding below the lower end wraps to the upper end itself, which is outside.
fn at_the_edges<T: Real>(lower: f64, length: f64, next: impl Fn(T) -> T, before: impl Fn(T) -> T) {
    let domain = in_box::<T, 2>(lower, length, false);
    let (low, high) = (T::of(lower), T::of(lower) + T::of(length));
    let reach = T::of(length / 3.0);
    let mut ends = Vec::new();
    for edge in [low, high, low + reach, high - reach, low + reach + reach, T::of(lower + length / 2.0)] {
        ends.extend([before(before(edge)), before(edge), edge, next(edge), next(next(edge))]);
    }
    let points: Vec<Vector<T, 2>> = ends
        .iter()
        .flat_map(|&x| {
            ends.iter().step_by(4).map(move |&y| Vector::from_fn(|axis, _| if axis == 0 { x } else { y }))
        })
        .collect();
    check(domain, &points, reach);
    let wrapped: Vec<_> = points.iter().map(|&p| domain.wrap(p)).collect();
    assert!(wrapped.iter().all(|p| p.iter().all(|&x| x >= low && x < high)));
    check(domain, &wrapped, reach);
}

#[test]
fn floats_next_to_the_edges() {
    for (lower, length) in [(0.0, 1.0), (-0.3, 0.7), (1e3, 3.0), (-1e3, 0.9)] {
        at_the_edges::<f64>(lower, length, f64::next_up, f64::next_down);
        at_the_edges::<f32>(lower, length, f32::next_up, f32::next_down);
    }
}

#[test]
fn boxes_that_make_no_sense_are_refused() {
    for length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let result = PeriodicBox::new(Vector::<f64, 2>::zeros(), [None, Some(length)]);
        assert!(matches!(result, Err(NeighborError::Period { axis: 1, .. })), "length {length}");
    }
    let (parallel, mut cells) = (Parallel::serial(), Cells::new());
    let points = [Vector::<f64, 2>::zeros()];
    assert_eq!(
        cells.build(&parallel, &in_box(0.0, 1.9, true), &points, 1.0),
        Err(NeighborError::ShortPeriod { axis: 0, length: 1.9, size: 1.0 })
    );
    let far = [Vector::<f64, 2>::new(1e12, 0.0)];
    assert_eq!(
        cells.build(&parallel, &in_box(0.0, 4.0, true), &far, 1.0),
        Err(NeighborError::TooFar { particle: 0, axis: 0, value: 1e12, length: 4.0 })
    );
    cells.build(&parallel, &in_box(0.0, 4.0, true), &points, 1.0).unwrap();
    let other = Rows::default().build_within(&parallel, &Open, &cells, &points, 1.0);
    assert_eq!(other, Err(NeighborError::OtherDomain));
}
