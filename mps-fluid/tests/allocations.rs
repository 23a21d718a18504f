//! A warm step allocates nothing. The only test of this file: others would be counted.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]
#![allow(unsafe_code, reason = "counting allocations takes a global allocator")]

#[path = "suite/common/mod.rs"]
mod common;

use common::{Noise, everything, tank, vibrating_step, water};
use mps_fluid::{ArtificialViscosity, Fluid, Shifting, Viscosity};
use mps_kernel::{Kernel, Real};
use mps_neighbors::{Domain, Parallel};
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

/// Allocations of steps without and with a rebuild, and the number of rebuilds.
fn count<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>>(
    fluid: &mut Fluid<T, D, K, V, P>,
    steps: usize,
    step: impl Fn(&mut Fluid<T, D, K, V, P>, &Parallel),
) -> (usize, usize, usize) {
    let parallel = Parallel::serial();
    let (mut plain, mut rebuilding, mut rebuilds) = (0, 0, 0);
    for _ in 0..steps {
        let before = (ALLOCATIONS.load(Ordering::Relaxed), fluid.rebuilds());
        step(fluid, &parallel);
        let found = ALLOCATIONS.load(Ordering::Relaxed) - before.0;
        if fluid.rebuilds() > before.1 {
            rebuilding += found;
            rebuilds += 1;
        } else {
            plain += found;
        }
    }
    (plain, rebuilding, rebuilds)
}

/// One test: others beside it would be counted.
#[test]
fn warm_steps_allocate_nothing_and_rebuilds_next_to_nothing() {
    a_splash();
    everything_else::<f64, 2>([30, 24]);
    everything_else::<f32, 3>([9, 9, 8]);
}

fn a_splash() {
    let mut config = water::<f64, 2>(0.01, 0.4);
    config.shifting = Some(Shifting::default());
    let c = config.sound_speed;
    let mut fluid = tank([40, 40], config, |r| ArtificialViscosity::new::<2>(0.05, c, r));
    let mut noise = Noise::new(1);
    fluid.particles_mut().velocity.iter_mut().for_each(|u| *u = noise.vector(2.0));
    let mut steps = |steps| count(&mut fluid, steps, |fluid, parallel| assert!(fluid.step(parallel).is_ok()));
    assert!(steps(60).1 > 0, "the count works");
    let (plain, rebuilding, rebuilds) = steps(120);
    assert!((10..120).contains(&rebuilds), "{rebuilds} rebuilds");
    assert_eq!(plain, 0, "in {} steps without a rebuild", 120 - rebuilds);
    // As the fluid mixes, a block of rows may still outgrow its headroom once in a while.
    assert!(rebuilding <= rebuilds / 10 + 1, "{rebuilding} in {rebuilds} rebuilds");
}

/// The corrected form, no slip and the law of the wall, a structure with shear, relaxation, books.
fn everything_else<T: Real, const D: usize>(counts: [usize; D]) {
    let mut fluid = everything::<T, D>(counts);
    // What is seen of the interface grows and shrinks: warm is who has seen more of it.
    count(&mut fluid, 60, vibrating_step);
    let (plain, _, rebuilds) = count(&mut fluid, 40, vibrating_step);
    assert!(rebuilds < 40, "{rebuilds} rebuilds in {D} dimensions");
    // Lists of pairs across the interface are as long as there are pairs: one of six may grow once more.
    assert!(plain <= 1, "{plain} allocations in {} steps in {D} dimensions", 40 - rebuilds);
}
