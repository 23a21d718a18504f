//! Threads that stay awake between two loops.
//!
//! A thread of the pool that finds no work falls asleep after some ten microseconds, and to wake it takes as long as a loop over
//! hundreds of particles (`docs/performance.md`). A step is dozens of loops with little between them. So whoever starts a loop calls the
//! other threads once, and each of them looks for work until it has found none for [`PATIENCE`].
//!
//! A thread may be called while it waits for the other half of a part of a loop it has taken over. It must not look for work then, or whoever waits for
//! its part would wait as long as anybody else has work: hence [`parts`], which keeps count.

use crate::parts::{self, Part};
use rayon::{ThreadPool, Yield};
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, AtomicUsize, Ordering::SeqCst};
use std::time::{Duration, Instant};

/// How long a thread looks for work in vain before it may fall asleep: longer than the small loops of a step that one thread does
/// alone, and not so long that another program that wants the processor would notice.
const PATIENCE: Duration = Duration::from_micros(250);

/// Nobody has called the thread.
const ASLEEP: u8 = 0;
/// Called, and not there yet.
const CALLED: u8 = 1;
/// Looking for work.
const AWAKE: u8 = 2;
/// It has started a loop itself: it must return to it as soon as the loop is done, and may not be called.
const DRIVING: u8 = 3;

/// What each thread of a pool is doing.
#[derive(Debug)]
pub(crate) struct Awake {
    states: Arc<[AtomicU8]>,
    calls: AtomicUsize,
}

impl Awake {
    pub(crate) fn new(threads: usize) -> Self {
        Self { states: (0..threads).map(|_| AtomicU8::new(ASLEEP)).collect(), calls: AtomicUsize::new(0) }
    }

    /// Runs a loop on `pool` with all its threads awake.
    pub(crate) fn drive(&self, pool: &ThreadPool, work: Part) {
        pool.install(|| {
            let Some(own) = pool.current_thread_index().and_then(|me| self.states.get(me)) else {
                return work();
            };
            let _driving = Driving { own, before: own.swap(DRIVING, SeqCst) };
            self.call(pool);
            work()
        })
    }

    /// How often somebody has been called.
    pub(crate) fn calls(&self) -> usize {
        self.calls.load(SeqCst)
    }

    /// How many threads nobody has called.
    #[cfg(test)]
    pub(crate) fn asleep(&self) -> usize {
        self.states.iter().filter(|state| state.load(SeqCst) == ASLEEP).count()
    }

    /// Calls those who are asleep. Allocates only then.
    fn call(&self, pool: &ThreadPool) {
        let mut anybody = false;
        for state in self.states.iter() {
            anybody |= state.load(SeqCst) == ASLEEP
                && state.compare_exchange(ASLEEP, CALLED, SeqCst, SeqCst).is_ok();
        }
        if anybody {
            self.calls.fetch_add(1, SeqCst);
            let states = Arc::clone(&self.states);
            pool.spawn_broadcast(move |thread| {
                if let Some(own) = states.get(thread.index()) {
                    stay(own);
                }
            });
        }
    }
}

/// Gives the thread back its state when its loop is done, also by a panic.
struct Driving<'a> {
    own: &'a AtomicU8,
    before: u8,
}

impl Drop for Driving<'_> {
    fn drop(&mut self) {
        // A call that was meant for this thread has been declined meanwhile, or will be.
        self.own.store(if self.before == CALLED { ASLEEP } else { self.before }, SeqCst);
    }
}

/// Looks for work until there has been none for a while.
fn stay(own: &AtomicU8) {
    let answer = if parts::within() { ASLEEP } else { AWAKE };
    if own.compare_exchange(CALLED, answer, SeqCst, SeqCst).is_err() || answer == ASLEEP {
        return;
    }
    let mut idle_since = Instant::now();
    while idle_since.elapsed() < PATIENCE {
        match rayon::yield_now() {
            Some(Yield::Executed) => idle_since = Instant::now(),
            // Whoever else wants the processor gets it.
            _ => std::thread::yield_now(),
        }
    }
    own.store(ASLEEP, SeqCst);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Parallel;

    const THREADS: usize = 3;

    fn pool() -> (ThreadPool, Awake) {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(THREADS).build().unwrap();
        (pool, Awake::new(THREADS))
    }

    /// Whether it is `done` within ten seconds.
    fn wait_for(done: impl Fn() -> bool) -> bool {
        let start = Instant::now();
        while start.elapsed() < Duration::from_secs(10) {
            if done() {
                return true;
            }
            std::thread::yield_now();
        }
        false
    }

    #[test]
    fn the_others_come_when_a_loop_starts_and_go_when_none_has_for_a_while() {
        let (pool, awake) = pool();
        let somebody = || awake.states.iter().any(|state| state.load(SeqCst) == AWAKE);
        // Called in every loop: on a busy machine one may have gone before it is looked for.
        let come = || {
            let mut come = false;
            awake.drive(&pool, &mut || come = somebody());
            come
        };
        assert!(wait_for(come), "nobody has come");
        assert!(wait_for(|| awake.asleep() == THREADS), "somebody stays for ever");
        // And once more.
        assert!(wait_for(come), "nobody has come again");
    }

    /// Called within a part of a loop, a thread declines, and may be called again.
    #[test]
    fn who_is_in_a_part_of_a_loop_does_not_stay() {
        let state = AtomicU8::new(CALLED);
        parts::run(&mut || stay(&state));
        assert_eq!(state.load(SeqCst), ASLEEP);
    }

    fn true_for_sure() -> bool {
        std::hint::black_box(true)
    }

    #[test]
    fn a_loop_that_panics_leaves_its_thread_as_it_was() {
        let (pool, awake) = pool();
        let driven = std::panic::AssertUnwindSafe(|| awake.drive(&pool, &mut || assert!(!true_for_sure())));
        assert!(std::panic::catch_unwind(driven).is_err());
        assert!(wait_for(|| awake.asleep() == THREADS));
    }

    /// All loops come to their end, and nobody is left in a wrong state.
    #[test]
    fn several_may_drive_one_pool() {
        let parallel = Parallel::new(THREADS).unwrap();
        let sums = AtomicUsize::new(0);
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    for _ in 0..200 {
                        let sum: u64 = parallel.sum(5000, |i| i as u64);
                        assert_eq!(sum, 12_497_500);
                        sums.fetch_add(1, SeqCst);
                    }
                });
            }
        });
        assert_eq!(sums.load(SeqCst), 800);
        assert!(wait_for(|| parallel.asleep() == THREADS));
    }

    #[test]
    fn a_loop_inside_of_a_loop_comes_to_its_end() {
        let parallel = Parallel::new(THREADS).unwrap();
        let mut totals = vec![0_u64; 2000];
        parallel.update(totals.as_mut_slice(), |i, total| {
            if i % 100 == 0 {
                *total = parallel.sum(3000, |k| k as u64);
            }
        });
        assert!(totals.iter().step_by(100).all(|total| *total == 4_498_500));
    }
}
