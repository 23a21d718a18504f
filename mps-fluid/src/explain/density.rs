//! The terms of the density sweep.

use crate::continuity::MIRROR;
use crate::terms::Viscosity;
use crate::{Diffusion, Fluid};
use mps_kernel::operators::{DiffusionFilter, HydrostaticDiffusion};
use mps_kernel::{Kernel, Neighborhood, Pair, Real, Vector};
use mps_neighbors::Domain;

/// The terms of the rate of `n/n0` \[1/s\] (eqs. 18-20, 23), with the velocities with which the step will end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DensityTerms<T> {
    /// Neighbours that come closer.
    pub fluid: T,
    /// Walls that come closer.
    pub walls: T,
    /// Structures that come closer.
    pub structures: T,
    /// Diffusion.
    pub diffusion: T,
    /// What is missing to the density that an outlet prescribes; zero away from outlets.
    pub outlet: T,
}

impl<T: Real> DensityTerms<T> {
    /// All terms with their names.
    pub fn terms(&self) -> [(&'static str, T); 5] {
        [
            ("motion of neighbours", self.fluid),
            ("motion of walls", self.walls),
            ("motion of structures", self.structures),
            ("diffusion", self.diffusion),
            ("outlet", self.outlet),
        ]
    }

    /// Sum of all terms.
    pub fn total(&self) -> T {
        self.terms().iter().fold(T::zero(), |sum, (_, term)| sum + *term)
    }
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// The velocity of particle `j` after the kick of the step \[m/s\].
    fn velocity_to_be(&self, j: usize, dt: T) -> Vector<T, D> {
        self.particles.velocity[j] + (self.rates.acceleration[j] + self.answer_to(j)) * dt
    }

    pub(super) fn density_terms(&self, i: usize, dt: T) -> DensityTerms<T> {
        let (flow, own) = (&self.rates.flow, &self.rates.flow[i]);
        let velocity = self.velocity_to_be(i, dt);
        let opening = |pair: &Pair<T, D>, other: Vector<T, D>| {
            (other - velocity).dot(&self.corrected(i, pair.gradient_vector()))
        };
        let slope = self.hydrostatic_slope();
        let zero = T::zero();
        let (mut fluid, mut walls, mut structures, mut filtered) = (zero, zero, zero, zero);
        self.view(&self.search.fluid).for_each(i, |pair| {
            let other = &flow[pair.j];
            fluid -= other.density * opening(pair, self.velocity_to_be(pair.j, dt));
            filtered += match self.config.diffusion {
                Diffusion::None => zero,
                Diffusion::Hydrostatic => {
                    HydrostaticDiffusion::pair(own.density, other.density, &slope, pair)
                }
                Diffusion::Filter { .. } => {
                    DiffusionFilter::pair(own.density, &own.gradient, other.density, &other.gradient, pair)
                }
            };
        });
        if !self.boundary.is_empty() {
            let (wall, boundary, pressure) = (self.wall_pair(), &self.boundary, self.particles.pressure[i]);
            self.boundary_view().for_each(i, |pair| {
                let a = pair.j;
                let (_, na) = wall.state(pressure, own.density, &boundary.acceleration[a], &pair.r_ij);
                let rate = na * boundary.volume[a] * T::of(MIRROR) * opening(pair, boundary.velocity[a]);
                let sum = if boundary.reactive.contains(&a) { &mut structures } else { &mut walls };
                *sum -= rate;
            });
        }
        let factor = self.reference.gradient_factor::<D>();
        let mut terms = DensityTerms {
            fluid: fluid * factor,
            walls: walls * factor,
            structures: structures * factor,
            diffusion: own.density * self.diffusivity() * filtered,
            outlet: zero,
        };
        if let Some(n) = self.held_density(i) {
            terms.outlet = (n - self.particles.density[i]) / dt - terms.total();
        }
        terms
    }
}
