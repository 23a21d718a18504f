//! Walls with a turbulent boundary layer too steep for particles.
//!
//! At the Reynolds numbers of water that runs over a bed most of the velocity is gained within a fraction of a spacing from the wall. The friction there
//! follows from the velocity half a spacing away by a law of the wall, here that of Werner and Wengle (8th Symp. Turbulent Shear Flows
//! 1991, 19-4), with `u+ = u/u*`, `y+ = y u*/nu` and `tau = rho u*^2`:
//!
//! ```text
//! u+ = y+              for y+ <= 11.81
//! u+ = 8.3 (y+)^(1/7)  above
//! ```
//!
//! taken in the middle of the first layer of particles, `y = l0/2`. Its shear stress acts on the particles nearest to the surface,
//!
//! ```text
//! a_i = - (tau/rho0)/l0 s(y_i) t_i,   s(y) = min(1, 3/2 - y/l0), not below 0
//! ```
//!
//! against the direction `t_i` in which they slide. A first row half a spacing from the surface has the whole of it, and the integral of `s` is one
//! spacing, so that a stretch of wall feels `tau` times its length, on average over where the rows lie. The pair with point `a` gets the part `V_a W_ia/sum_b V_b W_ib` of it, and the point the opposite.

use super::surface::Seen;
use crate::boundary::Shear;
use crate::terms::Viscosity;
use crate::{Fluid, FluidError};
use mps_kernel::{Kernel, Neighborhood, Pair, Real, Vector};
use mps_neighbors::{Domain, Parallel};

/// Factor of the power law (Werner and Wengle 1991).
const FACTOR: f64 = 8.3;
/// Exponent of the power law.
const EXPONENT: f64 = 1.0 / 7.0;

/// Cosine to the direction towards the wall from which on a point counts as ahead: the points of the other wall of a corner, or of one behind, do not.
const AHEAD: f64 = 0.7;

/// Largest viscosity over `c l0`: a step at the limit of sound takes half of the velocity of the first row with it.
const MOST_VISCOUS: f64 = 0.25;

/// The law of Werner and Wengle for a fluid of this kinematic viscosity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallLaw<T> {
    /// Kinematic viscosity \[m^2/s\].
    pub viscosity: T,
}

impl<T: Real> WallLaw<T> {
    /// Shear stress over density, `u*^2` \[m^2/s^2\], on a wall along which the fluid slides with `speed` \[m/s\] at the `height` \[m\].
    pub fn stress(&self, speed: T, height: T) -> T {
        let laminar = self.viscosity * speed / height;
        // u = 8.3 u* (y u*/nu)^(1/7), solved for u*^2. The curves cross where u+ = y+ = 11.81.
        let root = speed * (self.viscosity / height).powf(T::of(EXPONENT)) / T::of(FACTOR);
        let turbulent = root.powf(T::of(2.0 / (1.0 + EXPONENT)));
        // Above the crossing the power law is the larger of the two, below the other one.
        laminar.max(turbulent)
    }
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Finds the drag of the walls with a law, for every particle.
    ///
    /// # Errors
    /// See [`check_law`](Self::check_law).
    pub(super) fn drag_by_law(&mut self, parallel: &Parallel) -> Result<(), FluidError> {
        self.check_law()?;
        let mut wall_drag = core::mem::take(&mut self.rates.wall_drag);
        wall_drag.resize(self.particles.position.len(), Vector::zeros());
        parallel
            .update(wall_drag.as_mut_slice(), |i, drag| *drag = self.drag_on(i).unwrap_or(Vector::zeros()));
        self.rates.wall_drag = wall_drag;
        Ok(())
    }

    /// Refuses what the law is not for.
    ///
    /// # Errors
    /// If there are walls with a law and the fluid is so viscous that its layers are thicker than a spacing: the law would be wrong, and a step too
    /// long for it.
    pub(crate) fn check_law(&self) -> Result<(), FluidError> {
        let most = (self.config.spacing * self.config.sound_speed).to_double() * MOST_VISCOUS;
        let value = self.config.wall_viscosity.to_double();
        if value <= most || !self.boundary.shear.contains(&Shear::Law) {
            return Ok(());
        }
        let hint = "in m2/s; layers of a fluid as viscous as that are thicker than a particle: give its walls no slip instead of a law, and the fluid this viscosity";
        Err(FluidError::Parameter { name: "wall_viscosity", value, low: 0.0, high: most, hint })
    }

    /// Drag on a particle for a unit of `V_a W_ia` \[m/s^2\]; `None` where no wall with a law drags it.
    fn drag_on(&self, i: usize) -> Option<Vector<T, D>> {
        let (walls, boundary, spacing) = (self.boundary_view(), &self.boundary, self.config.spacing);
        let ahead = |along: T, pair: &Pair<T, D>| along >= T::of(AHEAD) * pair.distance();
        let seen = Seen { i, walls: &walls, boundary, shear: Shear::Law, spacing };
        let surface = seen.surface(seen.toward(|_| true)?, ahead);
        let share = (T::of(1.5) - surface.distance / spacing).min(T::one());
        if share <= T::zero() {
            return None;
        }
        let (mut weight, mut carried) = (T::zero(), Vector::<T, D>::zeros());
        walls.for_each(i, |pair| {
            if boundary.shear[pair.j] == Shear::Law {
                let own = boundary.volume[pair.j] * pair.weight;
                weight += own;
                carried += boundary.velocity[pair.j] * own;
            }
        });
        if weight <= T::zero() {
            return None;
        }
        let relative = self.rates.state[i].velocity - carried / weight;
        let slide = relative - surface.toward * surface.toward.dot(&relative);
        let speed = slide.norm();
        if speed <= T::zero() {
            return None;
        }
        let law = WallLaw { viscosity: self.config.wall_viscosity };
        let stress = law.stress(speed, spacing * T::of(0.5));
        Some(slide * (-stress * share / (spacing * speed * weight)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// `u+` of a stress, from the definitions.
    fn in_wall_units(law: &WallLaw<f64>, speed: f64, height: f64) -> (f64, f64) {
        let friction = law.stress(speed, height).sqrt();
        (speed / friction, height * friction / law.viscosity)
    }

    #[test]
    fn both_branches_are_those_of_the_law_and_meet() {
        let law = WallLaw { viscosity: 1e-6 };
        for speed in [1e-4, 1e-3, 1e-2] {
            let (u, y) = in_wall_units(&law, speed, 1e-3);
            assert!(y < 11.81, "laminar at {y}");
            assert_relative_eq!(u, y, max_relative = 1e-12);
        }
        for speed in [0.2, 2.0, 20.0] {
            let (u, y) = in_wall_units(&law, speed, 1e-3);
            assert!(y > 11.81, "turbulent at {y}");
            assert_relative_eq!(u, 8.3 * y.powf(1.0 / 7.0), max_relative = 1e-12);
        }
        // Where they meet: u+ = y+ = 11.81, u = u+ y+ nu/y.
        let meeting = 11.81_f64.powi(2) * 1e-6 / 1e-3;
        let (below, above) = (law.stress(meeting * 0.999, 1e-3), law.stress(meeting * 1.001, 1e-3));
        assert!((above / below - 1.0).abs() < 0.005, "a step from {below} to {above}");
    }

    /// Another formula for the same: the friction of a turbulent layer 10 mm thick under 2 m/s by Blasius (Schlichting, Boundary-Layer
    /// Theory, 7th edition, chapter 21), `u*^2 = 0.0225 U^2 (nu/(U delta))^(1/4)`.
    #[test]
    fn the_friction_of_a_thick_layer_is_that_of_blasius() {
        let law = WallLaw { viscosity: 1e-6 };
        let blasius = 0.0225 * 4.0 * (1e-6 / (2.0 * 0.01_f64)).powf(0.25);
        assert_relative_eq!(law.stress(2.0, 0.01), blasius, max_relative = 0.1);
    }
}
