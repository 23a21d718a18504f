//! Nothing allocates in a step.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]
#![allow(unsafe_code)]

mod common;

use common::block;
use mps_kernel::Vector;
use mps_neighbors::Parallel;
use mps_solid::body::Face;
use mps_solid::contact::{Contact, ContactConfig, Elastic};
use mps_solid::materials::CorotationalHooke;
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

struct Counting;

static COUNT: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call is handed to the system allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.fetch_add(1, Ordering::Relaxed);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller's promises are passed on.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// One test, so that no other thread allocates meanwhile.
#[test]
fn nothing_allocates_in_a_step() {
    let parallel = Parallel::serial();
    let mut solid = block([300, 4], &[Face::lower(0)], CorotationalHooke::new(1e6, 0.4).unwrap());
    let rest = vec![Vector::<f64, 2>::zeros(); solid.len()];
    let gravity = Vector::<f64, 2>::new(0.0, -9.81);
    let dt = solid.max_step(&parallel);
    let before = COUNT.load(Ordering::Relaxed);
    for _ in 0..10 {
        solid.advance(&parallel, &rest, &gravity, 5.0 * dt, 5).unwrap();
        let energy = solid.energy(&parallel, &gravity);
        assert!(energy.kinetic > 0.0 && solid.max_step(&parallel) < dt);
    }
    assert_eq!(COUNT.load(Ordering::Relaxed) - before, 0);
    nothing_allocates_in_contact();
}

/// A block that bounces on another: once the largest contact has been, nothing allocates.
fn nothing_allocates_in_contact() {
    let parallel = Parallel::serial();
    let gravity = Vector::<f64, 2>::new(0.0, -9.81);
    let material = CorotationalHooke::new(1e6, 0.4).unwrap();
    let mut under = block([30, 6], &[Face::lower(1)], material);
    let mut over = block([30, 6], &[], material);
    over.positions_mut().iter_mut().for_each(|x| x.y += 0.063);
    over.velocities_mut().fill(gravity * 0.2);
    let mut contact = Contact::new(ContactConfig::default()).unwrap();
    contact.add(&under.shape()).unwrap();
    contact.add(&over.shape()).unwrap();
    let bodies: &mut [&mut dyn Elastic<f64, 2>] = &mut [&mut under, &mut over];
    let mut advance = |rounds: usize| {
        let before = COUNT.load(Ordering::Relaxed);
        let mut touched = false;
        for _ in 0..rounds {
            let dt = contact.max_step(&parallel, bodies).unwrap();
            contact.advance(&parallel, bodies, |_| &[], &gravity, 5.0 * dt, 5).unwrap();
            touched |= contact.energy() > 0.0;
        }
        (COUNT.load(Ordering::Relaxed) - before, touched)
    };
    assert!(advance(200).1);
    assert_eq!(advance(600), (0, true));
}
