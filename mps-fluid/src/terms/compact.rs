//! Laminar viscosity that leans on near neighbours.

use super::Viscosity;
use mps_kernel::operators::CompactLaplacian;
use mps_kernel::small::accumulate;
use mps_kernel::{Number, Pair, Real, ReferenceDensity, Vector};

/// `(mu/rho0) (2 D/n0) (u_j - u_i) W_ij/r^2` ([`CompactLaplacian`]), in place of the paper's eq. 16.
///
/// The paper's weight `W_ij` of the Laplacian counts far neighbours as much as near ones: shear reaches over the whole effective radius, and the
/// vorticity that a wall makes is spread over it. With `W_ij/r^2` most of it stays between next neighbours; boundary layers of one or two
/// spacings, and what separates from them, come out the better. `n0` alone makes it exact, whatever the lattice. For weights whose
/// `W/r^2` stays finite, as [`WendlandGradient`](mps_kernel::weights::WendlandGradient).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompactViscosity<T> {
    kinematic: T,
    laplacian: CompactLaplacian<T>,
}

impl<T: Real> CompactViscosity<T> {
    /// For the kinematic viscosity `mu/rho0` \[m^2/s\] on the given lattice.
    pub fn new<const D: usize>(kinematic: T, reference: &ReferenceDensity<T>) -> Self {
        let factor = kinematic * T::of(2.0) * reference.gradient_factor::<D>();
        Self { kinematic, laplacian: CompactLaplacian { factor } }
    }
}

impl<T: Real, const D: usize> Viscosity<T, D> for CompactViscosity<T> {
    #[inline(always)]
    fn add<N: Number<T>, J>(
        &self,
        sum: &mut Vector<N, D>,
        pair: &Pair<N, D, J>,
        ui: &Vector<T, D>,
        uj: &Vector<N, D>,
    ) {
        accumulate(sum, &self.laplacian.pair(ui, uj, pair));
    }

    fn kinematic(&self) -> T {
        self.kinematic
    }
}
