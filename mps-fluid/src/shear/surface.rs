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

impl<T: Real, const D: usize> Surface<T, D> {
    /// The surface that the points with this `shear` show particle `i`; `None` away from them. Its distance is looked for among the points that
    /// count, told how far they are along the direction towards the wall \[m\].
    pub(crate) fn seen_from<K: Kernel<T>, P: Domain<T, D>>(
        i: usize,
        walls: &RowView<'_, T, D, K, P>,
        boundary: &Boundary<T, D>,
        shear: Shear,
        spacing: T,
        counts: impl Fn(T, &Pair<T, D>) -> bool,
    ) -> Option<Self> {
        let mut lean = Vector::<T, D>::zeros();
        walls.for_each(i, |pair| {
            if boundary.shear[pair.j] == shear {
                lean += pair.gradient_vector() * boundary.volume[pair.j];
            }
        });
        let norm = lean.norm();
        if norm <= T::zero() {
            return None;
        }
        let toward = lean / norm;
        let mut distance = walls.radius;
        // Most walls have points of one size: the root is not taken anew for every pair.
        let (mut volume, mut half) = (T::zero(), T::zero());
        walls.for_each(i, |pair| {
            let along = toward.dot(&pair.r_ij);
            if boundary.shear[pair.j] == shear && counts(along, pair) {
                if boundary.volume[pair.j] != volume {
                    volume = boundary.volume[pair.j];
                    half = volume.powf(T::one() / T::of(D as f64)) * spacing * T::of(0.5);
                }
                distance = distance.min(along - half);
            }
        });
        Some(Self { toward, distance })
    }
}
