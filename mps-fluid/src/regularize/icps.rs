//! Iterative corrected particle shifting (icPS): paper 1, eq. 49.

use crate::surface::SPRAY_LIMIT;
use crate::terms::Viscosity;
use crate::{Fluid, FluidError};
use mps_kernel::{Kernel, Neighborhood, Real, Vector};
use mps_neighbors::{Domain, Parallel};

/// Parameters of the shifting.
///
/// The shift of one step is `-A_F l0^2 Cr Ma grad C` (Amaro et al. 2022, eq. 14), with the Courant
/// number `Cr = (c + v_max) dt/l0` and the Mach number `Ma = v_max/c` of the step, done in `k`
/// parts, each from the positions the previous one left and all particles at once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shifting<T> {
    /// `A_F` \[-\]. Default 2.
    pub strength: T,
    /// `k`, sub-shifts a step. Default 5 (paper). Each costs about one sweep.
    pub iterations: u32,
}

impl<T: Real> Default for Shifting<T> {
    fn default() -> Self {
        Self { strength: T::of(2.0), iterations: 5 }
    }
}

/// Share of `n0` above which a particle counts as having a full neighbourhood. Below it, within
/// about two layers of a free surface, only the tangential part of the shift is applied.
const FULL: f64 = 0.95;

/// Bound of the shift of one step \[m\], for which the neighbour rows keep a reserve.
pub(crate) fn largest_shift<T: Real>(spacing: T) -> T {
    spacing * T::of(0.01)
}

/// Moves the particles towards an even distribution.
pub(crate) fn shift<T, const D: usize, K, V, P>(
    fluid: &mut Fluid<T, D, K, V, P>,
    parallel: &Parallel,
) -> Result<(), FluidError>
where
    T: Real,
    K: Kernel<T>,
    V: Viscosity<T, D>,
    P: Domain<T, D>,
{
    let Some(shifting) = fluid.config.shifting else { return Ok(()) };
    let u = &fluid.particles.velocity;
    let v_max = parallel.max(u.len(), T::zero(), |i| u[i].norm_squared()).sqrt();
    let (l0, c) = (fluid.config.spacing, fluid.config.sound_speed);
    let courant = (c + v_max) * fluid.last_dt / l0;
    let parts = T::of(f64::from(shifting.iterations));
    let reach = shifting.strength * l0 * l0 * courant * (v_max / c) / parts;
    let bound = largest_shift(l0) / parts;
    for _ in 0..shifting.iterations {
        fluid.measure_packing(parallel)?;
        let mut shifts = core::mem::take(&mut fluid.rates.correction);
        shifts.resize(fluid.particles.position.len(), Vector::zeros());
        {
            let fluid = &*fluid;
            parallel.update(shifts.as_mut_slice(), |i, shift| {
                let full = shift_direction(fluid, i) * -reach;
                let length = full.norm();
                *shift = if length > bound { full * (bound / length) } else { full };
            });
        }
        let domain = fluid.domain;
        parallel.update(fluid.particles.position.as_mut_slice(), |i, r| *r = domain.wrap(*r + shifts[i]));
        fluid.rates.correction = shifts;
    }
    Ok(())
}

/// `grad C` inside; its part along the surface next to a free surface; nothing for spray.
fn shift_direction<T, const D: usize, K, V, P>(fluid: &Fluid<T, D, K, V, P>, i: usize) -> Vector<T, D>
where
    T: Real,
    K: Kernel<T>,
    V: Viscosity<T, D>,
    P: Domain<T, D>,
{
    let (packing, asymmetry) = (&fluid.rates.packing, &fluid.rates.asymmetry);
    if fluid.is_leaving(i) {
        return Vector::zeros();
    }
    if packing[i] >= T::of(FULL) {
        return asymmetry[i];
    }
    if packing[i] < T::of(SPRAY_LIMIT) {
        return Vector::zeros();
    }
    // The normal is smoothed over the neighbours: the particle's own asymmetry is what is to be
    // split into a normal and a tangential part.
    let mut normal = asymmetry[i];
    fluid.view(&fluid.search.fluid).for_each(i, |pair| normal += asymmetry[pair.j] * pair.weight);
    let length = normal.norm();
    if length > T::zero() {
        let normal = normal / length;
        asymmetry[i] - normal * normal.dot(&asymmetry[i])
    } else {
        Vector::zeros()
    }
}
