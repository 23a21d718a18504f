//! Where the surface of a wall is, seen from a particle.

use crate::boundary::{Boundary, Shear};
use mps_kernel::{Kernel, Neighborhood, Pair, Real, Vector};
use mps_neighbors::{Domain, RowView};

/// The surface of the walls of one kind, as a particle sees it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<T: Real, const D: usize> {
    /// Direction towards the wall: that of `sum_a V_a e_ia W_ia/r`.
    pub(crate) toward: Vector<T, D>,
    /// How far away it is \[m\]: it lies half the spacing of the nearest point before that.
    pub(crate) distance: T,
}

/// The points of one kind among those that a particle sees.
pub(crate) struct Seen<'a, T: Real, const D: usize, K, P> {
    /// The particle.
    pub(crate) i: usize,
    pub(crate) walls: &'a RowView<'a, T, D, K, P>,
    pub(crate) boundary: &'a Boundary<T, D>,
    pub(crate) shear: Shear,
    /// Spacing of the fluid \[m\].
    pub(crate) spacing: T,
}

impl<T: Real, const D: usize, K: Kernel<T>, P: Domain<T, D>> Seen<'_, T, D, K, P> {
    /// Visits the points.
    pub(crate) fn for_each(&self, mut visit: impl FnMut(&Pair<T, D>)) {
        self.walls.for_each(self.i, |pair| {
            if self.boundary.shear[pair.j] == self.shear {
                visit(pair);
            }
        });
    }

    /// `V_a e_ia W_ia/r` of a point \[1/m\].
    pub(crate) fn pull(&self, pair: &Pair<T, D>) -> Vector<T, D> {
        pair.gradient_vector() * self.boundary.volume[pair.j]
    }

    /// Direction towards the points that `count`; `None` where there are none, or where they are all around.
    pub(crate) fn toward(&self, counts: impl Fn(&Pair<T, D>) -> bool) -> Option<Vector<T, D>> {
        let mut lean = Vector::<T, D>::zeros();
        self.for_each(|pair| {
            if counts(pair) {
                lean += self.pull(pair);
            }
        });
        let norm = lean.norm();
        (norm > T::zero()).then(|| lean / norm)
    }

    /// The surface in the direction `toward`. Its distance is looked for among the points that count, told how far they are along the direction
    /// \[m\].
    pub(crate) fn surface(
        &self,
        toward: Vector<T, D>,
        mut counts: impl FnMut(T, &Pair<T, D>) -> bool,
    ) -> Surface<T, D> {
        let mut distance = self.walls.radius;
        // Most walls have points of one size: the root is not taken anew for every pair.
        let (mut volume, mut half) = (T::zero(), T::zero());
        self.for_each(|pair| {
            let along = toward.dot(&pair.r_ij);
            if counts(along, pair) {
                if self.boundary.volume[pair.j] != volume {
                    volume = self.boundary.volume[pair.j];
                    half = volume.powf(T::one() / T::of(D as f64)) * self.spacing * T::of(0.5);
                }
                distance = distance.min(along - half);
            }
        });
        Surface { toward, distance }
    }
}
