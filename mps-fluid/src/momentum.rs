//! The first sweep of a step: accelerations, the gradient of n and the measures of packing.

use crate::Fluid;
use crate::terms::Viscosity;
use mps_kernel::operators::{ConservativeGradient, Corrected, Gradient, MomentMatrix, invert_moment};
use mps_kernel::{Kernel, Neighborhood, Real, Tensor, Vector};
use mps_neighbors::{Domain, Parallel};

/// Below this measure of the moment matrix the neighbourhood counts as collinear
/// ([`invert_moment`]); its gradient of n then stays uncorrected.
const DEGENERATE: f64 = 0.05;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// `Du/Dt = -(1/rho0) grad p + viscosity + g` (eqs. 18, 24, 25) and, for the density diffusion
    /// that follows, the corrected gradient of n (eqs. 21, 22): all from the same visit of the
    /// neighbours, because positions and densities are those of the start of the step.
    pub(crate) fn sweep_momentum(&mut self, parallel: &Parallel) {
        let corrected = !self.rates.pressure_correction.is_empty();
        match (self.config.diffusion > T::zero(), corrected) {
            (true, false) => self.sweep_momentum_with::<true, false>(parallel),
            (false, false) => self.sweep_momentum_with::<false, false>(parallel),
            (true, true) => self.sweep_momentum_with::<true, true>(parallel),
            (false, true) => self.sweep_momentum_with::<false, true>(parallel),
        }
    }

    fn sweep_momentum_with<const DIFFUSION: bool, const CORRECTED: bool>(&mut self, parallel: &Parallel) {
        let mut acceleration = core::mem::take(&mut self.rates.acceleration);
        let mut flow = core::mem::take(&mut self.rates.flow);
        let neighbors = self.view(&self.search.fluid);
        let walls = self.boundary_view();
        let wall = self.wall_pair();
        let (boundary, viscosity) = (&self.boundary, self.viscosity);
        let state = &self.rates.state;
        let correction = &self.rates.pressure_correction;
        let factor = self.reference.gradient_factor::<D>();
        let pressure_factor = -factor / self.config.density;
        let gravity = self.config.gravity;
        let has_walls = !boundary.is_empty();

        parallel.update((acceleration.as_mut_slice(), flow.as_mut_slice()), |i, (acceleration, flow)| {
            let own = state[i];
            let (pi, ni, inverse_ni, ui) = (own.pressure, own.density, own.inverse_density, own.velocity);
            let mut total = Vector::<T, D>::zeros();
            let mut slope = Vector::<T, D>::zeros();
            let mut moment = Tensor::<T, D>::zeros();
            neighbors.for_each(i, |pair| {
                let other = &state[pair.j];
                if CORRECTED {
                    let vector = pair.gradient_vector() * pressure_factor;
                    total += correction[i] * (vector * (other.density * inverse_ni * pi))
                        + correction[pair.j] * (vector * (ni * other.inverse_density * other.pressure));
                } else {
                    let pij = ConservativeGradient::pair_pressure(
                        pi,
                        ni,
                        inverse_ni,
                        other.pressure,
                        other.density,
                        other.inverse_density,
                    );
                    total += pair.gradient_vector() * (pij * pressure_factor);
                }
                total += viscosity.pair(pair, &ui, &other.velocity);
                if DIFFUSION {
                    slope += Gradient::pair(ni, other.density, pair);
                    moment += MomentMatrix::pair(pair);
                }
            });
            if has_walls {
                walls.for_each(i, |pair| {
                    let a = pair.j;
                    let pressure = wall.pressure_sum(&own, boundary, pair) * pressure_factor;
                    total += if CORRECTED { correction[i] * pressure } else { pressure };
                    if boundary.shear[a] > T::zero() {
                        let share = boundary.shear[a] * boundary.volume[a];
                        total += viscosity.pair(pair, &ui, &boundary.velocity[a]) * share;
                    }
                });
            }
            *acceleration = total + gravity;
            flow.density = ni;
            if DIFFUSION {
                let corrected: Corrected<T, D> = invert_moment(&(moment * factor), T::of(DEGENERATE));
                // Uncorrected, the gradient of a poor neighbourhood would turn diffusion into growth.
                flow.gradient = corrected.corrected_or_zero(&(slope * factor));
            }
        });
        self.rates.acceleration = acceleration;
        self.rates.flow = flow;
    }

    /// Forces \[N\] on the reactive boundary points: the pair forces of
    /// [`sweep_momentum`](Self::sweep_momentum) with the other sign, gathered by the point that
    /// receives them.
    pub(crate) fn react(&mut self, parallel: &Parallel) {
        let reactive = self.boundary.reactive();
        if reactive.is_empty() {
            return;
        }
        let mut force = core::mem::take(&mut self.boundary.force);
        let first = reactive.start;
        parallel.update(&mut force[reactive], |k, force| {
            *force = self.reaction_on(first + k);
        });
        self.boundary.force = force;
    }

    fn reaction_on(&self, a: usize) -> Vector<T, D> {
        let wall = self.wall_pair();
        let boundary = &self.boundary;
        let fluid = mps_neighbors::RowView { points: &boundary.position, ..self.view(&self.search.reaction) };
        let state = &self.rates.state;
        let mass = self.config.particle_mass();
        let pressure_factor = self.reference.gradient_factor::<D>() / self.config.density;
        let mut sum = Vector::<T, D>::zeros();
        fluid.for_each(a, |pair| {
            let own = &state[pair.j];
            // The same pair, seen from the fluid particle.
            let seen = mps_kernel::Pair { j: a, r_ij: -pair.r_ij, ..*pair };
            let pressure = self.corrected(pair.j, wall.pressure_sum(own, boundary, &seen));
            let shear = self.viscosity.pair(&seen, &own.velocity, &boundary.velocity[a])
                * (boundary.shear[a] * boundary.volume[a]);
            sum += pressure * pressure_factor - shear;
        });
        sum * mass
    }

    /// Force \[N\] of all reactive points on the fluid, summed over the fluid particles: what the
    /// momentum audit holds against the sum of [`Boundary::force`](crate::Boundary::force).
    pub fn force_by_structures(&self, parallel: &Parallel) -> Vector<T, D> {
        let reactive = self.boundary.reactive();
        if reactive.is_empty() {
            return Vector::zeros();
        }
        let wall = self.wall_pair();
        let walls = self.boundary_view();
        let state = &self.rates.state;
        let pressure_factor = -self.reference.gradient_factor::<D>() / self.config.density;
        let sum = parallel.fold(
            state.len(),
            Vector::<T, D>::zeros(),
            &|i| {
                let mut sum = Vector::<T, D>::zeros();
                let own = &state[i];
                walls.for_each(i, |pair| {
                    let a = pair.j;
                    if reactive.contains(&a) {
                        let pressure = self.corrected(i, wall.pressure_sum(own, &self.boundary, pair));
                        let shear = self.viscosity.pair(pair, &own.velocity, &self.boundary.velocity[a]);
                        sum += pressure * pressure_factor;
                        sum += shear * (self.boundary.shear[a] * self.boundary.volume[a]);
                    }
                });
                sum
            },
            &|a, b| a + b,
        );
        sum * self.config.particle_mass()
    }
}
