//! Walls to which the fluid sticks.
//!
//! A wall shows a particle the velocity that a straight profile from the particle to the surface would have at the place of the point: at the
//! distance `y_i` from the surface, with the point `d_a` behind it, the difference is `(u_a - u_i) (1 + d_a/y_i)` (Morris, Fox and Zhu 1997, J. Comput. Phys. 136, 214-226; where the wall is, is found differently here). Linear profiles
//! are exact for each particle, so that no slip is of second order. The distance between particle and point along the normal is `y_i + d_a`, hence the
//! factor is `q_i . r_ia` with one vector `q_i = m_i/y_i` a particle: `m_i`, towards the wall, is the direction of `sum_a V_a e_ia W_ia/r`,
//! and the surface lies half the spacing of the nearest point before it.
//!
//! A mirrored velocity (`d_a = y_i` for all) is right for the sum of the rows only, and the fluid comes to rest 0.1 to 0.2 spacings before the surface.
//! The force of a pair is the same on both sides either way.

use crate::Fluid;
use crate::boundary::{Boundary, Shear};
use crate::terms::Viscosity;
use mps_kernel::{Kernel, Neighborhood, Pair, Real, Vector};
use mps_neighbors::{Domain, Parallel, RowView};

/// Distance over spacing below which a particle counts as this far from the surface, so that shear stays finite.
const NEAREST: f64 = 0.5;

/// What a sweep needs to know the shear of boundary points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NoSlip<'a, T: Real, const D: usize> {
    boundary: &'a Boundary<T, D>,
    /// `q_i` \[1/m\]; empty if the fluid sticks to no wall.
    toward_wall: &'a [Vector<T, D>],
}

impl<T: Real, const D: usize> NoSlip<'_, T, D> {
    /// What the shear of a pair of fluid layers is multiplied with for the point `pair.j`, seen from fluid particle `i`; zero with free slip.
    #[inline(always)]
    pub(crate) fn share(&self, i: usize, pair: &Pair<T, D>) -> T {
        match self.boundary.shear[pair.j] {
            Shear::Free => T::zero(),
            Shear::Fluid => self.boundary.volume[pair.j],
            // Without viscosity nobody has looked where the wall is.
            Shear::Wall => self.toward_wall.get(i).map_or(T::zero(), |toward| {
                self.boundary.volume[pair.j] * toward.dot(&pair.r_ij).max(T::zero())
            }),
        }
    }
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Finds where the walls without slip are, for every particle.
    pub(crate) fn locate_walls(&mut self, parallel: &Parallel) {
        if !(self.viscosity.kinematic() > T::zero() && self.boundary.shear.contains(&Shear::Wall)) {
            return;
        }
        let mut toward_wall = core::mem::take(&mut self.rates.toward_wall);
        toward_wall.resize(self.particles.position.len(), Vector::zeros());
        let walls = self.boundary_view();
        let spacing = self.config.spacing;
        parallel.update(toward_wall.as_mut_slice(), |i, q| *q = locate(i, &walls, &self.boundary, spacing));
        self.rates.toward_wall = toward_wall;
    }

    pub(crate) fn no_slip(&self) -> NoSlip<'_, T, D> {
        NoSlip { boundary: &self.boundary, toward_wall: &self.rates.toward_wall }
    }
}

/// `q_i` of a particle; zero away from walls.
fn locate<T: Real, const D: usize, K: Kernel<T>, P: Domain<T, D>>(
    i: usize,
    walls: &RowView<'_, T, D, K, P>,
    boundary: &Boundary<T, D>,
    spacing: T,
) -> Vector<T, D> {
    let sticky = |a: usize| boundary.shear[a] == Shear::Wall;
    let mut lean = Vector::<T, D>::zeros();
    walls.for_each(i, |pair| {
        if sticky(pair.j) {
            lean += pair.gradient_vector() * boundary.volume[pair.j];
        }
    });
    let norm = lean.norm();
    if norm <= T::zero() {
        return lean;
    }
    let normal = lean / norm;
    let mut nearest = walls.radius;
    walls.for_each(i, |pair| {
        if sticky(pair.j) {
            let size = boundary.volume[pair.j].powf(T::one() / T::of(D as f64)) * spacing;
            nearest = nearest.min(normal.dot(&pair.r_ij) - size * T::of(0.5));
        }
    });
    normal / nearest.max(spacing * T::of(NEAREST))
}
