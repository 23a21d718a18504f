//! The first sweep of a step: accelerations, the gradient of n and the measures of packing.

use crate::Push;
use crate::gather::Gather;
use crate::rates::{Flow, State};
use crate::shear::WallShear;
use crate::terms::{Viscosity, WallPair};
use crate::{Boundary, Fluid};
use fearless_simd::Simd;
use mps_kernel::operators::{ConservativeGradient, Corrected, Gradient, invert_moment};
use mps_kernel::small::{
    accumulate, accumulate_symmetric, columns, components, scale, symmetric, tensor, transform, vector,
};
use mps_kernel::{Kernel, Lanes, Neighborhood, Real, Tensor, Vector};
use mps_kernel::{by_axes, by_axis};
use mps_neighbors::{Domain, Parallel, RowView, Sweep};

/// Below this measure of the moment matrix the neighbourhood counts as collinear
/// ([`invert_moment`]); its gradient of n then stays uncorrected.
const DEGENERATE: f64 = 0.05;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// `Du/Dt = -(1/rho0) grad p + viscosity + g` (eqs. 18, 24, 25) and, for the density diffusion
    /// that follows, the corrected gradient of n (eqs. 21, 22): all from the same visit of the
    /// neighbours, because positions and densities are those of the start of the step.
    pub(crate) fn sweep_momentum(&mut self, parallel: &Parallel) {
        let corrected = !self.rates.pressure_correction.is_empty();
        match (self.config.diffusion.delta() > T::zero(), corrected) {
            (true, false) => self.sweep_momentum_with::<true, false>(parallel),
            (false, false) => self.sweep_momentum_with::<false, false>(parallel),
            (true, true) => self.sweep_momentum_with::<true, true>(parallel),
            (false, true) => self.sweep_momentum_with::<false, true>(parallel),
        }
    }

    fn sweep_momentum_with<const DIFFUSION: bool, const CORRECTED: bool>(&mut self, parallel: &Parallel) {
        let mut acceleration = core::mem::take(&mut self.rates.acceleration);
        let mut flow = core::mem::take(&mut self.rates.flow);
        let factor = self.reference.gradient_factor::<D>();
        let sweep = Momentum::<_, D, _, _, _, DIFFUSION, CORRECTED> {
            neighbors: self.view(&self.search.fluid),
            walls: self.boundary_view(),
            state: &self.rates.state,
            correction: &self.rates.pressure_correction,
            stress: &self.rates.stress,
            pressure: &self.particles.pressure,
            boundary: &self.boundary,
            shear: self.wall_shear(),
            wall: self.wall_pair(),
            viscosity: self.viscosity,
            gravity: self.config.gravity,
            factor,
            pressure_factor: -factor / self.config.density,
        };
        parallel.sweep((acceleration.as_mut_slice(), flow.as_mut_slice()), &sweep);
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
        let (boundary, shear) = (&self.boundary, self.wall_shear());
        let fluid = mps_neighbors::RowView { points: &boundary.position, ..self.view(&self.search.reaction) };
        let (state, pressures) = (&self.rates.state, &self.particles.pressure);
        let mass = self.config.particle_mass();
        let pressure_factor = self.reference.gradient_factor::<D>() / self.config.density;
        let mut sum = Vector::<T, D>::zeros();
        fluid.for_each(a, |pair| {
            let own = &state[pair.j];
            // The same pair, seen from the fluid particle.
            let seen = mps_kernel::Pair { j: a, r_ij: -pair.r_ij, ..*pair };
            let pressure = self.corrected(pair.j, wall.pressure_sum(pressures[pair.j], own, boundary, &seen));
            sum += pressure * pressure_factor;
            if let Some(shear) =
                shear.pair(&self.viscosity, pair.j, &seen, &own.velocity, &boundary.velocity[a])
            {
                sum -= shear;
            }
        });
        sum * mass
    }

    /// What all reactive points do to the fluid at the start of the step, about `center` \[m\], summed over the fluid particles:
    /// what the audit holds against the sum of [`Boundary::force`](crate::Boundary::force). Belongs behind
    /// [`begin_step`](Fluid::begin_step), before any point has another velocity.
    pub fn push_by_structures(&self, parallel: &Parallel, center: &Vector<T, D>) -> Push<T, D> {
        let reactive = self.boundary.reactive();
        if reactive.is_empty() {
            return Push::default();
        }
        let wall = self.wall_pair();
        let (walls, shear) = (self.boundary_view(), self.wall_shear());
        let state = &self.rates.state;
        let pressure_factor = -self.reference.gradient_factor::<D>() / self.config.density;
        let mass = self.config.particle_mass();
        let push_on = |i: usize| {
            let mut sum = Vector::<T, D>::zeros();
            let (own, pi) = (&state[i], self.particles.pressure[i]);
            walls.for_each(i, |pair| {
                let a = pair.j;
                if reactive.contains(&a) {
                    let pressure = self.corrected(i, wall.pressure_sum(pi, own, &self.boundary, pair));
                    sum += pressure * pressure_factor;
                    let shear =
                        shear.pair(&self.viscosity, i, pair, &own.velocity, &self.boundary.velocity[a]);
                    sum += shear.unwrap_or(Vector::zeros());
                }
            });
            Push::at(&(self.particles.position[i] - center), &(sum * mass))
        };
        parallel.fold(state.len(), Push::default(), &push_on, &|a, b| a + b)
    }
}

/// What [`Fluid::sweep_momentum`] does to one particle.
struct Momentum<'a, T: Real, const D: usize, K, V, P, const DIFFUSION: bool, const CORRECTED: bool> {
    neighbors: RowView<'a, T, D, K, P>,
    walls: RowView<'a, T, D, K, P>,
    state: &'a [State<T, D>],
    /// `C_i` of the corrected form, empty for the plain one.
    correction: &'a [Tensor<T, D>],
    /// `S_i`, likewise.
    stress: &'a [Tensor<T, D>],
    pressure: &'a [T],
    boundary: &'a Boundary<T, D>,
    shear: WallShear<'a, T, D>,
    wall: WallPair<T, D>,
    viscosity: V,
    gravity: Vector<T, D>,
    /// `D/n0`.
    factor: T,
    /// `-(D/n0)/rho0` \[m^3/kg\].
    pressure_factor: T,
}

impl<T: Real, const D: usize, K, V, P, const DIFFUSION: bool, const CORRECTED: bool>
    Momentum<'_, T, D, K, V, P, DIFFUSION, CORRECTED>
where
    K: Kernel<T>,
    V: Viscosity<T, D>,
    P: Domain<T, D>,
{
    #[inline(always)]
    fn add_walls(&self, i: usize, own: &State<T, D>, total: &mut Vector<T, D>) {
        self.walls.for_each(i, |pair| {
            let a = pair.j;
            let pressure =
                self.wall.pressure_sum(self.pressure[i], own, self.boundary, pair) * self.pressure_factor;
            *total += if CORRECTED { self.correction[i] * pressure } else { pressure };
            let share = self.shear.share(i, pair);
            if share > T::zero() {
                *total += self.viscosity.pair(pair, &own.velocity, &self.boundary.velocity[a]) * share;
            }
        });
        // In a loop of its own, so that it costs nothing where no such wall is near.
        if let Some(drag) = self.shear.drag_at(i) {
            self.walls.for_each(i, |pair| *total += drag.pair(pair));
        }
    }
}

impl<'b, T: Real, const D: usize, K, V, P, const DIFFUSION: bool, const CORRECTED: bool>
    Sweep<(&'b mut [Vector<T, D>], &'b mut [Flow<T, D>])>
    for Momentum<'_, T, D, K, V, P, DIFFUSION, CORRECTED>
where
    K: Kernel<T>,
    V: Viscosity<T, D>,
    P: Domain<T, D>,
{
    #[inline(always)]
    fn visit<S: Simd>(
        &self,
        simd: S,
        i: usize,
        (acceleration, flow): (&'b mut Vector<T, D>, &'b mut Flow<T, D>),
    ) {
        let state = self.state;
        let own = state[i];
        let zero = T::Lanes::splat(simd, T::zero());
        let (mut total, mut slope) = (vector([zero; D]), vector([zero; D]));
        // The sum of the pressures; in the corrected form the part of it that the particle's own S_i multiplies, and the rest.
        let (mut pressed, mut by_own) = (vector([zero; D]), vector([zero; D]));
        let mut moment = tensor([[zero; D]; D]);
        for pair in self.neighbors.packs_of(simd, i, state) {
            let other = Gather { simd, j: pair.j.as_ref(), from: state };
            let density = other.scalar(|state| state.density);
            let direction = pair.gradient_vector();
            if CORRECTED {
                accumulate(&mut by_own, &scale(&direction, density));
                accumulate(&mut pressed, &transform(&other.of(self.stress).tensor(), &direction));
            } else {
                let share = other.scalar(|state| state.share);
                let pij = ConservativeGradient::pair_pressure(own.share, own.density, share, density);
                accumulate(&mut pressed, &scale(&direction, pij));
            }
            self.viscosity.add(&mut total, &pair, &own.velocity, &other.vector(|state| &state.velocity));
            if DIFFUSION {
                accumulate(&mut slope, &Gradient::pair(own.density, density, &pair));
                accumulate_symmetric(&mut moment, &direction, &pair.r_ij);
            }
        }
        let mut total: Vector<T, D> = by_axis!(axis => components(&total)[axis].sum());
        let pressed: Vector<T, D> = by_axis!(axis => components(&pressed)[axis].sum());
        if CORRECTED {
            let by_own: Vector<T, D> = by_axis!(axis => components(&by_own)[axis].sum());
            total += (pressed * own.density + self.stress[i] * by_own) * self.pressure_factor;
        } else {
            total += pressed * self.pressure_factor;
        }
        if !self.boundary.is_empty() {
            self.add_walls(i, &own, &mut total);
        }
        *acceleration = total + self.gravity;
        flow.density = own.density;
        if DIFFUSION {
            let moment = symmetric(&moment);
            let moment: Tensor<T, D> = by_axes!((row, column) => columns(&moment)[column][row].sum());
            let slope: Vector<T, D> = by_axis!(axis => components(&slope)[axis].sum());
            let corrected: Corrected<T, D> = invert_moment(&(moment * self.factor), T::of(DEGENERATE));
            // Uncorrected, the gradient of a poor neighbourhood would turn diffusion into growth.
            flow.gradient = corrected.corrected_or_zero(&(slope * self.factor));
        }
    }
}
