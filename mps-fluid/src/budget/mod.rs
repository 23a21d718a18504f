//! Where the energy goes: the work of every cause, summed over the steps.
//!
//! Between two moments the energy of the fluid (kinetic, potential, compression) changes by
//!
//! `viscosity + diffusion + collisions + shifting + relaxation + boundary + field`
//!
//! and by what the time stepping makes of it, the only part that is not measured but left over. Each work
//! is evaluated with the sums of the step itself: a force with the mean of the velocities before and after it,
//! a rate of density with the `p/n` by which compression stores energy.
//!
//! Not booked yet: what passes openings, and the change of the shear on a structure within a step.
//!
//! The books are closed unless [`Fluid::keep_books`] is called; then a step costs about half as much again.

mod powers;

use crate::terms::Viscosity;
use crate::{Fluid, FluidError, regularize};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Domain, Parallel};
use powers::Powers;

/// Energy \[J\] (per metre of depth in 2D) the fluid has received since the books were opened, by cause;
/// negative where it has lost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnergyBudget<T> {
    /// Viscosity of fluid pairs, and the shear of boundaries as seen by somebody who moves with them; negative.
    pub viscosity: T,
    /// Diffusion of the density, through the energy of compression.
    pub diffusion: T,
    /// Pairwise collisions; negative.
    pub collisions: T,
    /// Shifting, through the height of the particles.
    pub shifting: T,
    /// Relaxation of the density to the packing, through the energy of compression.
    pub relaxation: T,
    /// What walls and structures hand over: the work of their motion against pressure and shear, and of the hydrostatic difference by
    /// which the pressure they show differs from the particle's own.
    pub boundary: T,
    /// Accelerations added from outside ([`Fluid::add_acceleration`]), and gravity along periodic axes.
    pub field: T,
}

impl<T: Real> EnergyBudget<T> {
    /// Sum of the parts \[J\].
    pub fn total(&self) -> T {
        let regularised = self.collisions + self.shifting + self.relaxation;
        self.viscosity + self.diffusion + regularised + self.boundary + self.field
    }
}

/// The open books.
#[derive(Clone, Debug, Default)]
pub(crate) struct Books<T: Real, const D: usize> {
    pub(crate) budget: EnergyBudget<T>,
    /// Accelerations from outside in this step \[m/s^2\].
    pub(crate) field: Vec<Vector<T, D>>,
    /// Of each particle in this step: see [`Powers`].
    pub(crate) power: Vec<[T; 4]>,
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Opens the books, empty. Call it between steps.
    pub fn keep_books(&mut self) {
        self.books = Some(Box::default());
    }

    /// The work of every cause since [`keep_books`](Self::keep_books); `None` without.
    pub fn budget(&self) -> Option<EnergyBudget<T>> {
        self.books.as_ref().map(|books| books.budget)
    }

    /// Shifts the particles and books what their heights gain.
    pub(crate) fn shift(&mut self, parallel: &Parallel) -> Result<(), FluidError> {
        let height = |fluid: &Self| {
            let (g, r) = (fluid.gravity_with_potential(), &fluid.particles.position);
            -parallel.fold(r.len(), T::zero(), &|i| g.dot(&r[i]), &|a, b| a + b)
        };
        let before = self.books.as_ref().map(|_| height(self));
        regularize::shift(self, parallel)?;
        if let Some(before) = before {
            let gained = (height(self) - before) * self.config.particle_mass();
            self.books.iter_mut().for_each(|books| books.budget.shifting += gained);
        }
        Ok(())
    }

    /// Lets the densities follow the packing and books what compression gains.
    pub(crate) fn relax_densities(&mut self, parallel: &Parallel) -> Result<(), FluidError> {
        let before = self.books.as_ref().map(|_| self.energy(parallel).compression);
        regularize::relax_densities(self, parallel)?;
        if let Some(before) = before {
            let gained = self.energy(parallel).compression - before;
            self.books.iter_mut().for_each(|books| books.budget.relaxation += gained);
        }
        Ok(())
    }

    /// Lets close particles collide and books what their motion loses.
    pub(crate) fn collide(&mut self, parallel: &Parallel) {
        let motion = |fluid: &Self| {
            let u = &fluid.particles.velocity;
            parallel.fold(u.len(), T::zero(), &|i| u[i].norm_squared(), &|a, b| a + b) * T::of(0.5)
        };
        let before = self.books.as_ref().map(|_| motion(self));
        regularize::collide(self, parallel);
        if let Some(before) = before {
            let gained = (motion(self) - before) * self.config.particle_mass();
            self.books.iter_mut().for_each(|books| books.budget.collisions += gained);
        }
    }

    /// Forgets the accelerations from outside of a step that was begun and not finished.
    pub(crate) fn forget_field(&mut self) {
        self.books.iter_mut().for_each(|books| books.field.clear());
    }

    /// Remembers an acceleration from outside.
    pub(crate) fn book_field(
        &mut self,
        parallel: &Parallel,
        field: &(impl Fn(&Vector<T, D>) -> Vector<T, D> + Sync),
    ) {
        let Some(books) = &mut self.books else { return };
        books.field.resize(self.particles.position.len(), Vector::zeros());
        let position = &self.particles.position;
        parallel.update(books.field.as_mut_slice(), |i, a| *a += field(&position[i]));
    }

    /// Books what acts over the step. Velocities are the new ones; densities, positions and pressures still those of
    /// the start.
    pub(crate) fn book_step(&mut self, parallel: &Parallel, dt: T) {
        let Some(mut books) = self.books.take() else { return };
        books.power.resize(self.particles.position.len(), [T::zero(); 4]);
        let sweep = Powers {
            fluid: &*self,
            neighbors: self.view(&self.search.fluid),
            state: &self.rates.state,
            flow: &self.rates.flow,
            field: &books.field,
            driving: self.config.gravity - self.gravity_with_potential(),
            diffusivity: self.diffusivity(),
            slope: self.hydrostatic_slope(),
            half: dt * T::of(0.5),
        };
        parallel.sweep(books.power.as_mut_slice(), &sweep);
        let power = &books.power;
        let add = |a: [T; 4], b: [T; 4]| core::array::from_fn(|k| a[k] + b[k]);
        let [viscosity, diffusion, boundary, outside] =
            parallel.fold(power.len(), [T::zero(); 4], &|i| power[i], &add);
        let handed_over = self.exchange_work();
        let (m, volume) = (self.config.particle_mass(), self.config.particle_volume());
        books.budget.viscosity += viscosity * m * dt;
        books.budget.diffusion += diffusion * volume * dt;
        books.budget.boundary += (boundary * m + handed_over) * dt;
        books.budget.field += outside * m * dt;
        books.field.clear();
        self.books = Some(books);
    }
}
