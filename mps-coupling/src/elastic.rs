//! The solid of `mps-solid` as a structure the fluid can push.

use crate::{Inertia, Momenta, Structure, StructureEnergy};
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Kernel, Real, Transfer, Vector};
use mps_neighbors::Parallel;
use mps_solid::{ConstitutiveModel, Solid};
use std::any::Any;
use std::error::Error;

/// Largest share of the border of its own stability that a sub-step takes ([`Structure::max_step`]).
const LARGEST_SHARE: f64 = 0.8;

/// An elastic solid in a scene.
pub struct ElasticBody<T, const D: usize, M, K = WendlandC2>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
{
    solid: Solid<T, D, M, K>,
    /// What is held over a sub-step besides gravity: nothing.
    no_force: Vec<Vector<T, D>>,
}

impl<T, const D: usize, M, K> ElasticBody<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    /// Wraps a solid.
    pub fn new(solid: Solid<T, D, M, K>) -> Self {
        Self { no_force: vec![Vector::zeros(); solid.len()], solid }
    }

    /// The solid.
    pub fn solid(&self) -> &Solid<T, D, M, K> {
        &self.solid
    }

    /// The solid, between steps of the scene: to move its supports, or to measure its stability anew after it has been stretched.
    pub fn solid_mut(&mut self) -> &mut Solid<T, D, M, K> {
        &mut self.solid
    }
}

impl<T, const D: usize, M, K> Structure<T, D> for ElasticBody<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D> + 'static,
    M::History: 'static,
    K: Kernel<T> + 'static,
{
    fn positions(&self) -> &[Vector<T, D>] {
        self.solid.positions()
    }

    fn mean_velocities(&self) -> &[Vector<T, D>] {
        self.solid.mean_velocities()
    }

    fn volumes(&self) -> &[T] {
        self.solid.volumes()
    }

    fn spacing(&self) -> T {
        self.solid.spacing().max()
    }

    fn spacings(&self) -> Vector<T, D> {
        *self.solid.spacing()
    }

    fn max_step(&self, parallel: &Parallel) -> T {
        // More than this share would leave no room for the spring of the fluid.
        let share = (T::of(LARGEST_SHARE) / self.solid.config().cfl).min(T::one());
        self.solid.max_step(parallel) * share
    }

    fn advance(
        &mut self,
        parallel: &Parallel,
        force: &[Vector<T, D>],
        gravity: &Vector<T, D>,
        dt: T,
        substeps: usize,
    ) -> Result<(), Box<dyn Error + Send + Sync>> {
        self.solid.kick(parallel, force, dt)?;
        Ok(self.solid.advance(parallel, &self.no_force, gravity, dt, substeps)?)
    }

    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { solid, no_force: _ } = self;
        solid.transfer(transfer);
    }

    fn inertia(&self) -> Inertia<'_, T> {
        Inertia::Points(self.solid.particles().masses())
    }

    fn momenta(&self, parallel: &Parallel, center: &Vector<T, D>) -> Option<Momenta<T, D>> {
        let (force, moment) = (self.solid.momentum(parallel), self.solid.angular_momentum(parallel, center));
        Some(Momenta { force, moment })
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn energy(&self, parallel: &Parallel, gravity: &Vector<T, D>) -> StructureEnergy<T> {
        let energy = self.solid.energy(parallel, gravity);
        StructureEnergy {
            kinetic: energy.kinetic,
            strain: energy.strain + energy.bending,
            potential: energy.potential,
        }
    }
}
