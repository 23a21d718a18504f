//! What open boundaries do in a step.

use super::{Inlet, Opening, Outlet};
use crate::eos::EquationOfState;
use crate::terms::Viscosity;
use crate::{Fluid, FluidError};
use mps_kernel::{FieldVisitor, Kernel, Neighborhood, ParticleStore, Pod, Real, Vector};
use mps_neighbors::{Domain, Parallel};

/// The inlets and outlets of a fluid.
#[derive(Debug)]
pub(crate) struct OpenBoundaries<T: Real, const D: usize> {
    inlets: Vec<Inlet<T, D>>,
    outlets: Vec<Outlet<T, D>>,
    /// Density ratio beyond each outlet in this step.
    beyond: Vec<T>,
    /// Mean speed through the plane of each outlet in the last step \[m/s\].
    speed: Vec<Option<T>>,
    /// Volume that enters per time \[m^D/s\].
    inflow: T,
    /// Number of the next particle.
    next_id: u32,
    /// Particles that have entered and left so far.
    passed: [u64; 2],
}

impl<T: Real, const D: usize> Default for OpenBoundaries<T, D> {
    fn default() -> Self {
        Self {
            inlets: Vec::new(),
            outlets: Vec::new(),
            beyond: Vec::new(),
            speed: Vec::new(),
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

    /// Lets fluid leave. The zone beyond its plane, twice the effective radius and a spacing deep, is filled with particles at rest;
    /// walls have to reach an effective radius further.
    ///
    /// # Errors
    /// If the opening is no whole number of spacings wide, or the run has begun.
    pub fn add_outlet(&mut self, outlet: Outlet<T, D>) -> Result<(), FluidError> {
        self.refuse_after_start()?;
        let spacing = self.config.spacing;
        outlet.opening.check(spacing)?;
        let density = self.eos.density(outlet.pressure);
        let layers = (self.zone() / spacing).to_double() as usize;
        for layer in 0..layers {
            for place in outlet.opening.lattice(spacing, T::of(layer as f64 + 0.5) * spacing) {
                let id = self.open_boundaries().number();
                self.particles.push(place, Vector::zeros(), density, outlet.pressure, id);
            }
        }
        self.rates.resize(self.particles.position.len());
        let open = self.open_boundaries();
        open.outlets.push(outlet);
        open.beyond.push(density);
        open.speed.push(None);
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
    fn zone(&self) -> T {
        T::of(2.0) * self.reference.radius + self.config.spacing
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

    /// Lets particles in and out. Afterwards the neighbour rows have to be rebuilt.
    pub(crate) fn let_pass(&mut self) -> Option<u32> {
        let depth = self.zone();
        let open = self.open.as_mut()?;
        let before = self.particles.position.len();
        let gone = |place: &Vector<T, D>| open.outlets.iter().any(|outlet| outlet.drops(place, depth));
        let keep: Vec<bool> = self.particles.position.iter().map(|place| !gone(place)).collect();
        let leaving = keep.iter().any(|kept| !kept);
        let first = open.next_id;
        let OpenBoundaries { inlets, next_id, .. } = &mut **open;
        for inlet in inlets.iter() {
            inlet.release(&mut self.boundary, |place, velocity| {
                self.particles.push(place, velocity, T::one(), T::zero(), *next_id);
                *next_id += 1;
            });
        }
        let born = self.particles.position.len() - before;
        if leaving {
            self.particles.for_each_field(&mut Keep(&keep));
        }
        let len = self.particles.position.len();
        open.passed[0] += born as u64;
        open.passed[1] += (before + born - len) as u64;
        self.rates.resize(len);
        Some(first)
    }

    /// Gives particles from `first` on, which have just entered, the density of their neighbours; reference density where there are none yet.
    pub(crate) fn welcome(&mut self, first: u32) {
        let newcomers: Vec<usize> =
            (0..self.particles.id.len()).filter(|i| self.particles.id[*i] >= first).collect();
        for i in newcomers {
            let (mut sum, mut weights) = (T::zero(), T::zero());
            self.view(&self.search.fluid).for_each(i, |pair| {
                if self.particles.id[pair.j] < first {
                    sum += pair.weight * self.particles.density[pair.j];
                    weights += pair.weight;
                }
            });
            if weights > T::zero() {
                self.particles.density[i] = sum / weights;
            }
        }
    }

    /// Drives the inlets, before forces are found.
    pub(crate) fn drive_inlets(&mut self) -> Result<(), FluidError> {
        let Some(open) = &mut self.open else { return Ok(()) };
        let dt = if self.last_dt > T::zero() {
            self.last_dt
        } else {
            self.config.cfl * self.config.spacing / self.config.sound_speed
        };
        open.inflow = T::zero();
        for inlet in &open.inlets {
            open.inflow += inlet.drive(&mut self.boundary, self.time, dt)?;
        }
        Ok(())
    }

    /// Finds the pressure beyond the outlets and takes the forces off the particles there: they go on with the speed at which they
    /// crossed the plane, and what the mean speed at the plane has changed by since.
    pub(crate) fn hold_outlets(&mut self, parallel: &Parallel) {
        let Some(open) = &mut self.open else { return };
        let (position, velocity) = (&self.particles.position, &self.particles.velocity);
        let slab = T::of(2.0) * self.reference.radius;
        let area = open.outlets.iter().fold(T::zero(), |area, outlet| area + outlet.opening.area());
        let expected = open.inflow / area;
        for (k, outlet) in open.outlets.iter().enumerate() {
            let speed = speed_at_plane(parallel, &outlet.opening, slab, position, velocity);
            let excess = match speed {
                Some(speed) if outlet.absorbing => speed - expected,
                _ => T::zero(),
            };
            let impedance = self.config.density * self.config.sound_speed;
            open.beyond[k] = self.eos.density(outlet.pressure + impedance * excess);
            let change = match (speed, open.speed[k]) {
                (Some(now), Some(before)) if self.last_dt > T::zero() => (now - before) / self.last_dt,
                _ => T::zero(),
            };
            open.speed[k] = speed;
            parallel.update(self.rates.acceleration.as_mut_slice(), |i, a| {
                if outlet.holds(&position[i]) {
                    *a = Vector::zeros();
                    a[outlet.opening.axis] = outlet.opening.along(change);
                }
            });
        }
    }

    /// Gives the particles beyond the outlets the density they are to have after `dt` \[s\].
    pub(crate) fn hold_densities(&mut self, parallel: &Parallel, dt: T) {
        let Some(open) = &self.open else { return };
        let (position, density) = (&self.particles.position, &self.particles.density);
        let held = |i: usize| {
            open.outlets
                .iter()
                .zip(&open.beyond)
                .find(|(outlet, _)| outlet.holds(&position[i]))
                .map(|(_, n)| *n)
        };
        parallel.update(self.rates.density_rate.as_mut_slice(), |i, rate| {
            if let Some(n) = held(i) {
                *rate = (n - density[i]) / dt;
            }
        });
    }

    /// Moves the points of the inlets with the fluid.
    pub(crate) fn advance_inlets(&mut self, dt: T) {
        let Some(open) = &self.open else { return };
        for inlet in &open.inlets {
            inlet.advance(&mut self.boundary, dt);
        }
    }

    /// Whether particle `i` is beyond an outlet.
    pub(crate) fn is_leaving(&self, i: usize) -> bool {
        let place = &self.particles.position[i];
        self.open.as_ref().is_some_and(|open| open.outlets.iter().any(|outlet| outlet.holds(place)))
    }
}

/// Mean speed through the plane of an opening \[m/s\]: the line of least squares through the particles up to `slab` \[m\] before it, at
/// the plane. (The mean over the slab is what it was when the sound was there; the delay would send a part of it back.)
fn speed_at_plane<T: Real, const D: usize>(
    parallel: &Parallel,
    opening: &Opening<T, D>,
    slab: T,
    position: &[Vector<T, D>],
    velocity: &[Vector<T, D>],
) -> Option<T> {
    let moments = |i: usize| {
        let x = opening.beyond(&position[i]);
        let u = opening.along(velocity[i][opening.axis]);
        if x <= T::zero() && x > -slab { [T::one(), x, x * x, u, x * u] } else { [T::zero(); 5] }
    };
    let add = |a: [T; 5], b: [T; 5]| core::array::from_fn(|k| a[k] + b[k]);
    let [n, x, xx, u, xu] = parallel.fold(position.len(), [T::zero(); 5], &moments, &add);
    let spread = n * xx - x * x;
    (spread > T::zero()).then(|| (xx * u - x * xu) / spread)
}

/// Keeps the marked entries of every field, in their order; those beyond the marks as well.
struct Keep<'a>(&'a [bool]);

impl FieldVisitor for Keep<'_> {
    fn visit<F: Pod + Send + Sync>(&mut self, _name: &'static str, field: &mut Vec<F>) {
        let mut marks = self.0.iter();
        field.retain(|_| marks.next().is_none_or(|kept| *kept));
    }
}
