//! Nothing is allocated once buffers have grown. The only test of this file: others would be counted.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]
#![allow(unsafe_code, reason = "counting allocations takes a global allocator")]

mod common;

use common::{Random, Store, jittered};
use mps_kernel::Vector;
use mps_neighbors::{Cells, Open, Parallel, Permutation, Rows, Skin, state_hash};
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

struct Counting;

static ALLOCATIONS: AtomicUsize = AtomicUsize::new(0);

// SAFETY: hands everything to the system allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller's promises are passed on.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

fn allocations(work: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.load(Ordering::Relaxed);
    work();
    ALLOCATIONS.load(Ordering::Relaxed) - before
}

const STEPS: usize = 40;

/// Rebuilds while all particles move a little, after a warm-up; counts allocations after it, and how often threads had to be called.
fn rebuilds(threads: usize) -> (usize, usize) {
    let parallel = Parallel::new(threads).unwrap();
    let mut store = Store::<2>::at(jittered(80, 8));
    let wall: Vec<_> = (0..400).map(|i| Vector::<f64, 2>::new(f64::from(i) * 0.2, -1.0)).collect();
    let (mut cells, mut wall_cells) = (Cells::new(), Cells::new());
    let (mut rows, mut to_wall, mut back) = (Rows::default(), Rows::default(), Rows::default());
    let (mut permutation, mut skin, mut random) = (Permutation::default(), Skin::new(0.2), Random(5));
    let mut rebuilt = 0;
    let mut step = || {
        for p in &mut store.position {
            *p += Vector::<f64, 2>::from_fn(|_, _| 0.2 * (random.next() - 0.5));
        }
        if skin.expired(&parallel, &Open, &[&store.position, &wall]) {
            cells.build(&parallel, &Open, &store.position, 2.3).unwrap();
            permutation.apply(&mut store, cells.order()).unwrap();
            cells.settle();
            let points = &store.position[..];
            rows.build_within(&parallel, &Open, &cells, points, 2.3).unwrap();
            wall_cells.build(&parallel, &Open, &wall, 2.3).unwrap();
            to_wall.build_between(&parallel, &Open, &wall_cells, points, &wall, 2.3).unwrap();
            back.transpose_of(&to_wall, wall.len()).unwrap();
            skin.renew(&[points, &wall]);
            rebuilt += 1;
        }
        state_hash(&mut store)
    };
    // Inside the pool: handing work to it from outside allocates now and then.
    let found = parallel.install(|| {
        for _ in 0..3 {
            step();
        }
        let before = parallel.calls();
        let found = allocations(|| {
            for _ in 0..STEPS {
                step();
            }
        });
        (found, parallel.calls() - before)
    });
    assert_eq!(rebuilt, 3 + STEPS, "every step moves somebody by more than half a skin");
    found
}

#[test]
fn a_warm_rebuild_allocates_nothing() {
    assert!(allocations(|| drop(vec![1u8; 100])) > 0, "the count works");
    assert_eq!(rebuilds(1), (0, 0));
    for threads in [2, 3] {
        // A thread of the pool registers itself, with two allocations, when it first takes work from
        // another; and one that has fallen asleep because the machine was busy is called, which
        // allocates once or twice. Anything else per step would exceed this.
        let (found, calls) = rebuilds(threads);
        let most = 2 * threads + 2 * calls;
        assert!(
            found <= most,
            "{found} allocations in {STEPS} steps on {threads} threads, called {calls} times"
        );
    }
}
