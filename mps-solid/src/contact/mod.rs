//! Contact between solids, and of a solid with itself.
//!
//! Between particles a spring would be easy and rough: two rows of particles that slide along each other would have
//! to climb 0.13 spacings at every particle. Here a particle does not meet particles but the smooth *field* that
//! those of the other body make together,
//!
//! ```text
//! c_i = sum_j V_j (1 - r_ij^2/R^2)^3        (j: particles of the other body closer than R)
//! d_i = max(0, (c_i - c_0)/s)               overlap [m]
//! E   = sum_i A_i K/4 d_i^2                 over the particles of both bodies
//! ```
//!
//! with `c_0` and `s = -dc/dg` the field and its slope where the surfaces of two half spaces touch, their outermost
//! particles half a spacing of each apart, and `A_i = V_i/l` the surface of a particle. The radius `R` is that at
//! which the lattice along the surface is invisible there; both are closed forms (module `field`; 1.94 spacings in 2D and
//! 2.03 in 3D for equal spacings).
//!
//! **Stiffness.** Between the outermost particles and the surface lies half a spacing of material that no pair of
//! particles stands for. It is what gives way:
//!
//! ```text
//! 1/K = (l_a/2)/(lambda_a + 2 mu_a) + (l_b/2)/(lambda_b + 2 mu_b)        [m/Pa]
//! ```
//!
//! so that bodies pressed together have the stiffness of one body, and the overlap is that of their outer half cells.
//!
//! **Forces** are the exact gradient of `E`. They act along the line between two particles, with opposite signs,
//! so that both momenta are kept to round-off. There is no friction and no adhesion.
//!
//! **Itself** a body feels where particles of its surface meet that no way of four reference pairs or fewer joins. So the sides of
//! a narrow slot bear each other, from the third row behind its end on, and no strain brings contact into a body: what
//! is joined comes near only where a surface is pressed to less than a quarter of its length.
//!
//! **Surfaces** are taken half a spacing outside the outermost particles. A face that was clamped or slides has its particles *on* it, so it must not be
//! touched: [`body::wall`](crate::body::wall) makes a rigid wall that may. Spacings must not differ by more than an eighth from axis to axis, and bodies must not
//! be drawn into each other.
//!
//! **Step.** The largest eigenvalue of contact between plane surfaces is `K (1/(rho_a l_a) + 1/(rho_b l_b))` (surfaces that move as a whole,
//! against each other), and that of the system is at most the sum of this and of the bodies':
//! [`Contact::max_step`] is 16 % shorter than without contact in the same material at most.
//!
//! ```
//! use mps_kernel::{Vector, weights::WendlandC2};
//! use mps_neighbors::Parallel;
//! use mps_solid::contact::{Contact, ContactConfig, Elastic};
//! use mps_solid::{Solid, SolidConfig, body, materials::{NeoHookean, SaintVenantKirchhoff}};
//!
//! // A soft block falls on a hard one.
//! let parallel = Parallel::serial();
//! let lower = body::block(Vector::<f64, 2>::zeros(), Vector::<f64, 2>::new(0.04, 0.02), [8, 4], &[])?;
//! let upper = body::block(Vector::<f64, 2>::new(0.0, 0.021), Vector::<f64, 2>::new(0.04, 0.041), [8, 4], &[])?;
//! let (hard, soft) = (SaintVenantKirchhoff::new(1e7, 0.3)?, NeoHookean::new(1e6, 0.4)?);
//! let config = SolidConfig::default();
//! let mut lower = Solid::new(lower.particles, lower.spacing, 2000.0, hard, WendlandC2, config, &parallel)?;
//! let mut upper = Solid::new(upper.particles, upper.spacing, 1000.0, soft, WendlandC2, config, &parallel)?;
//! upper.velocities_mut().fill(Vector::<f64, 2>::new(0.0, -1.0));
//!
//! let mut contact = Contact::new(ContactConfig::default())?;
//! contact.add(&lower.shape())?;
//! contact.add(&upper.shape())?;
//! let mut bodies: [&mut dyn Elastic<f64, 2>; 2] = [&mut lower, &mut upper];
//! let none = |_| &[][..];
//! for _ in 0..40 {
//!     let dt = contact.max_step(&parallel, &bodies)?;
//!     contact.advance(&parallel, &mut bodies, none, &Vector::zeros(), 5.0 * dt, 5)?;
//! }
//! assert!(lower.momentum(&parallel).y < 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bonds;
mod candidates;
mod config;
mod elastic;
mod error;
mod field;
mod forces;
mod limit;
mod member;
mod pairing;
mod step;

pub use config::ContactConfig;
pub use elastic::{Elastic, Shape};
pub use error::ContactError;

use member::Member;
use mps_kernel::{Real, Vector};
use mps_neighbors::Parallel;
use pairing::Pairing;

/// Several bodies that feel each other where they touch.
///
/// Bodies are known by the number they got when they were [added](Self::add). Whoever moves them by other means than
/// [`advance`](Self::advance) calls [`update`](Self::update) and gives them [`forces`](Self::forces).
#[derive(Clone, Debug)]
pub struct Contact<T: Real, const D: usize> {
    config: ContactConfig<T>,
    members: Vec<Member<T, D>>,
    pairings: Vec<Pairing<T, D>>,
    /// How many of the bodies were there when they were moved last.
    begun: usize,
    /// For bodies that no other force acts on.
    no_force: Vec<Vector<T, D>>,
}

impl<T: Real, const D: usize> Contact<T, D> {
    /// Without bodies yet.
    ///
    /// # Errors
    /// If a parameter is out of range.
    pub fn new(config: ContactConfig<T>) -> Result<Self, ContactError> {
        config.validate()?;
        let (members, pairings, no_force) = (Vec::new(), Vec::new(), Vec::new());
        Ok(Self { config, members, pairings, begun: 0, no_force })
    }

    /// Adds a body that may touch itself and all that were added before. Returns its number.
    ///
    /// # Errors
    /// If a field has another length than the others, a number is not positive and finite, or the spacings along the axes
    /// differ by more than an eighth.
    pub fn add(&mut self, shape: &Shape<'_, T, D>) -> Result<usize, ContactError> {
        let body = self.members.len();
        self.members.push(Member::new(shape, body, self.config.self_contact)?);
        let first = if self.config.self_contact { 0 } else { 1 };
        for other in (first..=body).map(|back| body - back) {
            self.pairings.push(Pairing::new(&self.members, [other, body], &self.config));
        }
        let most = self.no_force.len().max(shape.reference.len());
        self.no_force.resize(most, Vector::zeros());
        Ok(body)
    }

    /// Finds the forces at the `positions` of body number 0, 1, ... \[m\].
    ///
    /// # Errors
    /// If a body has another number of particles than before, a position is not finite, or one surface has passed
    /// through another.
    pub fn update<'a>(
        &mut self,
        parallel: &Parallel,
        positions: impl Fn(usize) -> &'a [Vector<T, D>],
    ) -> Result<(), ContactError> {
        for (body, member) in self.members.iter_mut().enumerate() {
            let (got, particles) = (positions(body).len(), member.volume.len());
            if got != particles {
                return Err(ContactError::Length { body, name: "positions", got, particles });
            }
            member.bound(parallel, positions(body));
            member.rest();
        }
        for pairing in &mut self.pairings {
            let places = pairing.bodies().map(&positions);
            pairing.search(parallel, &self.members, places)?;
            if pairing.has_candidates() {
                pairing.overlap(parallel, &self.members, places)?;
                pairing.push(parallel, &mut self.members, places);
            }
        }
        Ok(())
    }

    /// Forces of contact on the particles of a body at the last [`update`](Self::update) \[N\]; empty for a number
    /// that no body has.
    pub fn forces(&self, body: usize) -> &[Vector<T, D>] {
        self.members.get(body).map_or(&[], |member| &member.force)
    }

    /// Energy of contact at the last [`update`](Self::update) \[J, per metre of depth in 2D\].
    pub fn energy(&self) -> T {
        self.pairings.iter().fold(T::zero(), |sum, pairing| sum + pairing.energy)
    }

    /// Deepest overlap of two bodies, or of one with itself, at the last [`update`](Self::update) \[m\]; 0 where
    /// they do not touch.
    pub fn overlap(&self, body: usize, other: usize) -> T {
        let both = [body.min(other), body.max(other)];
        let found = self.pairings.iter().find(|pairing| pairing.bodies() == both);
        found.map_or(T::zero(), |pairing| pairing.overlap)
    }

    /// The stiffness `K` between two bodies \[Pa/m\]: pressure over overlap. `None` for bodies that cannot touch.
    pub fn stiffness(&self, body: usize, other: usize) -> Option<T> {
        let both = [body.min(other), body.max(other)];
        self.pairings.iter().find(|pairing| pairing.bodies() == both).map(|pairing| pairing.stiffness)
    }
}
