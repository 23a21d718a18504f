//! When rows must be built anew.

use crate::{Domain, Parallel};
use mps_kernel::{Real, Vector};

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

    /// Forgets the positions: the rows count as expired until [`renew`](Skin::renew).
    pub fn expire(&mut self) {
        self.built = false;
    }
}
