//! A warm step allocates nothing. The only test of this file: others would be counted.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]
#![allow(unsafe_code, reason = "counting allocations takes a global allocator")]

#[path = "suite/common/mod.rs"]
mod common;

use common::{Noise, tank, water};
use mps_fluid::{ArtificialViscosity, CompletedViscosity, Shifting};
use mps_neighbors::Parallel;
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

#[test]
fn warm_steps_allocate_nothing_and_rebuilds_next_to_nothing() {
    let parallel = Parallel::serial();
    let mut config = water::<f64, 2>(0.01, 0.4);
    config.shifting = Some(Shifting::default());
    let c = config.sound_speed;
    let mut fluid = tank([40, 40], config, |r| CompletedViscosity(ArtificialViscosity::new::<2>(0.05, c, r)));
    let mut noise = Noise::new(1);
    fluid.particles_mut().velocity.iter_mut().for_each(|u| *u = noise.vector(2.0));
    // Allocations of steps without and with a rebuild, and the number of rebuilds.
    let mut steps = |count: usize| {
        let (mut plain, mut rebuilding, mut rebuilds) = (0, 0, 0);
        for _ in 0..count {
            let before = (ALLOCATIONS.load(Ordering::Relaxed), fluid.rebuilds());
            fluid.step(&parallel).unwrap();
            let found = ALLOCATIONS.load(Ordering::Relaxed) - before.0;
            if fluid.rebuilds() > before.1 {
                rebuilding += found;
                rebuilds += 1;
            } else {
                plain += found;
            }
        }
        (plain, rebuilding, rebuilds)
    };
    assert!(steps(60).1 > 0, "the count works");
    let (plain, rebuilding, rebuilds) = steps(120);
    assert!((10..120).contains(&rebuilds), "{rebuilds} rebuilds");
    assert_eq!(plain, 0, "in {} steps without a rebuild", 120 - rebuilds);
    // As the fluid mixes, a block of rows may still outgrow its headroom once in a while.
    assert!(rebuilding <= rebuilds / 10 + 1, "{rebuilding} in {rebuilds} rebuilds");
}
