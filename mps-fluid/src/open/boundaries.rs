//! The openings of a fluid and how they are added.

use super::hold::speed_at_plane;
use super::{Inlet, Outlet};
use crate::eos::EquationOfState;
use crate::terms::Viscosity;
use crate::{Fluid, FluidError, FluidParticles};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Domain, Parallel};

/// The inlets and outlets of a fluid.
#[derive(Debug)]
pub(crate) struct OpenBoundaries<T: Real, const D: usize> {
    pub(crate) inlets: Vec<Inlet<T, D>>,
    pub(crate) outlets: Vec<Outlet<T, D>>,
    /// Pressure at the middle of each outlet in this step \[Pa\].
    pub(crate) beyond: Vec<T>,
    /// Mean speed through the plane of each outlet, as last known \[m/s\]: that of the particles beyond it.
    pub(crate) speed: Vec<T>,
    /// What it has changed by in this step \[m/s\].
    pub(crate) change: Vec<T>,
    /// The particles beyond an outlet in this step, and which.
    pub(crate) leaving: Vec<(usize, usize)>,
    /// Volume that enters per time \[m^D/s\].
    pub(crate) inflow: T,
    /// Number of the next particle.
    pub(crate) next_id: u32,
    /// Particles that have entered and left so far.
    pub(crate) passed: [u64; 2],
}

impl<T: Real, const D: usize> Default for OpenBoundaries<T, D> {
    fn default() -> Self {
        Self {
            inlets: Vec::new(),
            outlets: Vec::new(),
            beyond: Vec::new(),
            speed: Vec::new(),
            change: Vec::new(),
            leaving: Vec::new(),
            inflow: T::zero(),
            next_id: 0,
            passed: [0; 2],
        }
    }
}

impl<T: Real, const D: usize> OpenBoundaries<T, D> {
    /// A number for a new particle.
    fn number(&mut self) -> u32 {
        self.next_id += 1;
        self.next_id - 1
    }
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Lets fluid enter. The stack of points that the inlet adds to the boundary lies upstream of its plane; walls have to
    /// reach as far.
    ///
    /// # Errors
    /// If the opening is no whole number of spacings wide, a structure has been added before, or the run has begun.
    pub fn add_inlet(&mut self, mut inlet: Inlet<T, D>) -> Result<(), FluidError> {
        self.refuse_after_start()?;
        inlet.install(&mut self.boundary, self.config.spacing, self.config.radius())?;
        self.open_boundaries().inlets.push(inlet);
        Ok(())
    }

    /// Lets fluid leave. The zone beyond its plane, twice the effective radius and a spacing deep, is filled with particles that have the mean
    /// speed of the fluid at the plane: what would be at rest there would stay, in the way of a flow that begins with a speed. Walls have to
    /// reach an effective radius further. What else is behind the plane, another outlet or other fluid, has to be two spacings from the zone.
    ///
    /// # Errors
    /// If the opening is no whole number of spacings wide, or the run has begun.
    pub fn add_outlet(&mut self, outlet: Outlet<T, D>) -> Result<(), FluidError> {
        self.refuse_after_start()?;
        let spacing = self.config.spacing;
        outlet.opening.check(spacing)?;
        let FluidParticles { position, velocity, .. } = &self.particles;
        let speed = speed_at_plane(&Parallel::serial(), &outlet.opening, self.slab(), position, velocity)
            .unwrap_or(T::zero());
        let mut leaving = Vector::zeros();
        leaving[outlet.opening.axis] = outlet.opening.along(speed);
        let layers = (self.zone() / spacing).to_double() as usize;
        for layer in 0..layers {
            for place in outlet.opening.lattice(spacing, T::of(layer as f64 + 0.5) * spacing) {
                let id = self.open_boundaries().number();
                let pressure = outlet.pressure + self.hydrostatic(&outlet.opening, &place);
                self.particles.push(place, leaving, self.eos.density(pressure), pressure, id);
            }
        }
        self.rates.resize(self.particles.position.len());
        let open = self.open_boundaries();
        open.beyond.push(outlet.pressure);
        open.outlets.push(outlet);
        open.speed.push(speed);
        open.change.push(T::zero());
        Ok(())
    }

    fn refuse_after_start(&self) -> Result<(), FluidError> {
        if self.steps == 0 {
            return Ok(());
        }
        let what = format!("it has to be added before the first step, not after {}", self.steps);
        Err(FluidError::Opening { what })
    }

    /// Depth of the zone beyond an outlet \[m\].
    pub(super) fn zone(&self) -> T {
        T::of(2.0) * self.reference.radius + self.config.spacing
    }

    /// Depth of the fluid before an outlet that tells its speed \[m\].
    pub(super) fn slab(&self) -> T {
        T::of(2.0) * self.reference.radius
    }

    fn open_boundaries(&mut self) -> &mut OpenBoundaries<T, D> {
        let next_id = self.particles.id.iter().max().map_or(0, |id| id + 1);
        let open = self.open.get_or_insert_default();
        open.next_id = open.next_id.max(next_id);
        open
    }

    /// Particles that have entered and left so far.
    pub fn passed(&self) -> [u64; 2] {
        self.open.as_ref().map_or([0; 2], |open| open.passed)
    }
}
