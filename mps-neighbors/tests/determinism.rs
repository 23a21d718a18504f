//! The same bits for any number of threads.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{Store, jittered, plain};
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Neighborhood, Vector};
use mps_neighbors::{Cells, Open, Parallel, PeriodicBox, Permutation, RowView, Rows, Skin, state_hash};

#[test]
fn rows_do_not_depend_on_the_number_of_threads() {
    let points = jittered::<2>(120, 5);
    let around = PeriodicBox::new(Vector::<f64, 2>::repeat(-0.5), [Some(120.0), None]).unwrap();
    let find = |threads: usize| {
        let parallel = Parallel::new(threads).unwrap();
        let (mut cells, mut rows, mut back) = (Cells::new(), Rows::default(), Rows::default());
        cells.build(&parallel, &around, &points, 3.3).unwrap();
        rows.build_within(&parallel, &around, &cells, &points, 3.3).unwrap();
        back.transpose_of(&rows, points.len()).unwrap();
        (cells.order().to_vec(), plain(&rows), plain(&back))
    };
    let expected = find(1);
    assert_eq!(expected.1, expected.2, "within one set, pairs are mutual");
    for threads in [2, 3, 8] {
        assert!(find(threads) == expected, "{threads} threads");
    }
}

/// Particles that repel each other, in a flow that needs new rows every few steps.
fn run(threads: usize) -> (u64, usize) {
    let parallel = Parallel::new(threads).unwrap();
    let mut store = Store::<2>::at(jittered(110, 8));
    let (mut cells, mut rows, mut permutation) = (Cells::new(), Rows::default(), Permutation::default());
    let mut skin = Skin::new(0.3);
    let (radius, mut rebuilds) = (2.1, 0);
    parallel.install(|| {
        for v in &mut store.velocity {
            *v = Vector::zeros();
        }
        for _ in 0..12 {
            if skin.expired(&parallel, &Open, &[&store.position]) {
                cells.build(&parallel, &Open, &store.position, radius + 0.3).unwrap();
                permutation.apply(&mut store, cells.order()).unwrap();
                cells.settle();
                rows.build_within(&parallel, &Open, &cells, &store.position, radius + 0.3).unwrap();
                skin.renew(&[&store.position]);
                rebuilds += 1;
            }
            let points = &store.position[..];
            let view =
                RowView { rows: &rows, points, targets: points, kernel: WendlandC2, radius, domain: Open };
            let mean = parallel.sum(store.density.len(), |i| store.density[i]) / store.density.len() as f64;
            parallel.update((&mut store.velocity[..], &mut store.density[..]), |i, (v, density)| {
                let (mut push, mut sum) = (Vector::zeros(), 0.0);
                view.for_each(i, |pair| {
                    push -= pair.gradient_vector();
                    sum += pair.weight;
                });
                *v = *v * 0.9 + push * 0.05 + Vector::<f64, 2>::new(0.0, -1e-5 * mean);
                *density = sum;
            });
            for (p, v) in store.position.iter_mut().zip(&store.velocity) {
                *p += v;
            }
        }
    });
    assert!(store.position.iter().all(|p| p.norm() < 1e3));
    (state_hash(&mut store), rebuilds)
}

#[test]
fn a_simulation_ends_in_the_same_state() {
    let (expected, rebuilds) = run(1);
    assert!(rebuilds >= 3, "particles meet new neighbours: {rebuilds} rebuilds");
    for threads in [1, 2, 3, 8] {
        assert_eq!(run(threads), (expected, rebuilds), "{threads} threads");
    }
}
