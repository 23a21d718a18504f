//! Loads on a surface: dead tractions and pressures that follow it.
//!
//! A [`Surface`] is a set of [`MaterialPoint`]s, each with an outward area vector `A` of the undeformed body. A
//! traction `t` per undeformed area adds `t |A|` there. A pressure stays normal to the surface as it turns and
//! stretches,
//!
//! ```text
//! f = -p cof(F) A      (Nanson: n da = cof(F) N dA)
//! ```
//!
//! Forces on particles are an argument of [`Solid::advance`]; a load adds to them. A single force is
//! [`MaterialPoint::add_force`].

use crate::{ConstitutiveModel, MaterialPoint, Solid, SolidError, SolidParticles};
use mps_kernel::tensor::cofactor;
use mps_kernel::{Kernel, Real, Vector};

/// A part of the surface of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface<T: Real, const D: usize> {
    points: Vec<(MaterialPoint<T, D>, Vector<T, D>)>,
}

impl<T: Real, const D: usize> Surface<T, D> {
    pub(crate) fn new(points: Vec<(MaterialPoint<T, D>, Vector<T, D>)>) -> Self {
        Self { points }
    }

    /// Points and outward area vectors \[m^(D-1)\] of the undeformed surface.
    pub fn points(&self) -> &[(MaterialPoint<T, D>, Vector<T, D>)] {
        &self.points
    }

    /// Area of the undeformed surface \[m^(D-1)\].
    pub fn area(&self) -> T {
        self.points.iter().fold(T::zero(), |sum, (_, area)| sum + area.norm())
    }

    /// Adds `traction` \[Pa of the undeformed area\], which keeps its direction, to the forces \[N\].
    pub fn add_traction(&self, traction: &Vector<T, D>, forces: &mut [Vector<T, D>]) {
        for (point, area) in &self.points {
            point.add_force(&(traction * area.norm()), forces);
        }
    }

    /// Adds `pressure` \[Pa of the current area\], which stays normal to the surface, to the forces \[N\].
    pub fn add_pressure(&self, pressure: T, particles: &SolidParticles<T, D>, forces: &mut [Vector<T, D>]) {
        for (point, area) in &self.points {
            let f = point.value(&particles.deformation);
            point.add_force(&(cofactor(&f) * area * -pressure), forces);
        }
    }
}

impl<T, const D: usize, M, K> Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    /// The surface through `points`, pairs of a place \[m\] and an outward area vector \[m^(D-1)\] of the undeformed
    /// body. A face of a block is better taken from [`Body::face`](crate::body::Body::face).
    ///
    /// # Errors
    /// If a point has too few particles around it.
    pub fn surface(
        &self,
        points: impl IntoIterator<Item = (Vector<T, D>, Vector<T, D>)>,
    ) -> Result<Surface<T, D>, SolidError> {
        let points = points.into_iter().map(|(place, area)| Ok((self.point(place)?, area)));
        Ok(Surface::new(points.collect::<Result<_, SolidError>>()?))
    }
}
