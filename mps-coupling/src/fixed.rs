//! A rigid body that does not move: its forces are of interest.

use crate::{Structure, StructureEnergy};
use mps_kernel::{Real, Transfer, Vector};
use mps_neighbors::Parallel;
use std::any::Any;
use std::error::Error;

/// Points that stay where they are. Unlike a wall they receive the reaction of the fluid, so that drag and lift can be read off.
#[derive(Clone, Debug)]
pub struct Fixed<T: Real, const D: usize> {
    positions: Vec<Vector<T, D>>,
    volumes: Vec<T>,
    rest: Vec<Vector<T, D>>,
    spacing: T,
}

impl<T: Real, const D: usize> Fixed<T, D> {
    /// From positions \[m\], the volume of each point \[m^D\] and the distance of neighbouring points \[m\].
    pub fn new(positions: Vec<Vector<T, D>>, volumes: Vec<T>, spacing: T) -> Self {
        Self { rest: vec![Vector::zeros(); positions.len()], positions, volumes, spacing }
    }
}

impl<T: Real, const D: usize> Structure<T, D> for Fixed<T, D> {
    fn positions(&self) -> &[Vector<T, D>] {
        &self.positions
    }

    fn mean_velocities(&self) -> &[Vector<T, D>] {
        &self.rest
    }

    fn volumes(&self) -> &[T] {
        &self.volumes
    }

    fn spacing(&self) -> T {
        self.spacing
    }

    fn max_step(&self, _: &Parallel) -> T {
        T::of(f64::INFINITY)
    }

    fn advance(
        &mut self,
        _: &Parallel,
        _: &[Vector<T, D>],
        _: &Vector<T, D>,
        _: T,
        _: usize,
    ) -> Result<(), Box<dyn Error + Send + Sync>> {
        Ok(())
    }

    /// Nothing moves.
    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { positions, volumes: _, rest: _, spacing: _ } = self;
        transfer.same("points", positions.len());
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn energy(&self, _: &Parallel, _: &Vector<T, D>) -> StructureEnergy<T> {
        StructureEnergy::default()
    }
}
