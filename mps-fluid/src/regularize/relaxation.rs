//! The number density of the equation of state learns how the particles are packed.
//!
//! The continuity equation integrates `n` along with the velocities. The packing `N = sum W/n0` of the positions follows another way: shifting
//! moves particles without a velocity, and sums over a disordered neighbourhood differ from the divergence of the motion. So
//!
//! `Dn/Dt = ... + chi (c/l0) (N - n)`
//!
//! with a small `chi` (not in the paper; `FluidConfig::density_relaxation`): sound passes before anything happens, and where particles keep gathering the pressure rises until they leave.

use crate::surface::SPRAY_LIMIT;
use crate::terms::Viscosity;
use crate::{Fluid, FluidError};
use mps_kernel::{Kernel, Real};
use mps_neighbors::{Domain, Parallel};

/// Brings the densities closer to the packing, by what belongs to the previous step.
pub(crate) fn relax_densities<T, const D: usize, K, V, P>(
    fluid: &mut Fluid<T, D, K, V, P>,
    parallel: &Parallel,
) -> Result<(), FluidError>
where
    T: Real,
    K: Kernel<T>,
    V: Viscosity<T, D>,
    P: Domain<T, D>,
{
    let config = &fluid.config;
    let share = config.density_relaxation * fluid.last_dt * config.sound_speed / config.spacing;
    if share <= T::zero() {
        return Ok(());
    }
    // The shifting has just measured it, a hundredth of a spacing from here.
    if config.shifting.is_none() {
        fluid.measure_packing(parallel)?;
    }
    let mut density = core::mem::take(&mut fluid.particles.density);
    {
        let fluid = &*fluid;
        parallel.update(density.as_mut_slice(), |i, n| {
            let packing = fluid.rates.packing[i];
            if packing > T::of(SPRAY_LIMIT) && !fluid.is_leaving(i) {
                *n += (packing - *n) * share;
            }
        });
    }
    fluid.particles.density = density;
    Ok(())
}
