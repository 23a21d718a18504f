//! The second sweep of a step: the rate of the number density.

use crate::gather::Gather;
use crate::rates::Flow;
use crate::terms::{Viscosity, WallPair};
use crate::{Boundary, Diffusion, Fluid};
use fearless_simd::Simd;
use mps_kernel::operators::{DiffusionFilter, Divergence, HydrostaticDiffusion};
use mps_kernel::small::{difference, dot, transform};
use mps_kernel::{Kernel, Lanes, Neighborhood, Number, Pair, Real, Tensor, Vector};
use mps_neighbors::{Domain, Parallel, RowView, Sweep};

/// Values of the constant `DIFFUSION`: what a sweep is compiled for.
const NONE: u8 = 0;
const FILTER: u8 = 1;
const HYDROSTATIC: u8 = 2;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// `Dn/Dt = n (-div u + Dm)` (eqs. 18-20, 23) with the velocities of the end of the step.
    pub(crate) fn sweep_density(&mut self, parallel: &Parallel) {
        let corrected = !self.rates.pressure_correction.is_empty();
        match (self.config.diffusion, corrected) {
            (Diffusion::None, false) => self.sweep_density_with::<NONE, false>(parallel),
            (Diffusion::None, true) => self.sweep_density_with::<NONE, true>(parallel),
            (Diffusion::Filter { .. }, false) => self.sweep_density_with::<FILTER, false>(parallel),
            (Diffusion::Filter { .. }, true) => self.sweep_density_with::<FILTER, true>(parallel),
            (Diffusion::Hydrostatic, false) => self.sweep_density_with::<HYDROSTATIC, false>(parallel),
            (Diffusion::Hydrostatic, true) => self.sweep_density_with::<HYDROSTATIC, true>(parallel),
        }
    }

    /// What the sum of the diffusion is multiplied with \[m^2/s\]: `Dm = delta l0 c/n0 <laplace n>` with the filter (eqs. 19, 20), and
    /// `l0 c/n0 <laplace n>` with the other. The papers have `dt c^2` in the place of `l0 c`, which is the same at a Courant number of 1
    /// and leaves nothing of the diffusion in short steps; this is that of Antuono et al. 2010, of the same strength in any step.
    pub(crate) fn diffusivity(&self) -> T {
        let two = T::of(2.0) * self.reference.gradient_factor::<D>();
        self.config.spacing
            * self.config.sound_speed
            * match self.config.diffusion {
                Diffusion::None => T::zero(),
                Diffusion::Filter { delta } => delta * two,
                Diffusion::Hydrostatic => two / self.reference.lambda0,
            }
    }

    /// Slope of `n/n0` in a fluid at rest \[1/m\].
    pub(crate) fn hydrostatic_slope(&self) -> Vector<T, D> {
        self.config.gravity / (self.config.sound_speed * self.config.sound_speed)
    }

    fn sweep_density_with<const DIFFUSION: u8, const CORRECTED: bool>(&mut self, parallel: &Parallel) {
        let mut rate = core::mem::take(&mut self.rates.density_rate);
        let factor = self.reference.gradient_factor::<D>();
        let sweep = Continuity::<_, D, _, _, DIFFUSION, CORRECTED> {
            neighbors: self.view(&self.search.fluid),
            walls: self.boundary_view(),
            flow: &self.rates.flow,
            correction: &self.rates.pressure_correction,
            pressure: &self.particles.pressure,
            boundary: &self.boundary,
            wall: self.wall_pair(),
            factor,
            diffusion: self.diffusivity(),
            slope: self.hydrostatic_slope(),
        };
        parallel.sweep(rate.as_mut_slice(), &sweep);
        self.rates.density_rate = rate;
    }
}

/// A boundary point shows the mirrored velocity `2 u_a - u_i`, hence twice the difference.
///
/// This is what makes the exchange with a boundary conservative: the pair force is twice the
/// pressure of the fluid particle, its power `2 V p_i (u_a - u_i) . g_ia` is exactly the energy of
/// compression that the particle gains by this divergence and the structure gives by its motion.
pub(crate) const MIRROR: f64 = 2.0;

/// What [`Fluid::sweep_density`] does to one particle.
struct Continuity<'a, T: Real, const D: usize, K, P, const DIFFUSION: u8, const CORRECTED: bool> {
    neighbors: RowView<'a, T, D, K, P>,
    walls: RowView<'a, T, D, K, P>,
    flow: &'a [Flow<T, D>],
    /// `C_i` of the corrected form, empty for the plain one.
    correction: &'a [Tensor<T, D>],
    pressure: &'a [T],
    boundary: &'a Boundary<T, D>,
    wall: WallPair<T, D>,
    /// `D/n0`.
    factor: T,
    /// What the diffusion filter is multiplied with \[m^2/s\].
    diffusion: T,
    /// Slope of `n/n0` in a fluid at rest \[1/m\].
    slope: Vector<T, D>,
}

impl<T: Real, const D: usize, K, P, const DIFFUSION: u8, const CORRECTED: bool>
    Continuity<'_, T, D, K, P, DIFFUSION, CORRECTED>
where
    K: Kernel<T>,
    P: Domain<T, D>,
{
    /// `(u_j - u_i) . C_i e_ij W_ij/r`, without `C_i` in the plain form.
    #[inline(always)]
    fn opening<N: Number<T>, J>(
        &self,
        i: usize,
        own: &Flow<T, D>,
        uj: &Vector<N, D>,
        pair: &Pair<N, D, J>,
    ) -> N {
        if CORRECTED {
            dot(&difference(uj, &own.velocity), &transform(&self.correction[i], &pair.gradient_vector()))
        } else {
            Divergence::pair(&own.velocity, uj, pair)
        }
    }

    #[inline(always)]
    fn through_walls(&self, i: usize, own: &Flow<T, D>) -> T {
        let mut inflow = T::zero();
        self.walls.for_each(i, |pair| {
            let a = pair.j;
            let (_, na) =
                self.wall.state(self.pressure[i], own.density, &self.boundary.acceleration[a], &pair.r_ij);
            let opening = self.opening(i, own, &self.boundary.velocity[a], pair);
            inflow -= na * self.boundary.volume[a] * T::of(MIRROR) * opening;
        });
        inflow
    }
}

impl<'b, T: Real, const D: usize, K, P, const DIFFUSION: u8, const CORRECTED: bool> Sweep<&'b mut [T]>
    for Continuity<'_, T, D, K, P, DIFFUSION, CORRECTED>
where
    K: Kernel<T>,
    P: Domain<T, D>,
{
    #[inline(always)]
    fn visit<S: Simd>(&self, simd: S, i: usize, rate: &'b mut T) {
        let flow = self.flow;
        let own = flow[i];
        let zero = T::Lanes::splat(simd, T::zero());
        let (mut inflow, mut filtered) = (zero, zero);
        for pair in self.neighbors.packs_of(simd, i, flow) {
            let other = Gather { simd, j: pair.j.as_ref(), from: flow };
            let density = other.scalar(|flow| flow.density);
            // n_i times eq. 23: the n_i cancels.
            let opening = self.opening(i, &own, &other.vector(|flow| &flow.velocity), &pair);
            inflow -= density * opening;
            if DIFFUSION == HYDROSTATIC {
                filtered += HydrostaticDiffusion::pair(own.density, density, &self.slope, &pair);
            }
            if DIFFUSION == FILTER {
                let gradient = other.vector(|flow| &flow.gradient);
                filtered += DiffusionFilter::pair(own.density, &own.gradient, density, &gradient, &pair);
            }
        }
        let mut inflow = inflow.sum();
        if !self.boundary.is_empty() {
            inflow += self.through_walls(i, &own);
        }
        *rate = inflow * self.factor + own.density * self.diffusion * filtered.sum();
    }
}
