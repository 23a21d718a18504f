//! Shear between the fluid and boundary points: none, as of fluid, of walls to which the fluid sticks, or by a law of the wall.

mod no_slip;
mod surface;
mod wall_law;

use crate::boundary::{Boundary, Shear};
use crate::terms::Viscosity;
use crate::{Fluid, FluidError};
use mps_kernel::{Kernel, Pair, Real, Vector};
use mps_neighbors::{Domain, Parallel};

pub use wall_law::WallLaw;

/// What a sweep needs to know the shear of boundary points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WallShear<'a, T: Real, const D: usize> {
    boundary: &'a Boundary<T, D>,
    /// `q_i` \[1/m\] of walls without slip; empty if the fluid sticks to none.
    toward_wall: &'a [Vector<T, D>],
    /// The same of a second wall, behind the particle; zero for most.
    wall_behind: &'a [Vector<T, D>],
    /// Drag of the law of the wall \[m/s^2\] for a unit of `V_a W_ia`; empty without such walls.
    wall_drag: &'a [Vector<T, D>],
}

impl<T: Real, const D: usize> WallShear<'_, T, D> {
    /// What the shear of a pair of fluid layers is multiplied with for the point `pair.j`, seen from fluid particle `i`; zero where
    /// viscosity does not reach the point.
    #[inline(always)]
    pub(crate) fn share(&self, i: usize, pair: &Pair<T, D>) -> T {
        match self.boundary.shear[pair.j] {
            Shear::Free | Shear::Law => T::zero(),
            Shear::Fluid => self.boundary.volume[pair.j],
            // Without viscosity nobody has looked where the wall is.
            Shear::Wall => self.toward_wall.get(i).map_or(T::zero(), |toward| {
                let mut along = toward.dot(&pair.r_ij);
                if along <= T::zero() {
                    along = self.wall_behind.get(i).map_or(T::zero(), |behind| behind.dot(&pair.r_ij));
                }
                self.boundary.volume[pair.j] * along.max(T::zero())
            }),
        }
    }

    /// Acceleration \[m/s^2\] of fluid particle `i`, of velocity `ui` \[m/s\], by the shear of the point `pair.j`, of velocity `ua` \[m/s\];
    /// `None` where there is none.
    #[inline(always)]
    pub(crate) fn pair<V: Viscosity<T, D>>(
        &self,
        viscosity: &V,
        i: usize,
        pair: &Pair<T, D>,
        ui: &Vector<T, D>,
        ua: &Vector<T, D>,
    ) -> Option<Vector<T, D>> {
        let share = self.share(i, pair);
        if share > T::zero() {
            return Some(viscosity.pair(pair, ui, ua) * share);
        }
        self.drag_at(i).map(|drag| drag.pair(pair))
    }

    /// What drags fluid particle `i` by the law of the wall; `None` away from such walls.
    #[inline(always)]
    pub(crate) fn drag_at(&self, i: usize) -> Option<WallDrag<'_, T, D>> {
        let drag = self.wall_drag.get(i).filter(|drag| **drag != Vector::<T, D>::zeros())?;
        Some(WallDrag { boundary: self.boundary, drag })
    }
}

/// The drag of the walls with a law on one particle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WallDrag<'a, T: Real, const D: usize> {
    boundary: &'a Boundary<T, D>,
    /// \[m/s^2\] for a unit of `V_a W_ia`.
    drag: &'a Vector<T, D>,
}

impl<T: Real, const D: usize> WallDrag<'_, T, D> {
    /// The part of the point `pair.j` \[m/s^2\].
    #[inline(always)]
    pub(crate) fn pair(&self, pair: &Pair<T, D>) -> Vector<T, D> {
        match self.boundary.shear[pair.j] {
            Shear::Law => self.drag * (self.boundary.volume[pair.j] * pair.weight),
            _ => Vector::zeros(),
        }
    }
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Finds for every particle what its walls ask for: where those without slip are, and how those with a law of the wall drag.
    ///
    /// # Errors
    /// If a law of the wall is asked for a fluid too viscous for it.
    pub(crate) fn prepare_shear(&mut self, parallel: &Parallel) -> Result<(), FluidError> {
        if self.viscosity.kinematic() > T::zero() && self.boundary.shear.contains(&Shear::Wall) {
            self.locate_walls(parallel);
        }
        if self.boundary.shear.contains(&Shear::Law) {
            self.drag_by_law(parallel)?;
        }
        Ok(())
    }

    pub(crate) fn wall_shear(&self) -> WallShear<'_, T, D> {
        WallShear {
            boundary: &self.boundary,
            toward_wall: &self.rates.toward_wall,
            wall_behind: &self.rates.wall_behind,
            wall_drag: &self.rates.wall_drag,
        }
    }
}
