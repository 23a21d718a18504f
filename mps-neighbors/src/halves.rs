//! Loops as trees: the particles are halved until few are left.
//!
//! The tree, and with it the order of every sum, is a function of the number of particles alone, whatever
//! the pool. Halves differ by one particle at most: a thread that waits for the other half falls asleep.

use crate::fields::Fields;
use crate::parts::{join, once};

/// Most particles that a leaf of the recursion handles in sequence.
pub(crate) const BLOCK: usize = 512;

/// Loops over no more particles than this stay on the calling thread: measured with threads that fall asleep between two loops; sharing
/// smaller ones gains nothing with those that stay awake either (`docs/performance.md`).
pub(crate) const FEW: usize = 1024;

/// [`Parallel::update`](crate::Parallel::update) on the pool the caller runs in, or on the calling thread if in none.
pub(crate) fn in_pool<F: Fields>(fields: F, each: &(impl Fn(usize, F::Item) + Sync)) {
    if fields.len() > FEW && rayon::current_thread_index().is_some() {
        halve(fields, 0, each);
    } else {
        fields.for_each(0, each);
    }
}

pub(crate) fn halve<F: Fields>(fields: F, first: usize, each: &(impl Fn(usize, F::Item) + Sync)) {
    halve_to(BLOCK, fields, first, each);
}

pub(crate) fn halve_to<F: Fields>(
    block: usize,
    fields: F,
    first: usize,
    each: &(impl Fn(usize, F::Item) + Sync),
) {
    halve_leaves(block, fields, first, &|fields: F, first| fields.for_each(first, each));
}

pub(crate) fn halve_leaves<F: Fields>(
    block: usize,
    fields: F,
    first: usize,
    leaf: &(impl Fn(F, usize) + Sync),
) {
    if fields.len() <= block {
        return leaf(fields, first);
    }
    let cut = fields.len() / 2;
    let (left, right) = fields.cut(cut);
    let mut left = once(left, |left| halve_leaves(block, left, first, leaf));
    let mut right = once(right, |right| halve_leaves(block, right, first + cut, leaf));
    join(&mut left, &mut right);
}

/// Folds `value(i)` over `first..first + len`, with the pool the caller runs in if `threads`.
pub(crate) fn fold_halves<A: Copy + Send + Sync>(
    first: usize,
    len: usize,
    start: A,
    value: &(impl Fn(usize) -> A + Sync),
    combine: &(impl Fn(A, A) -> A + Sync),
    threads: bool,
) -> A {
    if len <= BLOCK {
        return (first..first + len).fold(start, |sum, i| combine(sum, value(i)));
    }
    let cut = len / 2;
    let (mut a, mut b) = (start, start);
    let mut left = || a = fold_halves(first, cut, start, value, combine, threads);
    let mut right = || b = fold_halves(first + cut, len - cut, start, value, combine, threads);
    if threads {
        join(&mut left, &mut right);
    } else {
        left();
        right();
    }
    combine(a, b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    /// Cut at multiples of a block, 1,536 entries made a half of one block and a half of two.
    #[test]
    fn halves_are_equal_and_leaves_small() {
        for len in [1025, 1536, 5000, 100_003] {
            let leaves = Mutex::new(Vec::new());
            halve_leaves(BLOCK, vec![0u8; len].as_mut_slice(), 0, &|leaf: &mut [u8], first| {
                leaves.lock().unwrap().push((first, leaf.len()));
            });
            let mut leaves = leaves.into_inner().unwrap();
            leaves.sort_unstable();
            assert!(leaves.windows(2).all(|pair| pair[0].0 + pair[0].1 == pair[1].0), "{len}: {leaves:?}");
            assert_eq!(leaves.iter().map(|leaf| leaf.1).sum::<usize>(), len);
            assert!(leaves.iter().all(|leaf| (BLOCK / 2..=BLOCK).contains(&leaf.1)), "{len}: {leaves:?}");
            assert!(leaves.iter().any(|leaf| leaf.0 == len / 2), "{len}: {leaves:?}");
        }
    }
}
