//! Rows and trying all pairs are the same neighbourhood.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::jittered;
use fearless_simd::{Level, dispatch};
use mps_kernel::weights::{Rational, WendlandC2};
use mps_kernel::{F64Lanes, Kernel, Lanes, Neighborhood, Pair, Vector};
use mps_neighbors::{BruteForce, Cells, Open, Parallel, PeriodicBox, Placed, RowView, Rows};

fn sums<K: Kernel<f64>>(kernel: K) {
    let (points, radius, skin) = (jittered::<2>(20, 3), 2.1, 0.2);
    let domain = PeriodicBox::new(Vector::repeat(-0.5), [Some(20.0), None]).unwrap();
    let (parallel, mut cells, mut rows) = (Parallel::serial(), Cells::new(), Rows::default());
    cells.build(&parallel, &domain, &points, radius + skin).unwrap();
    rows.build_within(&parallel, &domain, &cells, &points, radius + skin).unwrap();
    let view = RowView { rows: &rows, points: &points, targets: &points, kernel, radius, domain };
    let brute = BruteForce::within(domain, &points, kernel, radius);
    assert_eq!(view.len(), brute.len());
    let mut in_skin = 0;
    for i in 0..view.len() {
        let (mut seen, mut expected) = (Vec::new(), Vec::new());
        view.for_each(i, |pair| {
            if pair.distance() < radius {
                seen.push(*pair);
            } else {
                assert_eq!((pair.weight, pair.over_r2), (0.0, 0.0));
                in_skin += 1;
            }
        });
        brute.for_each(i, |pair| expected.push(*pair));
        assert_eq!(seen, expected);
        assert_eq!(in_packs(&view, i, radius), expected);
    }
    assert!(in_skin > 0);
}

struct Beside {
    place: Vector<f64, 2>,
    _number: f64,
}

impl Placed<f64, 2> for Beside {
    fn place(&self) -> &Vector<f64, 2> {
        &self.place
    }
}

/// The pairs of `i` within the radius, taken out of packs again.
fn in_packs<K: Kernel<f64>>(
    view: &RowView<'_, f64, 2, K, PeriodicBox<f64, 2>>,
    i: usize,
    radius: f64,
) -> Vec<Pair<f64, 2>> {
    let mut found = Vec::new();
    // The same places with something beside them.
    let beside: Vec<_> = view.targets.iter().map(|place| Beside { place: *place, _number: 1.0 }).collect();
    dispatch!(Level::new(), simd => {
        assert!(view.packs(simd, i).zip(view.packs_of(simd, i, &beside)).all(|(a, b)| a == b));
        assert_eq!(view.packs(simd, i).count(), view.packs_of(simd, i, &beside).count());
        for pack in view.packs(simd, i) {
            for (lane, &j) in pack.j.iter().enumerate() {
                let only = |lanes: F64Lanes<_>| {
                    (lanes * F64Lanes::gather(simd, |k| f64::from(u8::from(k == lane)))).sum()
                };
                let [r2, weight, over_r2] = [pack.r2, pack.weight, pack.over_r2].map(only);
                let r_ij = Vector::from([pack.r_ij[0], pack.r_ij[1]].map(only));
                // Lanes behind the end of a row have no weight, as the skin has not.
                if weight > 0.0 {
                    found.push(Pair { j, r_ij, r2, weight, over_r2 });
                }
            }
        }
    });
    found.retain(|pair| pair.distance() < radius);
    found
}

#[test]
fn rows_visit_the_same_pairs_in_the_same_order() {
    sums(WendlandC2);
    sums(Rational);
}

/// The oracle itself, by hand.
#[test]
fn trying_all_pairs_finds_what_is_near() {
    let points = [0.0, 1.0, 1.5, 9.0, 1.0].map(|x| Vector::<f64, 3>::new(x, 0.0, 0.0));
    let near = |neighborhood: &BruteForce<'_, f64, 3, WendlandC2>, i| {
        let mut row = Vec::new();
        neighborhood.for_each(i, |pair| row.push((pair.j, pair.r_ij[0])));
        row
    };
    let within = BruteForce::within(Open, &points, WendlandC2, 1.0);
    assert_eq!(near(&within, 0), [(1, 1.0), (4, 1.0)]);
    assert_eq!(near(&within, 1), [(0, -1.0), (2, 0.5), (4, 0.0)]);
    assert_eq!(near(&within, 3), []);
    let between = BruteForce::between(Open, &points[3..], &points[..3], WendlandC2, 1.0);
    assert_eq!(between.len(), 2);
    assert_eq!(near(&between, 1), [(0, -1.0), (1, 0.0), (2, 0.5)]);
}
