//! What the sweeps of a step leave behind and read of each other.

use mps_kernel::{Real, Tensor, Vector};
use mps_neighbors::{NeighborError, Permutation, Placed};

/// What the sweeps of a step leave behind, one entry a particle. Rebuilt in every step, hence
/// neither permuted nor saved, but for the packing, which is measured on request and permuted.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rates<T: Real, const D: usize> {
    /// What the momentum sweep reads of a neighbour.
    pub(crate) state: Vec<State<T, D>>,
    /// What the density sweep reads of a neighbour.
    pub(crate) flow: Vec<Flow<T, D>>,
    /// Acceleration \[m/s^2\].
    pub(crate) acceleration: Vec<Vector<T, D>>,
    /// Sum of weights over `n0` \[-\], from positions alone; empty until it is measured.
    pub(crate) packing: Vec<T>,
    /// `(D/n0) sum e_ij W_ij/r` \[1/m\]: zero inside, points into the fluid at its surface. Measured with
    /// the packing.
    pub(crate) asymmetry: Vec<Vector<T, D>>,
    /// Rate of `n/n0` \[1/s\], or any scalar scratch.
    pub(crate) density_rate: Vec<T>,
    /// `C_i` of the corrected pressure; empty in the plain form.
    pub(crate) pressure_correction: Vec<Tensor<T, D>>,
    /// `S_i = (p_i n0/n_i) C_i` \[Pa\]; empty in the plain form.
    pub(crate) stress: Vec<Tensor<T, D>>,
    /// Where the wall is to which the fluid sticks: see [`WallShear`](crate::shear::WallShear). Empty if it has never stuck to one.
    pub(crate) toward_wall: Vec<Vector<T, D>>,
    /// The same of a second wall on the other side, in narrow gaps.
    pub(crate) wall_behind: Vec<Vector<T, D>>,
    /// Drag by the law of the wall, likewise. Empty if there has never been such a wall.
    pub(crate) wall_drag: Vec<Vector<T, D>>,
    /// Velocity or position change of the regularisation, in its units; empty without any.
    pub(crate) correction: Vec<Vector<T, D>>,
}

/// The fields of one particle side by side, so that a sweep fetches one piece of memory a pair.
///
/// Aligned, so that its size is a multiple of 16: the address of a neighbour takes two instructions and not four.
#[derive(Clone, Copy, Debug)]
#[repr(align(16))]
pub(crate) struct State<T: Real, const D: usize> {
    pub(crate) position: Vector<T, D>,
    pub(crate) velocity: Vector<T, D>,
    /// `n/n0`.
    pub(crate) density: T,
    /// `p n0/n` \[Pa\].
    pub(crate) share: T,
}

/// As [`State`], for the second sweep: the velocity is the new one.
#[derive(Clone, Copy, Debug)]
#[repr(align(16))]
pub(crate) struct Flow<T: Real, const D: usize> {
    pub(crate) position: Vector<T, D>,
    pub(crate) velocity: Vector<T, D>,
    /// Corrected gradient of `n/n0` \[1/m\] (eq. 21).
    pub(crate) gradient: Vector<T, D>,
    /// `n/n0`.
    pub(crate) density: T,
}

impl<T: Real, const D: usize> Placed<T, D> for State<T, D> {
    #[inline(always)]
    fn place(&self) -> &Vector<T, D> {
        &self.position
    }
}

impl<T: Real, const D: usize> Placed<T, D> for Flow<T, D> {
    #[inline(always)]
    fn place(&self) -> &Vector<T, D> {
        &self.position
    }
}

impl<T: Real, const D: usize> Rates<T, D> {
    pub(crate) fn resize(&mut self, len: usize) {
        let (zero, density) = (Vector::zeros(), T::one());
        self.state.resize(len, State { position: zero, velocity: zero, density, share: T::zero() });
        self.flow.resize(len, Flow { position: zero, velocity: zero, gradient: zero, density });
        self.acceleration.resize(len, Vector::zeros());
        self.density_rate.resize(len, T::zero());
        // What not every fluid needs is left to those who do; a packing that has been measured stays one a particle.
        if !self.packing.is_empty() {
            self.resize_packing(len);
        }
    }

    /// Room for the packing and its asymmetry, which whoever measures them asks for.
    pub(crate) fn resize_packing(&mut self, len: usize) {
        self.packing.resize(len, T::zero());
        self.asymmetry.resize(len, Vector::zeros());
    }

    /// Lets the measures of packing follow the particles into a new order: they are shown until they are measured again.
    pub(crate) fn reorder(
        &mut self,
        permutation: &mut Permutation,
        order: &[u32],
    ) -> Result<(), NeighborError> {
        if self.packing.is_empty() {
            return Ok(());
        }
        self.resize_packing(order.len());
        permutation.apply_to(&mut self.packing, order)?;
        permutation.apply_to(&mut self.asymmetry, order)
    }
}
