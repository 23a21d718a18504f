//! The reference pairs of a solid: found once, kept for ever, with their geometry.

use crate::{Cells, NeighborError, Open, Parallel, Rows};
use mps_kernel::{Kernel, Neighborhood, Pair, Real, Vector};
use thiserror::Error;

/// One directed pair of the reference state.
///
/// Holds what a sweep needs and nothing else: 32 bytes in 2D, 40 in 3D (`f64`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrozenPair<T: Real, const D: usize> {
    /// `r0_ij = X_j - X_i` \[m\]. Bitwise `-r0_ji`.
    pub r0_ij: Vector<T, D>,
    /// `W_ij / |r0_ij|^2` \[1/m^2\]. Bitwise the value of the pair `(j, i)`.
    pub over_r2: T,
    /// Index of the neighbour.
    pub j: u32,
}

/// The neighbours of every particle in the reference state, ascending in `j`.
///
/// Distances are measured in units of the spacing of each axis, `q_a = r0_a / l_a`, and made a length
/// again by the geometric mean `l0` of the spacings. On a lattice whose spacings differ a little (a beam
/// of 0.02 m by 0.35 m in whole particles) every particle then has exactly the neighbours and the
/// weights it would have on the square lattice; for equal spacings it is the ordinary distance.
///
/// ```
/// use mps_kernel::{Vector, weights::WendlandC2};
/// use mps_neighbors::FrozenPairs;
///
/// let points: Vec<_> = (0..12).map(|k| Vector::<f64, 2>::new((k % 4) as f64, (k / 4) as f64)).collect();
/// let pairs = FrozenPairs::build(&points, &Vector::<f64, 2>::repeat(1.0), &WendlandC2, 1.6)?;
/// assert_eq!(pairs.row(5).len(), 8);
/// assert_eq!(pairs.row(0).iter().map(|pair| pair.j).collect::<Vec<_>>(), [1, 4, 5]);
/// # Ok::<(), mps_neighbors::FrozenError>(())
/// ```
#[derive(Clone, Debug)]
pub struct FrozenPairs<T: Real, const D: usize> {
    starts: Vec<u32>,
    pairs: Vec<FrozenPair<T, D>>,
    /// `l0 / l_a`: multiplies a component of `r0` before its length is taken.
    metric: Vector<T, D>,
}

/// Why no reference pairs could be made.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FrozenError {
    /// The search refused the positions, for example because one is NaN.
    #[error("reference positions: {0}")]
    Search(#[from] NeighborError),
    /// The spacing is not positive and finite.
    #[error("spacing of axis {axis} must be positive and finite, got {value} m")]
    Spacing {
        /// The axis.
        axis: usize,
        /// The refused spacing \[m\].
        value: f64,
    },
    /// The radius is not positive and finite.
    #[error("radius must be positive and finite, got {0} spacings (usual for the solid: 1.6)")]
    Radius(f64),
    /// Two particles lie on the same point.
    #[error(
        "particles {first} and {second} have the same reference position: remove one (do two blocks overlap?)"
    )]
    Coincident {
        /// The particle with the smaller index.
        first: usize,
        /// The other one.
        second: usize,
    },
    /// More pairs than the index type can count.
    #[error("the body has more than 4294967295 pairs: use fewer particles")]
    TooMany,
}

impl<T: Real, const D: usize> FrozenPairs<T, D> {
    /// Finds all pairs closer than `radius` spacings and weighs them with `kernel`.
    ///
    /// `spacing` is the particle distance along each axis \[m\].
    ///
    /// # Errors
    /// If a position is not finite, two of them coincide, or the spacing or radius is not positive.
    pub fn build<K: Kernel<T>>(
        points: &[Vector<T, D>],
        spacing: &Vector<T, D>,
        kernel: &K,
        radius: T,
    ) -> Result<Self, FrozenError> {
        for (axis, value) in spacing.iter().map(|l| l.to_double()).enumerate() {
            if !(value.is_finite() && value > 0.0) {
                return Err(FrozenError::Spacing { axis, value });
            }
        }
        if !(radius.is_finite() && radius > T::zero()) {
            return Err(FrozenError::Radius(radius.to_double()));
        }
        let mean = spacing.iter().fold(T::one(), |product, l| product * *l).powf(T::of(1.0 / D as f64));
        let metric = spacing.map(|l| mean / l);
        let reach = radius * mean;
        let scaled: Vec<_> = points.iter().map(|x| x.component_mul(&metric)).collect();
        let (parallel, mut cells, mut rows) = (Parallel::serial(), Cells::new(), Rows::default());
        cells.build(&parallel, &Open, &scaled, reach)?;
        rows.build_within(&parallel, &Open, &cells, &scaled, reach)?;

        let mut frozen = Self { starts: vec![0], pairs: Vec::new(), metric };
        for (i, point) in points.iter().enumerate() {
            for &j in rows.row(i) {
                let r0_ij = points[j as usize] - point;
                let r2 = metric.component_mul(&r0_ij).norm_squared();
                if r2 == T::zero() {
                    let j = j as usize;
                    return Err(FrozenError::Coincident { first: i.min(j), second: i.max(j) });
                }
                let (weight, over_r2) = kernel.weight_and_over_r2(r2, reach);
                if weight > T::zero() {
                    frozen.pairs.push(FrozenPair { r0_ij, over_r2, j });
                }
            }
            frozen.starts.push(u32::try_from(frozen.pairs.len()).map_err(|_| FrozenError::TooMany)?);
        }
        Ok(frozen)
    }

    /// The pairs of particle `i`, ascending in `j`.
    #[inline(always)]
    pub fn row(&self, i: usize) -> &[FrozenPair<T, D>] {
        &self.pairs[self.starts[i] as usize..self.starts[i + 1] as usize]
    }

    /// Number of directed pairs of all particles.
    pub fn pair_count(&self) -> usize {
        self.pairs.len()
    }
}

impl<T: Real, const D: usize> Neighborhood<T, D> for FrozenPairs<T, D> {
    fn len(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    #[inline]
    fn for_each(&self, i: usize, mut visit: impl FnMut(&Pair<T, D>)) {
        for pair in self.row(i) {
            let r2 = self.metric.component_mul(&pair.r0_ij).norm_squared();
            visit(&Pair {
                j: pair.j as usize,
                r_ij: pair.r0_ij,
                r2,
                weight: pair.over_r2 * r2,
                over_r2: pair.over_r2,
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mps_kernel::weights::WendlandC2;

    /// A lattice with spacing `l`, shaken a little.
    fn lattice(counts: [usize; 2], l: [f64; 2]) -> Vec<Vector<f64, 2>> {
        let shake = |k: usize| ((k * 7919 % 101) as f64 / 101.0 - 0.5) * 0.1;
        (0..counts[0] * counts[1])
            .map(|k| {
                let (x, y) = ((k % counts[0]) as f64, (k / counts[0]) as f64);
                Vector::<f64, 2>::new((x + shake(k)) * l[0], (y + shake(k + 50)) * l[1])
            })
            .collect()
    }

    #[test]
    fn rows_are_those_of_all_pairs_and_symmetric_bit_by_bit() {
        let points = lattice([13, 9], [0.01, 0.01]);
        let spacing = Vector::<f64, 2>::repeat(0.01);
        let frozen = FrozenPairs::build(&points, &spacing, &WendlandC2, 2.1).unwrap();
        for i in 0..points.len() {
            let expected: Vec<u32> = (0..points.len())
                .filter(|&j| j != i && (points[j] - points[i]).norm() < 0.021)
                .map(|j| j as u32)
                .collect();
            assert_eq!(frozen.row(i).iter().map(|pair| pair.j).collect::<Vec<_>>(), expected);
            for pair in frozen.row(i) {
                let back = frozen.row(pair.j as usize).iter().find(|back| back.j as usize == i).unwrap();
                assert_eq!((back.r0_ij, back.over_r2), (-pair.r0_ij, pair.over_r2));
            }
        }
    }

    #[test]
    fn a_stretched_lattice_has_the_neighbours_and_weights_of_the_square_one() {
        let square = FrozenPairs::build(
            &lattice([8, 6], [1.0, 1.0]),
            &Vector::<f64, 2>::repeat(1.0),
            &WendlandC2,
            1.6,
        )
        .unwrap();
        let (lx, ly) = (1.05, 1.0 / 1.05);
        let points = lattice([8, 6], [lx, ly]);
        let stretched =
            FrozenPairs::build(&points, &Vector::<f64, 2>::new(lx, ly), &WendlandC2, 1.6).unwrap();
        assert_eq!(square.pair_count(), stretched.pair_count());
        for i in 0..points.len() {
            for (a, b) in square.row(i).iter().zip(stretched.row(i)) {
                assert_eq!(a.j, b.j);
                assert!((a.over_r2 - b.over_r2).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn the_neighborhood_of_operators_tells_the_same() {
        let points = lattice([5, 5], [0.1, 0.1]);
        let spacing = Vector::<f64, 2>::repeat(0.1);
        let frozen = FrozenPairs::build(&points, &spacing, &WendlandC2, 1.6).unwrap();
        assert_eq!(Neighborhood::len(&frozen), 25);
        frozen.for_each(12, |pair| {
            let expected = Pair::new(pair.j, points[pair.j] - points[12], &WendlandC2, 0.16);
            assert!((pair.weight - expected.weight).abs() < 1e-14);
            assert!((pair.r2 - expected.r2).abs() < 1e-16);
        });
    }

    #[test]
    fn unusable_bodies_are_refused() {
        let points = lattice([3, 3], [1.0, 1.0]);
        let build = |points: &[Vector<f64, 2>], spacing: f64, radius: f64| {
            FrozenPairs::build(points, &Vector::<f64, 2>::new(1.0, spacing), &WendlandC2, radius)
        };
        assert!(build(&points, 1.0, 1.6).is_ok());
        assert!(matches!(build(&points, 0.0, 1.6), Err(FrozenError::Spacing { axis: 1, .. })));
        assert!(matches!(build(&points, f64::NAN, 1.6), Err(FrozenError::Spacing { .. })));
        assert!(matches!(build(&points, 1.0, f64::NAN), Err(FrozenError::Radius(_))));
        let twice = [points.as_slice(), &points[4..5]].concat();
        let expected = FrozenError::Coincident { first: 4, second: 9 };
        assert_eq!(build(&twice, 1.0, 1.6).unwrap_err(), expected);
        let lost = [points.as_slice(), &[Vector::<f64, 2>::new(f64::NAN, 0.0)]].concat();
        assert!(matches!(build(&lost, 1.0, 1.6), Err(FrozenError::Search(_))));
    }
}
