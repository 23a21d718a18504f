//! The power of every cause on each particle: one more visit of the neighbours.

use crate::gather::Gather;
use crate::rates::{Flow, State};
use crate::terms::Viscosity;
use crate::{Diffusion, Fluid};
use fearless_simd::Simd;
use mps_kernel::operators::{DiffusionFilter, HydrostaticDiffusion};
use mps_kernel::small::{components, vector};
use mps_kernel::{Kernel, Lanes, Neighborhood, Real, Vector, by_axis};
use mps_neighbors::{Domain, RowView, Sweep};

/// What acts on one particle over the step: power of viscosity \[W/kg\], of density diffusion \[W/m^3\], of the motion and the
/// pressure of boundaries and of the field from outside \[W/kg\].
pub(super) struct Powers<'a, T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> {
    pub(super) fluid: &'a Fluid<T, D, K, V, P>,
    pub(super) neighbors: RowView<'a, T, D, K, P>,
    pub(super) state: &'a [State<T, D>],
    pub(super) flow: &'a [Flow<T, D>],
    pub(super) field: &'a [Vector<T, D>],
    /// Gravity along periodic axes \[m/s^2\].
    pub(super) driving: Vector<T, D>,
    /// What the diffusion filter is multiplied with \[m^2/s\].
    pub(super) diffusivity: T,
    /// Slope of `n/n0` in a fluid at rest \[1/m\].
    pub(super) slope: Vector<T, D>,
    /// Half the time step \[s\].
    pub(super) half: T,
}

impl<'b, T: Real, const D: usize, K, V, P> Sweep<&'b mut [[T; 4]]> for Powers<'_, T, D, K, V, P>
where
    K: Kernel<T>,
    V: Viscosity<T, D>,
    P: Domain<T, D>,
{
    #[inline(always)]
    fn visit<S: Simd>(&self, simd: S, i: usize, power: &'b mut [T; 4]) {
        let fluid = self.fluid;
        let (own, flow) = (self.state[i], self.flow[i]);
        let zero = T::Lanes::splat(simd, T::zero());
        let (mut drag, mut filtered) = (vector([zero; D]), zero);
        for pair in self.neighbors.packs_of(simd, i, self.state) {
            let other = Gather { simd, j: pair.j.as_ref(), from: self.state };
            fluid.viscosity.add(&mut drag, &pair, &own.velocity, &other.vector(|state| &state.velocity));
            let there = other.of(self.flow);
            let (density, gradient) =
                (there.scalar(|flow| flow.density), there.vector(|flow| &flow.gradient));
            filtered += match fluid.config.diffusion {
                Diffusion::Hydrostatic => {
                    HydrostaticDiffusion::pair(flow.density, density, &self.slope, &pair)
                }
                _ => DiffusionFilter::pair(flow.density, &flow.gradient, density, &gradient, &pair),
            };
        }
        let drag: Vector<T, D> = by_axis!(axis => components(&drag)[axis].sum());
        let mean = fluid.particles.velocity[i] - fluid.rates.acceleration[i] * self.half;
        let walls = !fluid.boundary.is_empty();
        let (shear, wall) = if walls { fluid.work_of_boundary(i, &mean) } else { (T::zero(), T::zero()) };
        let field = self.field.get(i).map_or(self.driving, |a| a + self.driving).dot(&mean);
        // The p/n of the stored energy, times n times the rate.
        let diffusion = fluid.particles.pressure[i] * self.diffusivity * filtered.sum();
        *power = [drag.dot(&mean) + shear, diffusion, wall, field];
    }
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Power per mass \[W/kg\] of the boundary on a particle: what its shear takes from the motion relative to it; and what the motion of the
    /// boundary gives, by shear and by pressure beyond what only goes from motion into compression.
    fn work_of_boundary(&self, i: usize, mean: &Vector<T, D>) -> (T, T) {
        let (wall, wall_shear, boundary) = (self.wall_pair(), self.wall_shear(), &self.boundary);
        let (own, pressure) = (&self.rates.state[i], self.particles.pressure[i]);
        let factor = self.reference.gradient_factor::<D>();
        let (mut lost, mut carried) = (T::zero(), T::zero());
        let (mut force, mut inflow) = (Vector::zeros(), T::zero());
        self.boundary_view().for_each(i, |pair| {
            let a = pair.j;
            force += wall.pressure_sum(pressure, own, boundary, pair);
            let (_, na) = wall.state(pressure, own.density, &boundary.acceleration[a], &pair.r_ij);
            let vector = self.corrected(i, pair.gradient_vector());
            let opening = (boundary.velocity[a] - self.particles.velocity[i]).dot(&vector);
            inflow -= na * boundary.volume[a] * T::of(crate::continuity::MIRROR) * opening;
            if let Some(drag) =
                wall_shear.pair(&self.viscosity, i, pair, &own.velocity, &boundary.velocity[a])
            {
                lost += drag.dot(&(mean - boundary.velocity[a]));
                carried += drag.dot(&boundary.velocity[a]);
            }
        });
        let motion = -self.corrected(i, force).dot(mean);
        let compression = own.share * inflow;
        (lost, carried + (motion + compression) * factor / self.config.density)
    }
}
