//! Parts of a loop, as they are handed from thread to thread.
//!
//! They are of one type for all loops: what hands them over is compiled once, and not for every loop anew, which was a quarter of the code of a
//! program (`docs/performance.md`).

use std::cell::Cell;

/// A part of a loop.
pub(crate) type Part<'a> = &'a mut (dyn FnMut() + Send);

/// `work` on `value`, as a part that is run once.
pub(crate) fn once<A: Send>(value: A, work: impl Fn(A) + Send) -> impl FnMut() + Send {
    let mut value = Some(value);
    move || {
        if let Some(value) = value.take() {
            work(value);
        }
    }
}

/// [`rayon::join`] of two parts of a loop.
pub(crate) fn join(a: Part, b: Part) {
    rayon::join(|| run(a), || run(b));
}

thread_local! {
    /// How many parts of loops this thread is in.
    static PARTS: Cell<u32> = const { Cell::new(0) };
}

/// Whether this thread is in a part of a loop.
pub(crate) fn within() -> bool {
    PARTS.get() > 0
}

/// Runs a part of a loop, which the thread knows that it is in until the part has ended, also by a panic.
pub(crate) fn run(work: Part) {
    struct Counted;
    impl Drop for Counted {
        fn drop(&mut self) {
            PARTS.set(PARTS.get() - 1);
        }
    }
    PARTS.set(PARTS.get() + 1);
    let _counted = Counted;
    work();
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicU32, Ordering::SeqCst};

    #[test]
    fn a_thread_is_in_a_part_until_it_has_ended_also_by_a_panic() {
        run(&mut || {
            run(&mut || assert!(within()));
            assert!(within(), "the outer one goes on");
        });
        assert!(!within());
        assert!(std::panic::catch_unwind(|| run(&mut || assert!(!within()))).is_err());
        assert!(!within());
    }

    #[test]
    fn both_parts_are_run_and_each_value_is_used_once() {
        let sums = [AtomicU32::new(0), AtomicU32::new(0)];
        let add = |k: usize| {
            sums[k].fetch_add(1, SeqCst);
        };
        let (mut a, mut b) = (once(0, add), once(1, add));
        join(&mut a, &mut b);
        a();
        assert_eq!(sums.each_ref().map(|sum| sum.load(SeqCst)), [1, 1]);
    }
}
