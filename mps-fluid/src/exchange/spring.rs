//! The fluid as a spring at the surface of a structure.

use super::Link;
use crate::terms::Viscosity;
use crate::{Fluid, FluidConfig};
use core::ops::Range;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::Domain;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// The spring that the fluid is to reactive point `a`, at most \[N/m\]. Displacements `q_b` of points compress the particles and bring back
    /// the forces `-sum_b K_ab q_b` with
    ///
    /// `K_ab = 4 (D/n0)^2 V rho0 c^2 sum_i g_ia (x) g_ib`, `g_ia = V_a e_ia W_ia/r`.
    ///
    /// Returned is `sum_b |K_ab|`, a bound for any motion of all structures. Of the last [`begin_step`](Fluid::begin_step); zero before the first, and for
    /// points that are not reactive.
    pub fn interface_stiffness(&self, a: usize) -> T {
        let exchange = &self.exchange;
        let Some(k) = self.reactive_number(a) else { return T::zero() };
        if exchange.point_start.len() <= k + 1 {
            return T::zero();
        }
        let links = exchange.point_start[k] as usize..exchange.point_start[k + 1] as usize;
        let size = |link: &Link<T, D>| link.vector.norm() * exchange.reach[link.other as usize];
        exchange.point_links[links].iter().fold(T::zero(), |sum, link| sum + size(link))
            * self.spring_factor()
    }

    /// The same for a body that moves as a whole and does not turn: the trace of `sum_ab K_ab` over its reactive points `body` \[N/m\]. Other
    /// bodies are not in it.
    pub fn interface_stiffness_of(&self, body: &Range<usize>) -> T {
        let (exchange, first) = (&self.exchange, self.boundary.reactive().start);
        let of_particle = |at: &[u32]| {
            let links = &exchange.wetted_links[at[0] as usize..at[1] as usize];
            let own = links.iter().filter(|link| body.contains(&(first + link.other as usize)));
            own.fold(Vector::<T, D>::zeros(), |sum, link| sum + link.vector).norm_squared()
        };
        let sum = exchange.wetted_start.windows(2).fold(T::zero(), |sum, at| sum + of_particle(at));
        sum * self.spring_factor()
    }

    /// `4 (D/n0)^2 V rho0 c^2`.
    fn spring_factor(&self) -> T {
        let pair = T::of(2.0) * self.reference.gradient_factor::<D>();
        let FluidConfig { density, sound_speed, .. } = self.config;
        pair * pair * self.config.particle_volume() * density * sound_speed * sound_speed
    }
}
