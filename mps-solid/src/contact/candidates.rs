//! Who may touch whom: compact rows of the few particles that have somebody near.

use mps_kernel::{Real, Vector};
use mps_neighbors::{Parallel, Rows};

/// Rows of those particles only that have a candidate.
#[derive(Clone, Debug, Default)]
pub(crate) struct Candidates {
    particles: Vec<u32>,
    /// Row `k` is `list[starts[k]..starts[k + 1]]`.
    starts: Vec<usize>,
    list: Vec<u32>,
}

impl Candidates {
    /// Particles with candidates, ascending.
    pub(crate) fn particles(&self) -> &[u32] {
        &self.particles
    }

    /// Particle number `k` of [`particles`](Self::particles) and its candidates, ascending.
    #[inline(always)]
    pub(crate) fn row(&self, k: usize) -> (usize, &[u32]) {
        let range = self.starts[k]..self.starts[k + 1];
        (self.particles[k] as usize, &self.list[range])
    }

    /// Forgets all.
    pub(crate) fn clear(&mut self) {
        self.particles.clear();
        self.starts.clear();
        self.starts.push(0);
        self.list.clear();
    }

    /// Takes the entries of `rows` that `keep(i, j)`.
    pub(crate) fn fill(&mut self, rows: &Rows, keep: impl Fn(usize, usize) -> bool) {
        self.clear();
        for i in 0..rows.len() {
            let before = self.list.len();
            self.list.extend(rows.row(i).iter().filter(|&&j| keep(i, j as usize)));
            if self.list.len() > before {
                self.particles.push(i as u32);
                self.starts.push(self.list.len());
            }
        }
    }
}

/// Says when candidates must be searched again: when somebody has moved half a skin away from where a common shift
/// of all would have brought it. (A body that flies keeps its candidates.)
#[derive(Clone, Debug)]
pub(crate) struct Watch<T: Real, const D: usize> {
    skin: T,
    built: bool,
    before: [Vec<Vector<T, D>>; 2],
}

impl<T: Real, const D: usize> Watch<T, D> {
    pub(crate) fn new(skin: T) -> Self {
        Self { skin, built: false, before: [Vec::new(), Vec::new()] }
    }

    pub(crate) fn expired(&self, parallel: &Parallel, sets: [&[Vector<T, D>]; 2]) -> bool {
        if !self.built {
            return true;
        }
        let (mut shift, mut number) = (Vector::zeros(), 0);
        for (now, before) in sets.iter().zip(&self.before) {
            let moved = |i: usize| now[i] - before[i];
            shift += parallel.fold(now.len(), Vector::zeros(), &moved, &|a, b| a + b);
            number += now.len();
        }
        shift /= T::of(number as f64);
        // A margin of one thousandth for rounding.
        let half = self.skin * T::of(0.5 * (1.0 - 1.0 / 1024.0));
        let limit = half * half;
        sets.iter().zip(&self.before).any(|(now, before)| {
            let left = |i: usize| {
                let away = (now[i] - before[i] - shift).norm_squared();
                // NaN is not within the limit.
                !away.partial_cmp(&limit).is_some_and(|order| order.is_le())
            };
            parallel.fold(now.len(), false, &left, &|a, b| a | b)
        })
    }

    pub(crate) fn renew(&mut self, sets: [&[Vector<T, D>]; 2]) {
        self.built = true;
        for (before, now) in self.before.iter_mut().zip(sets) {
            before.clear();
            before.extend_from_slice(now);
        }
    }

    pub(crate) fn expire(&mut self) {
        self.built = false;
    }
}
