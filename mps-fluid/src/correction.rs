//! The corrected form of the pressure gradient and of the divergence.
//!
//! With a weight that peaks at zero distance the plain sums of eqs. 23 and 24 see a strained lattice: the pressure of a particle is multiplied by
//! its moment matrix `M_i = (D/n0) sum_j (n_j/n_i) e_ij e_ij W_ij`, the identity only on the upright
//! lattice. A pressure `p` then resists shear with a modulus in proportion to `p`, at any resolution: the
//! fluid is a soft solid. With `C_i`, the inverse of `M_i`, and `S_i = (p_i/n_i) C_i`,
//!
//! `grad p = (D/n0) sum_j (n_j S_i + n_i S_j) e_ij W_ij/r`,
//! `div u = (D/n0) sum_j (n_j/n_i) (u_j - u_i) . C_i e_ij W_ij/r`
//!
//! the pressure of a particle is a pressure, and a divergence is exact for linear velocities (Bonet and
//! Lok 1999 for smoothed particles). The two are still each other's negative adjoint, so energy is
//! kept; pair forces are still opposite; and although they no longer act along the line of the pair, the torques of
//! each particle's share cancel, because `C_i M_i` is symmetric: angular momentum is kept to round-off.
//!
//! What is lost is the tendency of the plain form to even out the particles, which came from the same
//! resistance: flows that stir need shifting.

use crate::gather::Gather;
use crate::rates::State;
use crate::terms::Viscosity;
use crate::{Fluid, PressureForm};
use fearless_simd::Simd;
use mps_kernel::operators::{Corrected, MomentMatrix, invert_moment};
use mps_kernel::small::{accumulate_symmetric, columns, scale, symmetric, tensor};
use mps_kernel::{Kernel, Lanes, Neighborhood, Real, Tensor, Vector, by_axes};
use mps_neighbors::{Domain, Parallel, RowView, Sweep};

/// Below this measure of the moment matrix the plain form is used
/// ([`invert_moment`]): few neighbours on a line.
const DEGENERATE: f64 = 0.3;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// `C_i` and `S_i` of all particles for their present positions, densities and pressures; none for the plain form.
    pub(crate) fn sweep_correction(&mut self, parallel: &Parallel) {
        if self.config.pressure_form == PressureForm::Plain {
            return;
        }
        let mut correction = core::mem::take(&mut self.rates.pressure_correction);
        let mut stress = core::mem::take(&mut self.rates.stress);
        correction.resize(self.particles.position.len(), Tensor::identity());
        stress.resize(self.particles.position.len(), Tensor::zeros());
        let sweep = Correction {
            neighbors: self.view(&self.search.fluid),
            walls: self.boundary_view(),
            volume: &self.boundary.volume,
            state: &self.rates.state,
            factor: self.reference.gradient_factor::<D>(),
        };
        parallel.sweep((correction.as_mut_slice(), stress.as_mut_slice()), &sweep);
        self.rates.pressure_correction = correction;
        self.rates.stress = stress;
    }

    /// `C_i` times a vector; the vector itself in the plain form.
    #[inline]
    pub(crate) fn corrected(&self, i: usize, vector: Vector<T, D>) -> Vector<T, D> {
        match self.rates.pressure_correction.get(i) {
            Some(matrix) => matrix * vector,
            None => vector,
        }
    }
}

/// What [`Fluid::sweep_correction`] does to one particle.
struct Correction<'a, T: Real, const D: usize, K, P> {
    neighbors: RowView<'a, T, D, K, P>,
    walls: RowView<'a, T, D, K, P>,
    /// Volumes of the boundary points over that of a particle \[-\].
    volume: &'a [T],
    state: &'a [State<T, D>],
    /// `D/n0`.
    factor: T,
}

impl<'b, T: Real, const D: usize, K, P> Sweep<(&'b mut [Tensor<T, D>], &'b mut [Tensor<T, D>])>
    for Correction<'_, T, D, K, P>
where
    K: Kernel<T>,
    P: Domain<T, D>,
{
    #[inline(always)]
    fn visit<S: Simd>(
        &self,
        simd: S,
        i: usize,
        (correction, stress): (&'b mut Tensor<T, D>, &'b mut Tensor<T, D>),
    ) {
        let zero = T::Lanes::splat(simd, T::zero());
        let mut moment = tensor([[zero; D]; D]);
        let State { density, share, .. } = self.state[i];
        let inverse_density = T::one() / density;
        for pair in self.neighbors.packs_of(simd, i, self.state) {
            let other = Gather { simd, j: pair.j.as_ref(), from: self.state };
            let ratio = other.scalar(|state| state.density) * inverse_density;
            let weighted = scale(&pair.r_ij, pair.over_r2 * ratio);
            accumulate_symmetric(&mut moment, &weighted, &pair.r_ij);
        }
        let moment = symmetric(&moment);
        let mut moment: Tensor<T, D> = by_axes!((row, column) => columns(&moment)[column][row].sum());
        if !self.volume.is_empty() {
            self.walls.for_each(i, |pair| moment += MomentMatrix::<T>::pair(pair) * self.volume[pair.j]);
        }
        let corrected: Corrected<T, D> = invert_moment(&(moment * self.factor), T::of(DEGENERATE));
        *correction = corrected.matrix();
        *stress = *correction * share;
    }
}
