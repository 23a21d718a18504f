//! A fluid with walls and bodies.

use crate::Failure;
use crate::scene::Viscous;
use crate::scene::movers::Mover;
use mps_coupling::Scene;
use mps_kernel::{Kernel, Real, Transfer};
use mps_neighbors::Parallel;

/// Fluid, walls and bodies.
pub struct Wet<T: Real, const D: usize, K: Kernel<T>> {
    pub(super) scene: Scene<T, D, K, Viscous<T>>,
    pub(super) movers: Vec<Mover<T, D>>,
    /// Number of points of the walls, with which the boundary begins.
    pub(super) walls: usize,
    /// Number of elastic bodies, which come before the fixed ones.
    pub(super) elastic: usize,
    pub(super) last_dt: f64,
    /// Courant number of the scene \[-\].
    pub(super) cfl: T,
}

impl<T: Real, const D: usize, K: Kernel<T>> Wet<T, D, K> {
    pub(super) fn transfer(&mut self, parallel: &Parallel, transfer: &mut Transfer<'_>) {
        let Self { scene, movers, walls: _, elastic: _, last_dt, cfl: _ } = self;
        transfer.within("scene", |transfer| scene.transfer(parallel, transfer));
        movers.iter_mut().for_each(|mover| mover.transfer(transfer));
        transfer.value("last step", last_dt);
    }

    /// Numbers of the points of walls that stand still, and of those that move.
    pub(super) fn wall_points(&self) -> [Vec<u32>; 2] {
        let moves = |k: &usize| self.movers.iter().any(|mover| mover.range().contains(k));
        let (moving, still): (Vec<usize>, Vec<usize>) = (0..self.walls).partition(moves);
        [still, moving].map(|points| points.into_iter().map(|k| k as u32).collect())
    }

    /// Shows the fluid the velocities of moved walls.
    pub(super) fn show_motions(&mut self) {
        let time = self.scene.fluid().time().to_double();
        for mover in &mut self.movers {
            mover.show(self.scene.fluid_mut().boundary_mut(), time, self.last_dt);
        }
    }

    pub(super) fn step(&mut self, parallel: &Parallel) -> Result<f64, Failure> {
        self.show_motions();
        // Whole steps to the end: a shortened one would show as a jump of the energy.
        let dt = self.scene.step(parallel, T::of(f64::INFINITY))?;
        for mover in &mut self.movers {
            mover.move_on(self.scene.fluid_mut().boundary_mut(), dt);
        }
        self.last_dt = dt.to_double();
        Ok(self.last_dt)
    }
}
