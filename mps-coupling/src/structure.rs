//! What a fluid needs of anything solid that moves.

use mps_fluid::Push;
use mps_kernel::{Real, Transfer, Vector};
use mps_neighbors::Parallel;
use std::any::Any;
use std::error::Error;

/// Energies of a structure \[J\] (per metre of depth in 2D).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StructureEnergy<T> {
    /// Energy of motion.
    pub kinetic: T,
    /// Energy of deformation.
    pub strain: T,
    /// Energy in the field of gravity, over that of a place that stays: the origin, or where the body was undeformed.
    pub potential: T,
}

impl<T: Real> StructureEnergy<T> {
    /// Sum of the parts \[J\].
    pub fn total(&self) -> T {
        self.kinetic + self.strain + self.potential
    }
}

/// What a force on the points of a structure has to move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Inertia<'a, T> {
    /// Nobody has said.
    Unknown,
    /// The whole body at once: its mass \[kg\]. Turning is not looked at: a body with its mass in the middle takes smaller ones.
    Rigid(T),
    /// Each point by itself: the mass of each \[kg\].
    Points(&'a [T]),
}

/// Momentum \[N s\] and angular momentum about a stated point \[N m s\] of a structure, as a [`Push`] that has given it to the structure.
pub type Momenta<T, const D: usize> = Push<T, D>;

/// A body the fluid can push: the solid of `mps-solid`, or the body of another simulator.
///
/// A structure shows itself as points that fill its volume, at least as deep as the effective
/// radius of the fluid below its wetted surface. Everything is in SI units, per metre of depth in 2D.
///
/// Whatever it shows is looked at before it is used: after each sub-step the number of its points and whether places and velocities are finite,
/// before each step its masses and its longest sub-step. It is not kept from passing through walls and other structures, which it does not know
/// of: where that is about to happen the scene ends with an error ([`Scene::refuse_contacts`](crate::Scene::refuse_contacts)).
pub trait Structure<T: Real, const D: usize>: Any + Send + Sync {
    /// Positions of the points \[m\]. Their number and order never change.
    fn positions(&self) -> &[Vector<T, D>];

    /// Mean velocities of the points over the last [`advance`](Structure::advance) \[m/s\]:
    /// displacement over time step, zeros before the first. The fluid closes its continuity equation with them, so that
    /// the work it loses is the work the structure gains.
    fn mean_velocities(&self) -> &[Vector<T, D>];

    /// Volume each point stands for \[m^D\].
    fn volumes(&self) -> &[T];

    /// Distance between neighbouring points \[m\].
    fn spacing(&self) -> T;

    /// The same along each axis of the undeformed structure \[m\], where they differ: the surface is looked for in spacings.
    fn spacings(&self) -> Vector<T, D> {
        Vector::repeat(self.spacing())
    }

    /// Longest sub-step the structure can take in its present state \[s\]; infinite if any. Not more than 0.8 of the border of its own
    /// stability, so that the spring of the fluid has room beside it.
    fn max_step(&self, parallel: &Parallel) -> T;

    /// Moves on by `dt` \[s\] in `substeps` equal parts, under `force` \[N\] on each point and
    /// `gravity` \[m/s^2\].
    ///
    /// The force belongs to the positions at the start. It has to act before the body moves, as the
    /// impulse `force dt`: held over the sub-step it would lag behind the motion by half of it and feed
    /// vibrations the fluid acts on as a spring (`docs/coupling.md`).
    ///
    /// # Errors
    /// If the structure cannot go on; the message says which part of it and why.
    fn advance(
        &mut self,
        parallel: &Parallel,
        force: &[Vector<T, D>],
        gravity: &Vector<T, D>,
        dt: T,
        substeps: usize,
    ) -> Result<(), Box<dyn Error + Send + Sync>>;

    /// Saves everything the structure needs to go on with the same bits, or restores it into one that was built in the same way
    /// ([`Transfer`] is gone through in both directions). A structure that does not implement this can be in a scene, but the scene cannot
    /// be saved.
    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        transfer.refuse(
            "a structure of this type cannot be saved: implement `Structure::transfer` for it, or run the scene in one piece",
        );
    }

    /// What the forces have to move. With it the scene finds how many sub-steps the fluid at the surface asks for
    /// ([`Scene::interface_border`](crate::Scene::interface_border)); a body that does not say is on its own when it is much lighter than a
    /// layer of fluid particles.
    fn inertia(&self) -> Inertia<'_, T> {
        Inertia::Unknown
    }

    /// Momentum and angular momentum about `center` \[m\] by the structure's own books, which the coupling can be held against;
    /// `None` if it keeps none.
    fn momenta(&self, _parallel: &Parallel, _center: &Vector<T, D>) -> Option<Momenta<T, D>> {
        None
    }

    /// The structure itself, for probes and output that know its type.
    fn as_any(&self) -> &dyn Any;

    /// Present energies, given gravity \[m/s^2\].
    fn energy(&self, parallel: &Parallel, gravity: &Vector<T, D>) -> StructureEnergy<T>;
}
