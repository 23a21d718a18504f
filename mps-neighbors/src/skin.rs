//! When rows must be built anew.

use crate::{Domain, Parallel};
use mps_kernel::{Real, Transfer, Vector};

/// Remembers where every particle was when the rows were built.
///
/// Rows are built with a reach of radius + skin. While no particle of any set has moved more than
/// half a skin, two particles have approached each other by less than the skin: every pair within
/// the radius is still in the rows. That is the rule of [`expired`](Skin::expired), with a margin of
/// one thousandth for rounding; it covers rows within one set and between two sets alike.
///
/// Reordering particles changes who is at an index: call [`renew`](Skin::renew) after it.
#[derive(Clone, Debug)]
pub struct Skin<T: Real, const D: usize> {
    skin: T,
    built: bool,
    positions: Vec<Vec<Vector<T, D>>>,
}

impl<T: Real, const D: usize> Skin<T, D> {
    /// A skin of `skin` \[m\]; zero means that rows expire as soon as anything moves.
    pub fn new(skin: T) -> Self {
        Self { skin, built: false, positions: Vec::new() }
    }

    /// Width of the skin \[m\].
    pub fn width(&self) -> T {
        self.skin
    }

    /// Whether the rows of these sets must be built anew: a particle has moved more than half a
    /// skin since [`renew`](Skin::renew), a set has another size, or a position is NaN (so that the
    /// search gets to see it and can say which).
    pub fn expired<P: Domain<T, D>>(
        &self,
        parallel: &Parallel,
        domain: &P,
        sets: &[&[Vector<T, D>]],
    ) -> bool {
        if !self.built || sets.len() != self.positions.len() {
            return true;
        }
        let half = self.skin * T::of(0.5 * (1.0 - 1.0 / 1024.0));
        let limit = half * half;
        sets.iter().zip(&self.positions).any(|(now, before)| {
            now.len() != before.len()
                || parallel.fold(
                    now.len(),
                    false,
                    // `separation` takes a wrapped particle for what it is: one that moved a little.
                    &|i| {
                        let moved = domain.separation(&before[i], &now[i]).norm_squared();
                        // NaN is not within the limit.
                        !moved.partial_cmp(&limit).is_some_and(|order| order.is_le())
                    },
                    &|a, b| a | b,
                )
        })
    }

    /// Remembers the positions the rows are built from. Reuses its memory.
    pub fn renew(&mut self, sets: &[&[Vector<T, D>]]) {
        self.built = true;
        self.positions.resize_with(sets.len(), Vec::new);
        for (kept, now) in self.positions.iter_mut().zip(sets) {
            kept.clear();
            kept.extend_from_slice(now);
        }
    }

    /// The positions of each set that the rows were built from; `None` if there are no rows.
    pub fn built_from(&self) -> Option<&[Vec<Vector<T, D>>]> {
        self.built.then_some(&self.positions)
    }

    /// Saves or restores the remembered positions. Whoever restores them builds the rows from them again:
    /// rows decide, by the order of their sums, the bits of what follows, and by their age when they expire.
    pub fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { skin: _, built, positions } = self;
        let mut sets = positions.len() as u64;
        transfer.flag("built", built);
        transfer.value("sets", &mut sets);
        if transfer.is_good() {
            // As many sections follow as were saved; a number that is not true runs out of them.
            positions.truncate(usize::try_from(sets).unwrap_or(usize::MAX));
            for k in 0..sets {
                if !transfer.is_good() {
                    return;
                }
                if k as usize == positions.len() {
                    positions.push(Vec::new());
                }
                transfer.list("positions", &mut positions[k as usize]);
            }
        }
    }

    /// Forgets the positions: the rows count as expired until [`renew`](Skin::renew).
    pub fn expire(&mut self) {
        self.built = false;
    }
}
