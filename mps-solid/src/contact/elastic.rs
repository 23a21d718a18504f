//! What contact asks of a body.

use crate::{ConstitutiveModel, Solid, SolidEnergy, SolidError};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{FrozenPairs, Parallel};

/// What of a body never changes, as far as contact is concerned.
#[derive(Clone, Copy, Debug)]
pub struct Shape<'a, T: Real, const D: usize> {
    /// Positions in the undeformed body \[m\].
    pub reference: &'a [Vector<T, D>],
    /// Reference pairs: particles that a few of them join do not feel each other, nor do those inside.
    pub pairs: &'a FrozenPairs<T, D>,
    /// Volume each particle stands for \[m^D\].
    pub volume: &'a [T],
    /// Mass of each particle \[kg, per metre of depth in 2D\].
    pub mass: &'a [T],
    /// Distance of neighbouring particles along each axis \[m\], within an eighth the same; the surface lies half of their mean
    /// outside the outermost particles.
    pub spacing: Vector<T, D>,
    /// `lambda + 2 mu` \[Pa\], the modulus under compression without room to the sides.
    pub modulus: T,
}

/// A body that [`Contact`](super::Contact) can move. Bodies of different materials are different types, and called
/// once in a sub-step each.
pub trait Elastic<T: Real, const D: usize>: Send + Sync {
    /// What never changes.
    fn shape(&self) -> Shape<'_, T, D>;

    /// Positions \[m\].
    fn positions(&self) -> &[Vector<T, D>];

    /// Longest sub-step without contact \[s\].
    fn max_step(&self, parallel: &Parallel) -> T;

    /// Changes the velocities by the impulse `force dt` \[N s\] on every particle, all at once.
    ///
    /// # Errors
    /// If an argument is unusable.
    fn kick(&mut self, parallel: &Parallel, force: &[Vector<T, D>], dt: T) -> Result<(), SolidError>;

    /// One symplectic sub-step of `dt` \[s\] under the force on every particle \[N\] and gravity \[m/s^2\].
    ///
    /// # Errors
    /// If an argument is unusable or the body cannot go on.
    fn advance(
        &mut self,
        parallel: &Parallel,
        force: &[Vector<T, D>],
        gravity: &Vector<T, D>,
        dt: T,
    ) -> Result<(), SolidError>;

    /// Keeps the present state, so that [`go_back`](Self::go_back) can bring it back: positions, velocities, time and all that the
    /// next step depends on. Called once in a call of [`Contact::advance`](super::Contact::advance). A body that leaves this and `go_back` as they are, doing
    /// nothing, stays where an error has found it.
    fn remember(&mut self) {}

    /// Brings back the state that was [remembered](Self::remember) last.
    fn go_back(&mut self, _parallel: &Parallel) {}

    /// Its energy without contact; `gravity` \[m/s^2\] is the acceleration of the potential.
    fn energy(&self, parallel: &Parallel, gravity: &Vector<T, D>) -> SolidEnergy<T>;
}

impl<T, const D: usize, M, K> Elastic<T, D> for Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    fn shape(&self) -> Shape<'_, T, D> {
        let material = self.material();
        Shape {
            reference: self.particles().reference_positions(),
            pairs: self.pairs(),
            volume: self.volumes(),
            mass: self.masses(),
            spacing: *self.spacing(),
            modulus: material.first_lame_modulus() + material.shear_modulus() * T::of(2.0),
        }
    }

    fn positions(&self) -> &[Vector<T, D>] {
        self.positions()
    }

    fn max_step(&self, parallel: &Parallel) -> T {
        self.max_step(parallel)
    }

    fn kick(&mut self, parallel: &Parallel, force: &[Vector<T, D>], dt: T) -> Result<(), SolidError> {
        self.kick(parallel, force, dt)
    }

    fn advance(
        &mut self,
        parallel: &Parallel,
        force: &[Vector<T, D>],
        gravity: &Vector<T, D>,
        dt: T,
    ) -> Result<(), SolidError> {
        self.advance(parallel, force, gravity, dt, 1)
    }

    fn remember(&mut self) {
        self.remember();
    }

    fn go_back(&mut self, parallel: &Parallel) {
        self.go_back(parallel);
    }

    fn energy(&self, parallel: &Parallel, gravity: &Vector<T, D>) -> SolidEnergy<T> {
        self.energy(parallel, gravity)
    }
}
