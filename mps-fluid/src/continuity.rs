//! The second sweep of a step: the rate of the number density.

use crate::Fluid;
use crate::fluid::Flow;
use crate::terms::Viscosity;
use mps_kernel::operators::{DiffusionFilter, Divergence};
use mps_kernel::{Kernel, Neighborhood, Pair, Real, Vector};
use mps_neighbors::{Domain, Parallel};

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// `Dn/Dt = n (-div u + Dm)` (eqs. 18-20, 23) with the velocities of the end of the step.
    pub(crate) fn sweep_density(&mut self, parallel: &Parallel, dt: T) {
        let corrected = !self.rates.pressure_correction.is_empty();
        match (self.config.diffusion > T::zero(), corrected) {
            (true, false) => self.sweep_density_with::<true, false>(parallel, dt),
            (false, false) => self.sweep_density_with::<false, false>(parallel, dt),
            (true, true) => self.sweep_density_with::<true, true>(parallel, dt),
            (false, true) => self.sweep_density_with::<false, true>(parallel, dt),
        }
    }

    fn sweep_density_with<const DIFFUSION: bool, const CORRECTED: bool>(
        &mut self,
        parallel: &Parallel,
        dt: T,
    ) {
        let mut rate = core::mem::take(&mut self.rates.density_rate);
        let neighbors = self.view(&self.search.fluid);
        let walls = self.boundary_view();
        let wall = self.wall_pair();
        let boundary = &self.boundary;
        let correction = &self.rates.pressure_correction;
        let (p, flow) = (&self.particles.pressure, &self.rates.flow);
        let factor = self.reference.gradient_factor::<D>();
        let c = self.config.sound_speed;
        // Dm = delta dt c^2 / n0 <laplace n>, and <laplace n> carries 2 D/n0 (eqs. 19, 20).
        let diffusion = self.config.diffusion * dt * c * c * T::of(2.0) * factor;
        let mirror = T::of(MIRROR);
        let has_walls = !boundary.is_empty();

        parallel.update(rate.as_mut_slice(), |i, rate| {
            let Flow { velocity: ui, gradient: gi, density: ni } = flow[i];
            let mut inflow = T::zero();
            // (u_a - u_i) . C_i e_ia W_ia/r, without C_i in the plain form.
            let divergence = |ua: &Vector<T, D>, pair: &Pair<T, D>| {
                if CORRECTED {
                    (ua - ui).dot(&(correction[i] * pair.gradient_vector()))
                } else {
                    Divergence::pair(&ui, ua, pair)
                }
            };
            let mut filtered = T::zero();
            neighbors.for_each(i, |pair| {
                let other = &flow[pair.j];
                // n_i times eq. 23: the n_i cancels.
                inflow -= other.density * divergence(&other.velocity, pair);
                if DIFFUSION {
                    filtered += DiffusionFilter::pair(ni, &gi, other.density, &other.gradient, pair);
                }
            });
            if has_walls {
                walls.for_each(i, |pair| {
                    let a = pair.j;
                    let (_, na) = wall.state(p[i], ni, &boundary.acceleration[a], &pair.r_ij);
                    inflow -= na * boundary.volume[a] * mirror * divergence(&boundary.velocity[a], pair);
                });
            }
            *rate = inflow * factor + ni * diffusion * filtered;
        });
        self.rates.density_rate = rate;
    }
}

/// A boundary point shows the mirrored velocity `2 u_a - u_i`, hence twice the difference.
///
/// This is what makes the exchange with a boundary conservative: the pair force is twice the
/// pressure of the fluid particle, its power `2 V p_i (u_a - u_i) . g_ia` is exactly the energy of
/// compression that the particle gains by this divergence and the structure gives by its motion.
const MIRROR: f64 = 2.0;
