//! Every particle against every other: too slow to simulate with, too simple to be wrong.

use crate::{Domain, Open};
use mps_kernel::{Kernel, Neighborhood, Pair, Real, Vector};

/// Neighbours found by trying all of them, the oracle of the tests; also fine for tiny sets.
#[derive(Clone, Copy, Debug)]
pub struct BruteForce<'a, T: Real, const D: usize, K, P = Open> {
    points: &'a [Vector<T, D>],
    targets: &'a [Vector<T, D>],
    same: bool,
    kernel: K,
    radius: T,
    domain: P,
}

impl<'a, T: Real, const D: usize, K: Kernel<T>, P: Domain<T, D>> BruteForce<'a, T, D, K, P> {
    /// Neighbours `j != i` within one set, up to and including `radius` \[m\].
    pub fn within(domain: P, points: &'a [Vector<T, D>], kernel: K, radius: T) -> Self {
        Self { points, targets: points, same: true, kernel, radius, domain }
    }

    /// Neighbours of each of `points` among `targets`, up to and including `radius` \[m\].
    pub fn between(
        domain: P,
        points: &'a [Vector<T, D>],
        targets: &'a [Vector<T, D>],
        kernel: K,
        radius: T,
    ) -> Self {
        Self { points, targets, same: false, kernel, radius, domain }
    }
}

impl<T, const D: usize, K, P> Neighborhood<T, D> for BruteForce<'_, T, D, K, P>
where
    T: Real,
    K: Kernel<T>,
    P: Domain<T, D>,
{
    fn len(&self) -> usize {
        self.points.len()
    }

    fn for_each(&self, i: usize, mut visit: impl FnMut(&Pair<T, D>)) {
        for (j, target) in self.targets.iter().enumerate() {
            let r_ij = self.domain.separation(&self.points[i], target);
            if r_ij.norm_squared() <= self.radius * self.radius && !(self.same && i == j) {
                visit(&Pair::new(j, r_ij, &self.kernel, self.radius));
            }
        }
    }
}
