//! The Laplacian from forces along the line of each pair, and what truncated neighbourhoods lack of it.
//!
//! For a velocity that is linear around a pair, `u_j - u_i = G r_ij`, the pair loses energy in proportion to `(e . E e)^2 W_ij`, where `E`
//! is the rate of strain; averaged over all directions that is in proportion to `E : E`, and the sum over a full neighbourhood is the loss
//! `2 nu E : E` of a viscous fluid. A sum of losses needs nothing at a free surface: what makes the loss least
//! is a surface without stress. (The weights of the Laplacian, `(u_j - u_i)^2`, add up to `|G|^2`, and their natural surface
//! is one without `du/dn`.)
//!
//! Nearer to the surface than the radius the sum is short of neighbours, and so is the loss: as if viscosity were missing in a layer of a sixth of
//! the radius. But `(e . E e)^2` is the same for `e` and `-e`, so that half a neighbourhood has exactly half the loss,
//! whatever the strain. Dividing the share of each particle by `k_i`, the sum of its weights over `n0`, restores it; a
//! pair then has the mean of `1/k_i` and `1/k_j` and its forces stay opposite and along its line. Between the surface and the radius
//! the missing cap is not isotropic, and what remains is of either sign.
//!
//! Pinned by `tests/properties/surface_strain.rs`.

use crate::small::{difference, dot, scale};
use crate::{Number, Pair, PairOperator, Real, Vector};

/// Below this share of the weights a neighbourhood is completed no further: a corner of fluid in two dimensions. Spray has no
/// neighbourhood to complete.
const LEAST: f64 = 0.25;

/// `(2 D (D + 2)/n0) sum_j ((u_j - u_i) . e_ij) e_ij W_ij/r^2`: `laplace u + 2 grad div u`, hence the Laplacian of a field without
/// divergence. The viscous term of Monaghan and Gingold (1983, J. Comput. Phys. 52, 374-389), written with the weight of this method;
/// its loss under a free surface: Colagrossi, Antuono, Souto-Iglesias and Le Touze (2011, Phys. Rev. E 84, 026705).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CentralLaplacian<T> {
    /// `2 D (D + 2)/n0` \[-\], or what it is multiplied with.
    pub factor: T,
}

impl<T: Real> CentralLaplacian<T> {
    /// What neighbour `j` adds.
    #[inline(always)]
    pub fn pair<N, const D: usize, J>(
        &self,
        fi: &Vector<T, D>,
        fj: &Vector<N, D>,
        pair: &Pair<N, D, J>,
    ) -> Vector<N, D>
    where
        N: Number<T>,
    {
        // The quotient is the one the rational weight forms: the compiler divides once.
        let approach = dot(&difference(fj, fi), &pair.r_ij) * pair.r2.dividing(T::one());
        scale(&pair.r_ij, approach * self.factor * pair.over_r2)
    }

    /// `1/k_i` \[-\]: what the share of a particle is multiplied with whose weights sum up to `k_i` times `n0`, 4 at most.
    pub fn completion(k: T) -> T {
        T::one() / k.max(T::of(LEAST))
    }
}

impl<T: Real, const D: usize> PairOperator<T, D, Vector<T, D>> for CentralLaplacian<T> {
    type Output = Vector<T, D>;

    fn zero(&self) -> Self::Output {
        Vector::zeros()
    }

    #[inline(always)]
    fn add(&self, sum: &mut Self::Output, fi: &Vector<T, D>, fj: &Vector<T, D>, pair: &Pair<T, D>) {
        *sum += self.pair(fi, fj, pair);
    }

    fn finish(&self, sum: Self::Output) -> Self::Output {
        sum
    }
}
