//! Walls to which the fluid sticks.
//!
//! A wall shows a particle the velocity that a straight profile from the particle to the surface would have at the place of the point: at the
//! distance `y_i` from the surface, with the point `d_a` behind it, the difference is `(u_a - u_i) (1 + d_a/y_i)` (Morris, Fox and Zhu 1997, J. Comput. Phys. 136, 214-226; where the wall is, is found differently here). Linear profiles
//! are exact for each particle, so that no slip is of second order. The distance between particle and point along the normal is `y_i + d_a`, hence the
//! factor is `q_i . r_ia` with one vector `q_i = m_i/y_i` a particle: `m_i`, towards the wall, and `y_i` are those of [`Surface`].
//!
//! In a gap narrower than two radii a particle sees two walls, one ahead and one behind: each has a surface and a vector of its own, and shows its
//! own profile.
//!
//! A mirrored velocity (`d_a = y_i` for all) is right for the sum of the rows only, and the fluid comes to rest 0.1 to 0.2 spacings before the surface.
//! The force of a pair is the same on both sides either way.

use super::surface::{Seen, Surface};
use crate::Fluid;
use crate::boundary::Shear;
use crate::terms::Viscosity;
use mps_kernel::{Kernel, Pair, Real, Vector};
use mps_neighbors::{Domain, Parallel};

/// Distance over spacing below which a particle counts as this far from the surface, so that shear stays finite.
const NEAREST: f64 = 0.5;

/// Cosine to the direction towards a wall from which on a point tells how far its surface is, where there is another wall as well.
const AHEAD: f64 = 0.5;

/// Cosine to the opposite direction from which on a point belongs to a wall behind: those of the other wall of a corner do not get there.
const BEHIND: f64 = 0.7;

/// Part of the sum of the sizes below which the sum of the pulls of the points has no direction: a corner leaves a half of it, the middle of a gap
/// nothing but where the points happen to lie.
const UNDECIDED: f64 = 0.25;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Finds where the walls without slip are, for every particle.
    pub(super) fn locate_walls(&mut self, parallel: &Parallel) {
        let mut toward_wall = core::mem::take(&mut self.rates.toward_wall);
        let mut wall_behind = core::mem::take(&mut self.rates.wall_behind);
        toward_wall.resize(self.particles.position.len(), Vector::zeros());
        wall_behind.resize(self.particles.position.len(), Vector::zeros());
        let (walls, boundary, spacing) = (self.boundary_view(), &self.boundary, self.config.spacing);
        let fields = (toward_wall.as_mut_slice(), wall_behind.as_mut_slice());
        parallel.update(fields, |i, (ahead, behind)| {
            let seen = Seen { i, walls: &walls, boundary, shear: Shear::Wall, spacing };
            [*ahead, *behind] = seen.profiles();
        });
        self.rates.toward_wall = toward_wall;
        self.rates.wall_behind = wall_behind;
    }
}

impl<T: Real, const D: usize, K: Kernel<T>, P: Domain<T, D>> Seen<'_, T, D, K, P> {
    /// `q_i` of the wall ahead and of the one behind \[1/m\]; zero where there is none.
    fn profiles(&self) -> [Vector<T, D>; 2] {
        let nearest = self.spacing * T::of(NEAREST);
        let profile = |surface: Surface<T, D>| surface.toward / surface.distance.max(nearest);
        if let Some(toward) = self.toward(|_| true) {
            let mut alone = true;
            let surface = self.surface(toward, |along, pair| {
                let ahead = along > T::zero();
                let counts = ahead || pair.weight > T::zero();
                alone &= ahead || !counts;
                counts
            });
            if alone {
                return [profile(surface), Vector::zeros()];
            }
            if !self.is_gap(&toward) {
                return [profile(self.ahead(toward)), Vector::zeros()];
            }
        }
        let Some(toward) = self.toward_one_of_two() else { return [Vector::zeros(); 2] };
        let behind = self.toward(|pair| toward.dot(&pair.r_ij) < T::zero());
        [profile(self.ahead(toward)), behind.map_or(Vector::zeros(), |behind| profile(self.ahead(behind)))]
    }

    /// The surface by those points that are straight ahead: others may belong to another wall. In a sharp corner nobody is, and all count that are
    /// not behind.
    fn ahead(&self, toward: Vector<T, D>) -> Surface<T, D> {
        let mut some = false;
        let surface = self.surface(toward, |along, pair| {
            let counts = along >= T::of(AHEAD) * pair.distance();
            some |= counts;
            counts
        });
        if some { surface } else { self.surface(toward, |along, _| along > T::zero()) }
    }

    /// Whether there is a wall on either side, and not one or a corner.
    fn is_gap(&self, toward: &Vector<T, D>) -> bool {
        let (mut opposite, mut sum, mut size) = (false, Vector::<T, D>::zeros(), T::zero());
        self.for_each(|pair| {
            if pair.weight > T::zero() {
                opposite |= toward.dot(&pair.r_ij) < -T::of(BEHIND) * pair.distance();
                sum += self.pull(pair);
                size += self.pull(pair).norm();
            }
        });
        opposite || sum.norm() < T::of(UNDECIDED) * size
    }

    /// Direction towards the nearer one of two walls: from the nearest point to the points on its side.
    fn toward_one_of_two(&self) -> Option<Vector<T, D>> {
        let mut nearest: Option<Pair<T, D>> = None;
        self.for_each(|pair| {
            if pair.weight > T::zero() && nearest.is_none_or(|nearest| pair.r2 < nearest.r2) {
                nearest = Some(*pair);
            }
        });
        let mut toward = nearest?.r_ij;
        // The nearest point lies aside, so that some of the other wall are on its side: once more they are not.
        for _ in 0..2 {
            toward = self.toward(|pair| toward.dot(&pair.r_ij) > T::zero())?;
        }
        Some(toward)
    }
}
