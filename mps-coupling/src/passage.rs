//! The sub-steps of the structures within one step of the fluid.

use crate::{Budget, CouplingError, Interface, Passage, Structure};
use core::ops::Range;
use mps_fluid::{Fluid, Viscosity};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Domain, Parallel};

/// A structure in a scene.
pub(crate) struct Body<T: Real, const D: usize> {
    pub(crate) structure: Box<dyn Structure<T, D>>,
    pub(crate) interface: Interface<T, D>,
    /// Its points among those of the fluid's boundary.
    pub(crate) range: Range<usize>,
    /// Force on each of its points \[N\].
    pub(crate) force: Vec<Vector<T, D>>,
    /// Positions of its points at the start of the step \[m\].
    pub(crate) start: Vec<Vector<T, D>>,
}

impl<T: Real, const D: usize> Body<T, D> {
    /// Forces of the fluid on the points in the present sub-step.
    fn gather<K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>>(&mut self, fluid: &Fluid<T, D, K, V, P>) {
        for (a, &i) in self.range.clone().zip(&self.interface.visible) {
            self.force[i as usize] = fluid.force_on(a);
        }
    }

    /// Shows the fluid the mean velocities of the last sub-step.
    fn show_velocities<K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>>(
        &self,
        fluid: &mut Fluid<T, D, K, V, P>,
    ) {
        let velocities = self.structure.mean_velocities();
        let boundary = fluid.boundary_mut();
        for (a, &i) in self.range.clone().zip(&self.interface.visible) {
            boundary.velocity[a] = velocities[i as usize];
        }
    }
}

/// One step of a scene while its structures move.
pub(crate) struct Step<'a, T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> {
    fluid: &'a mut Fluid<T, D, K, V, P>,
    bodies: &'a mut [Body<T, D>],
    budget: &'a mut Budget<T, D>,
    parallel: &'a Parallel,
    dt: T,
    substeps: usize,
    /// Of the start of the step.
    books: Budget<T, D>,
}

impl<'a, T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Step<'a, T, D, K, V, P> {
    pub(crate) fn new(
        fluid: &'a mut Fluid<T, D, K, V, P>,
        bodies: &'a mut [Body<T, D>],
        budget: &'a mut Budget<T, D>,
        parallel: &'a Parallel,
        dt: T,
        substeps: usize,
    ) -> Self {
        let books = *budget;
        Self { fluid, bodies, budget, parallel, dt, substeps, books }
    }

    fn failed(&self, index: usize) -> impl FnOnce(Box<dyn std::error::Error + Send + Sync>) -> CouplingError {
        let time = self.fluid.time().to_double();
        move |source| CouplingError::Structure { index, time, source }
    }
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Passage<T, D>
    for Step<'_, T, D, K, V, P>
{
    fn advance(&mut self) -> Result<(), CouplingError> {
        let sub_dt = self.dt / T::of(self.substeps as f64);
        let gravity = self.fluid.config().gravity;
        let time = self.fluid.time().to_double();
        for body in &mut *self.bodies {
            body.start.copy_from_slice(body.structure.positions());
        }
        // Those of the last sub-step, where the forces were found with the mean over the last step.
        for body in &*self.bodies {
            body.show_velocities(self.fluid);
        }
        for _ in 0..self.substeps {
            self.fluid.follow_shear();
            for (index, body) in self.bodies.iter_mut().enumerate() {
                body.gather(self.fluid);
                body.structure
                    .advance(self.parallel, &body.force, &gravity, sub_dt, 1)
                    .map_err(|source| CouplingError::Structure { index, time, source })?;
                self.budget.book(&body.force, body.structure.mean_velocities(), sub_dt);
            }
            for body in &*self.bodies {
                body.show_velocities(self.fluid);
            }
            self.fluid.compress_interface(self.parallel, sub_dt);
        }
        for body in &mut *self.bodies {
            let positions = body.structure.positions();
            let boundary = self.fluid.boundary_mut();
            for (a, &i) in body.range.clone().zip(&body.interface.visible) {
                boundary.velocity[a] = (positions[i as usize] - body.start[i as usize]) / self.dt;
            }
        }
        Ok(())
    }

    fn keep(&mut self) -> Result<(), CouplingError> {
        let stuck = self.bodies.iter_mut().position(|body| !body.structure.save());
        stuck.map_or(Ok(()), |index| Err(CouplingError::NoState { index }))
    }

    fn go_back(&mut self) -> Result<(), CouplingError> {
        for index in 0..self.bodies.len() {
            let restored = self.bodies[index].structure.restore(self.parallel);
            restored.map_err(self.failed(index))?;
        }
        *self.budget = self.books;
        self.fluid.restart_exchange();
        Ok(())
    }

    fn supposed(&mut self) -> &mut [Vector<T, D>] {
        self.fluid.supposed_velocities()
    }

    fn found(&self, velocities: &mut Vec<Vector<T, D>>) {
        self.fluid.velocities_found(self.dt, velocities);
    }
}
