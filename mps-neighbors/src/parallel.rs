//! Parallel loops whose results do not depend on the number of threads.
//!
//! Each loop writes only to its own particle ("gather"), so there is no lock and no scatter; sums are
//! added in the order of a tree that is the same for any pool.

use crate::awake::Awake;
use crate::fields::Fields;
use crate::halves::{BLOCK, FEW, fold_halves, halve, halve_leaves, halve_to};
use crate::parts::{Part, once};
use fearless_simd::{Level, Simd};
use mps_kernel::Real;
use thiserror::Error;

/// The threads a simulation runs on.
///
/// ```
/// use mps_neighbors::Parallel;
///
/// let parallel = Parallel::new(2)?;
/// let mut squares = vec![0.0; 5000];
/// parallel.update(squares.as_mut_slice(), |i, square| *square = (i * i) as f64);
/// let sum: f64 = parallel.sum(squares.len(), |i| squares[i]);
/// assert_eq!(sum, 41654167500.0);
/// # Ok::<(), mps_neighbors::ParallelError>(())
/// ```
#[derive(Debug)]
pub struct Parallel {
    pool: Option<Pool>,
    threads: usize,
    /// What the processor can do.
    level: Level,
}

/// More than one thread.
#[derive(Debug)]
struct Pool {
    threads: rayon::ThreadPool,
    awake: Awake,
}

impl Pool {
    /// Runs a loop that is to be shared.
    fn drive(&self, work: Part) {
        self.awake.drive(&self.threads, work);
    }
}

/// What a loop over particles does to one of them, compiled for the vector instructions of the
/// processor at hand.
///
/// Everything [`visit`](Sweep::visit) calls in the loop over pairs must be `#[inline(always)]`: what
/// is not inlined is compiled for any processor, and slow.
pub trait Sweep<F: Fields>: Sync {
    /// Computes the entries `item` of particle `i`.
    fn visit<S: Simd>(&self, simd: S, i: usize, item: F::Item);
}

/// Why no threads could be started.
#[derive(Debug, Error)]
pub enum ParallelError {
    /// Zero threads were asked for.
    #[error("the number of threads must be at least 1, got 0: leave it out to use all cores")]
    ZeroThreads,
    /// The operating system refused.
    #[error("could not start {threads} threads: {reason}; ask for fewer")]
    Refused {
        /// Threads asked for.
        threads: usize,
        /// The words of the thread pool.
        reason: String,
    },
}

impl Parallel {
    /// Starts `threads` threads; 1 runs everything on the calling thread.
    ///
    /// # Errors
    /// If `threads` is 0 or the system refuses to start them.
    pub fn new(threads: usize) -> Result<Self, ParallelError> {
        match threads {
            0 => Err(ParallelError::ZeroThreads),
            1 => Ok(Self::serial()),
            _ => rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .map(|pool| Self {
                    pool: Some(Pool { threads: pool, awake: Awake::new(threads) }),
                    threads,
                    level: Level::new(),
                })
                .map_err(|e| ParallelError::Refused { threads, reason: e.to_string() }),
        }
    }

    /// Everything on the calling thread.
    pub fn serial() -> Self {
        Self { pool: None, threads: 1, level: Level::new() }
    }

    /// As many threads as the machine has cores.
    ///
    /// # Errors
    /// If the system refuses to start them.
    pub fn all_cores() -> Result<Self, ParallelError> {
        Self::new(std::thread::available_parallelism().map_or(1, usize::from))
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.threads
    }

    /// Runs `work` inside the pool. Loops started from inside need no hand-over between threads;
    /// a time loop is best run as a whole in here.
    pub fn install<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        match &self.pool {
            Some(pool) => pool.threads.install(work),
            None => work(),
        }
    }

    /// Calls `each(i, item)` once for every particle `i`; `fields` is one mutable slice or a tuple
    /// of slices of equal length, `item` the references to entry `i` of each.
    pub fn update<F: Fields>(&self, fields: F, each: impl Fn(usize, F::Item) + Sync) {
        match &self.pool {
            Some(pool) if fields.len() > FEW => {
                pool.drive(&mut once(fields, |fields| halve(fields, 0, &each)))
            }
            _ => fields.for_each(0, &each),
        }
    }

    /// As [`update`](Self::update), with the vector instructions of the processor. The bits are the
    /// same on any.
    pub fn sweep<F: Fields>(&self, fields: F, sweep: &impl Sweep<F>) {
        let level = self.level;
        let leaf = |fields: F, first: usize| run_at(level, fields, first, sweep);
        match &self.pool {
            Some(pool) if fields.len() > FEW => {
                pool.drive(&mut once(fields, |fields| halve_leaves(BLOCK, fields, 0, &leaf)));
            }
            _ => leaf(fields, 0),
        }
    }

    /// The same threads without the vector instructions that not every processor has: to test that they
    /// do not change results.
    #[must_use]
    pub fn portable(self) -> Self {
        Self { level: Level::baseline(), ..self }
    }

    /// Calls `work(i, item)` once for every item, each of which is a block of particles and worth a
    /// task of its own.
    pub(crate) fn blocks<B: Send>(&self, blocks: &mut [B], work: impl Fn(usize, &mut B) + Sync) {
        match &self.pool {
            Some(pool) if blocks.len() > 1 => {
                pool.drive(&mut || halve_to(1, &mut *blocks, 0, &|i, b: &mut B| work(i, b)));
            }
            _ => blocks.for_each(0, &work),
        }
    }

    /// Sum of `value(i)` over `0..len`, always added in the same order.
    pub fn sum<A>(&self, len: usize, value: impl Fn(usize) -> A + Sync) -> A
    where
        A: Copy + Send + Sync + Default + core::ops::Add<Output = A>,
    {
        self.fold(len, A::default(), &value, &|a, b| a + b)
    }

    /// Largest `value(i)` over `0..len`, or `least` if that is larger or `len` is zero.
    /// NaN values are ignored.
    pub fn max<T: Real>(&self, len: usize, least: T, value: impl Fn(usize) -> T + Sync) -> T {
        self.fold(len, least, &value, &|a, b| if b > a { b } else { a })
    }

    /// How often threads that had fallen asleep have been called into a loop, because nothing was shared for a while or because the machine
    /// was busy. A call allocates; loops do not.
    pub fn calls(&self) -> usize {
        self.pool.as_ref().map_or(0, |pool| pool.awake.calls())
    }

    /// How many threads nobody has called.
    #[cfg(test)]
    pub(crate) fn asleep(&self) -> usize {
        self.pool.as_ref().map_or(0, |pool| pool.awake.asleep())
    }

    /// Folds `value(i)` with an associative-in-exact-arithmetic `combine`, whose order is fixed.
    pub fn fold<A: Copy + Send + Sync>(
        &self,
        len: usize,
        start: A,
        value: &(impl Fn(usize) -> A + Sync),
        combine: &(impl Fn(A, A) -> A + Sync),
    ) -> A {
        match &self.pool {
            Some(pool) if len > FEW => {
                let mut folded = start;
                pool.drive(&mut || folded = fold_halves(0, len, start, value, combine, true));
                folded
            }
            _ => fold_halves(0, len, start, value, combine, false),
        }
    }
}

/// The entries of one leaf, with AVX-512 or AVX2 where there is one, else with what every processor of its kind has.
///
/// What AVX-512 brings is twice as many registers, of the same width: sums stay in them (`docs/performance.md`).
fn run_at<F: Fields>(level: Level, fields: F, first: usize, sweep: &impl Sweep<F>) {
    #[cfg(target_arch = "x86_64")]
    if let Some(avx512) = level.as_avx512() {
        avx512.vectorize(
            #[inline(always)]
            || run(avx512, fields, first, sweep),
        );
    } else if let Some(avx2) = level.as_avx2() {
        avx2.vectorize(
            #[inline(always)]
            || run(avx2, fields, first, sweep),
        );
    } else if let Some(sse2) = level.as_sse2() {
        // Every processor of this kind has SSE2.
        run(sse2, fields, first, sweep);
    }
    #[cfg(not(target_arch = "x86_64"))]
    fearless_simd::dispatch!(level, simd => run(simd, fields, first, sweep));
}

/// Inlined into the function that is compiled for `S`.
#[inline(always)]
fn run<S: Simd, F: Fields>(simd: S, fields: F, first: usize, sweep: &impl Sweep<F>) {
    // Told so twice: a large closure that is not inlined has none of the instructions, and every operation in it is
    // a call.
    fields.for_each(
        first,
        #[inline(always)]
        |i, item| sweep.visit(simd, i, item),
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plain parallel sum gave a different last bit from run to run.
    #[test]
    fn sums_have_the_same_bits_for_any_number_of_threads() {
        let values: Vec<f64> = (0..100_003).map(|i| ((i * 7919 % 10_007) as f64).sin() * 1e-3).collect();
        let expected = Parallel::serial().sum(values.len(), |i| values[i]).to_bits();
        for threads in [2, 3, 8] {
            let parallel = Parallel::new(threads).unwrap();
            for _ in 0..20 {
                assert_eq!(parallel.sum(values.len(), |i| values[i]).to_bits(), expected);
            }
        }
    }

    #[test]
    fn update_reaches_every_entry_once() {
        let parallel = Parallel::new(3).unwrap();
        for len in [0, 1, FEW, FEW + 1, 6 * BLOCK + 17] {
            let mut a = vec![0usize; len];
            let mut b = vec![0usize; len];
            parallel.update((a.as_mut_slice(), b.as_mut_slice()), |i, (a, b)| {
                *a += i;
                *b += 2 * i;
            });
            assert!((0..len).all(|i| a[i] == i && b[i] == 2 * i), "{len} entries");
        }
    }

    #[test]
    fn zero_threads_are_refused() {
        assert!(matches!(Parallel::new(0), Err(ParallelError::ZeroThreads)));
    }
}
