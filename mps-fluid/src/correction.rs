//! The corrected form of the pressure gradient and of the divergence.
//!
//! The plain sums of eqs. 23 and 24 see a strained lattice: the pressure of a particle is multiplied by
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

use crate::terms::Viscosity;
use crate::{Fluid, PressureForm};
use mps_kernel::operators::{Corrected, MomentMatrix, invert_moment};
use mps_kernel::{Kernel, Neighborhood, Real, Tensor, Vector};
use mps_neighbors::{Domain, Parallel};

/// Below this measure of the moment matrix the plain form is used
/// ([`invert_moment`]): few neighbours on a line.
const DEGENERATE: f64 = 0.3;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// `C_i` of all particles for their present positions and densities; none for the plain form.
    pub(crate) fn sweep_correction(&mut self, parallel: &Parallel) {
        if self.config.pressure_form == PressureForm::Plain {
            return;
        }
        let mut correction = core::mem::take(&mut self.rates.pressure_correction);
        correction.resize(self.particles.position.len(), Tensor::identity());
        let neighbors = self.view(&self.search.fluid);
        let walls = self.boundary_view();
        let volume = &self.boundary.volume;
        let state = &self.rates.state;
        let factor = self.reference.gradient_factor::<D>();
        parallel.update(correction.as_mut_slice(), |i, correction| {
            let mut moment = Tensor::<T, D>::zeros();
            neighbors.for_each(i, |pair| {
                moment += MomentMatrix::pair(pair) * (state[pair.j].density * state[i].inverse_density);
            });
            if !volume.is_empty() {
                walls.for_each(i, |pair| moment += MomentMatrix::pair(pair) * volume[pair.j]);
            }
            let corrected: Corrected<T, D> = invert_moment(&(moment * factor), T::of(DEGENERATE));
            *correction = corrected.matrix();
        });
        self.rates.pressure_correction = correction;
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
