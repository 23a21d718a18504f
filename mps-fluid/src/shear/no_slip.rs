//! Walls to which the fluid sticks.
//!
//! A wall shows a particle the velocity that a straight profile from the particle to the surface would have at the place of the point: at the
//! distance `y_i` from the surface, with the point `d_a` behind it, the difference is `(u_a - u_i) (1 + d_a/y_i)` (Morris, Fox and Zhu 1997, J. Comput. Phys. 136, 214-226; where the wall is, is found differently here). Linear profiles
//! are exact for each particle, so that no slip is of second order. The distance between particle and point along the normal is `y_i + d_a`, hence the
//! factor is `q_i . r_ia` with one vector `q_i = m_i/y_i` a particle: `m_i`, towards the wall, and `y_i` are those of [`Surface`].
//!
//! A mirrored velocity (`d_a = y_i` for all) is right for the sum of the rows only, and the fluid comes to rest 0.1 to 0.2 spacings before the surface.
//! The force of a pair is the same on both sides either way.

use super::surface::Surface;
use crate::Fluid;
use crate::boundary::Shear;
use crate::terms::Viscosity;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Domain, Parallel};

/// Distance over spacing below which a particle counts as this far from the surface, so that shear stays finite.
const NEAREST: f64 = 0.5;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Finds where the walls without slip are, for every particle.
    pub(super) fn locate_walls(&mut self, parallel: &Parallel) {
        let mut toward_wall = core::mem::take(&mut self.rates.toward_wall);
        toward_wall.resize(self.particles.position.len(), Vector::zeros());
        let walls = self.boundary_view();
        let spacing = self.config.spacing;
        parallel.update(toward_wall.as_mut_slice(), |i, q| {
            // All points count: what is nearest to a particle in a corner is taken for the surface.
            let surface = Surface::seen_from(i, &walls, &self.boundary, Shear::Wall, spacing, |_, _| true);
            *q = surface.map_or(Vector::zeros(), |surface| {
                surface.toward / surface.distance.max(spacing * T::of(NEAREST))
            });
        });
        self.rates.toward_wall = toward_wall;
    }
}
