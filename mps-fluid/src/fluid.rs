//! The fluid and the story of one step.

use crate::budget::Books;
use crate::checks::{THINNEST, check_viscosity};
use crate::eos::{EquationOfState, Tait};
use crate::exchange::Exchange;
use crate::explain::Starts;
use crate::open::OpenBoundaries;
use crate::rates::{Rates, State};
use crate::search::Search;
use crate::stability::stable_courant_number;
use crate::terms::{Guard, Viscosity, WallPair};
use crate::turn::{Stage, Turn};
use crate::{Boundary, Compressibility, FluidConfig, FluidError, FluidParticles, Limit, Tension};
use mps_kernel::weights::Rational;
use mps_kernel::{Clock, Kernel, ParticleStore, Real, ReferenceDensity, Vector};
use mps_neighbors::{Domain, Open, Parallel, RowView, Rows};

/// A weakly compressible MPS fluid with density diffusion (paper 1, section 2.2.2).
///
/// `K` is the weight, `V` the viscosity (`()` for none) and `P` the domain ([`Open`] space or a
/// periodic box). One step is split in two, so that a structure can move in between:
/// [`begin_step`](Fluid::begin_step) finds the forces, also those on the structure, and
/// [`finish_step`](Fluid::finish_step) moves the fluid.
#[derive(Debug)]
pub struct Fluid<
    T: Real,
    const D: usize,
    K: Kernel<T> = Rational,
    V: Viscosity<T, D> = (),
    P: Domain<T, D> = Open,
> {
    pub(crate) config: FluidConfig<T, D>,
    pub(crate) kernel: K,
    pub(crate) viscosity: V,
    pub(crate) domain: P,
    pub(crate) reference: ReferenceDensity<T>,
    pub(crate) eos: Tait<T>,
    pub(crate) particles: FluidParticles<T, D>,
    pub(crate) boundary: Boundary<T, D>,
    pub(crate) search: Search<T, D>,
    pub(crate) rates: Rates<T, D>,
    pub(crate) exchange: Exchange<T, D>,
    pub(crate) open: Option<Box<OpenBoundaries<T, D>>>,
    pub(crate) books: Option<Box<Books<T, D>>>,
    pub(crate) time: Clock<T>,
    pub(crate) steps: u64,
    /// Length of the previous step \[s\], 0 before the first.
    pub(crate) last_dt: T,
    /// What the length of the last step followed from.
    pub(crate) limit: Limit,
    /// The largest Courant number with which no wave of the lattice grows.
    pub(crate) stable_courant: T,
    /// Of the step that has begun last, and the largest of all.
    pub(crate) compressibility: Compressibility<T>,
    pub(crate) compressibility_seen: Compressibility<T>,
    /// How far the present step is.
    pub(crate) turn: Turn,
    /// What particles were like when the step began, if somebody wants to know.
    pub(crate) starts: Option<Box<Starts<T, D>>>,
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// A fluid from its particles, the walls and structures around it and its parameters.
    ///
    /// # Errors
    /// If a parameter or the viscosity is out of range, the fields of the particles or those of the boundary differ in length, a particle has a
    /// position, velocity or density that is no number or a density ratio below 0.1, or a boundary point has no volume or is nowhere.
    pub fn new(
        config: FluidConfig<T, D>,
        kernel: K,
        viscosity: impl FnOnce(&ReferenceDensity<T>) -> V,
        domain: P,
        particles: FluidParticles<T, D>,
        boundary: Boundary<T, D>,
    ) -> Result<Self, FluidError> {
        config.validate()?;
        particles.check_lengths()?;
        particles.check_values()?;
        boundary.check_lengths()?;
        boundary.check_points()?;
        let len = particles.len();
        let reference = ReferenceDensity::lattice::<K, D>(&kernel, config.spacing, config.radius())?;
        let viscosity = viscosity(&reference);
        check_viscosity(viscosity.kinematic())?;
        let mut rates = Rates::default();
        rates.resize(len);
        let stable_courant = stable_courant_number::<T, D, K, V>(
            config.diffusion,
            &kernel,
            &reference,
            &viscosity,
            config.sound_speed,
        );
        let mut fluid = Self {
            viscosity,
            eos: config.equation_of_state(),
            search: Search::new(&config),
            config,
            kernel,
            domain,
            reference,
            particles,
            boundary,
            rates,
            exchange: Exchange::default(),
            open: None,
            books: None,
            time: Clock::default(),
            steps: 0,
            last_dt: T::zero(),
            limit: Limit::default(),
            stable_courant,
            compressibility: Compressibility::default(),
            compressibility_seen: Compressibility::default(),
            turn: Turn::default(),
            starts: None,
        };
        fluid.check_law()?;
        // So that the pressure belongs to the density from the start.
        fluid.evaluate_pressure(&Parallel::serial());
        Ok(fluid)
    }

    /// One whole step without a structure; returns its length \[s\].
    ///
    /// # Errors
    /// As [`begin_step`](Fluid::begin_step).
    pub fn step(&mut self, parallel: &Parallel) -> Result<T, FluidError> {
        let dt = self.begin_step(parallel)?;
        self.finish_step(parallel, dt);
        Ok(dt)
    }

    /// Everything that can be known before anybody moves: neighbours, collisions, pressures,
    /// accelerations, and the forces on the reactive points of the boundary.
    ///
    /// Returns the longest stable time step \[s\] (eq. 46). Begun once more without having been finished, a step has new forces for
    /// whatever has been changed meanwhile, and is not regularised again.
    ///
    /// # Errors
    /// If a particle's state is not finite or its speed makes the time step collapse; if the number of particles or of entries of a field has
    /// been changed; if one of the other halves has been refused since the last step, which is said once.
    pub fn begin_step(&mut self, parallel: &Parallel) -> Result<T, FluidError> {
        self.turn.admit()?;
        self.check_lengths()?;
        self.turn.stage = Stage::Begun;
        self.forget_field();
        self.meet_neighbours(parallel)?;
        self.drive_inlets()?;
        let again = core::mem::replace(&mut self.turn.regularised, true);
        if !again {
            self.remember_starts();
            self.shift(parallel)?;
            self.relax_densities(parallel)?;
            self.collide(parallel);
        }
        self.evaluate_pressure(parallel);
        self.sweep_correction(parallel);
        self.prepare_shear(parallel)?;
        self.sweep_momentum(parallel);
        let held = core::mem::replace(&mut self.turn.held, true);
        self.hold_outlets(parallel, held);
        self.react(parallel);
        self.prepare_exchange();
        self.turn.stage = Stage::Stuck;
        let dt = self.stable_step(parallel)?;
        self.turn.stage = Stage::Swept;
        Ok(dt)
    }

    /// Adds to the accelerations found by [`begin_step`](Fluid::begin_step) one that depends on the
    /// place \[m/s^2\]: a central force, a field that changes with time. Belongs between the halves of a step: elsewhere it does nothing, and
    /// [`begin_step`](Fluid::begin_step) says so.
    ///
    /// The walls do not know of it: what they show follows the gravity of the parameters. Hence for fluid
    /// away from walls, or for fields along them. The time step has been chosen without it. Beyond outlets nothing acts; the hydrostatic
    /// diffusion of the density takes what it does to the pressure for noise.
    pub fn add_acceleration(
        &mut self,
        parallel: &Parallel,
        field: impl Fn(&Vector<T, D>) -> Vector<T, D> + Sync,
    ) {
        if !self.turn.may("add_acceleration") || !self.turn.accepts(self.check_lengths()) {
            return;
        }
        self.book_field(parallel, &field);
        let position = &self.particles.position;
        parallel.update(self.rates.acceleration.as_mut_slice(), |i, a| *a += field(&position[i]));
    }

    /// Moves the fluid by `dt` \[s\] under the accelerations found by
    /// [`begin_step`](Fluid::begin_step): velocity, then density with the *new* velocity, then
    /// position. (Rates of velocity and density from the same old state are unstable.)
    ///
    /// Boundary velocities must be those of this step, boundary positions those of its start;
    /// whoever moves the boundary sets the new positions afterwards.
    ///
    /// Without a step that has begun, with a `dt` that is not positive and finite, or after a field has got another length it does nothing;
    /// the next [`begin_step`](Fluid::begin_step) returns the reason as its error.
    pub fn finish_step(&mut self, parallel: &Parallel, dt: T) {
        if !self.turn.may("finish_step") || !self.turn.lasts(dt) || !self.turn.accepts(self.check_lengths()) {
            return;
        }
        self.finish_exchange();
        self.follow_outlets(dt);
        let Rates { acceleration, flow, .. } = &mut self.rates;
        let acceleration = &*acceleration;
        let FluidParticles { position, velocity, .. } = &mut self.particles;
        parallel.update((velocity.as_mut_slice(), flow.as_mut_slice()), |i, (u, flow)| {
            *u += acceleration[i] * dt;
            (flow.position, flow.velocity) = (position[i], *u);
        });
        self.book_step(parallel, dt);
        self.sweep_density(parallel);
        self.hold_densities(dt);
        let FluidParticles { position, velocity, density, .. } = &mut self.particles;
        let (velocity, rate) = (&*velocity, &self.rates.density_rate);
        let domain = self.domain;
        let thinnest = T::of(THINNEST);
        parallel.update((position.as_mut_slice(), density.as_mut_slice()), |i, (r, n)| {
            *r = domain.wrap(*r + velocity[i] * dt);
            let next = *n + rate[i] * dt;
            // Not `max`, which would make a density of what is no number.
            *n = if next < thinnest { thinnest } else { next };
        });
        self.advance_inlets(dt);
        self.time = self.time.after(dt);
        self.last_dt = dt;
        self.steps += 1;
        self.turn = Turn::default();
    }

    /// Rebuilds the neighbour rows if they have expired. Particles enter and leave on that occasion.
    fn meet_neighbours(&mut self, parallel: &Parallel) -> Result<(), FluidError> {
        if !self.search.expired(parallel, &self.domain, &self.particles, &self.boundary) {
            return Ok(());
        }
        // Structures and openings come after the fluid has been made.
        self.boundary.check_points()?;
        let newcomers = self.let_pass();
        self.search.rebuild(parallel, &self.domain, &mut self.particles, &mut self.rates, &self.boundary)?;
        if let Some(first) = newcomers {
            self.welcome(first);
        }
        Ok(())
    }

    fn evaluate_pressure(&mut self, parallel: &Parallel) {
        let (eos, clip) = (self.eos, self.config.tension == Tension::Clip);
        let FluidParticles { pressure, density, velocity, position, .. } = &mut self.particles;
        parallel.update((pressure.as_mut_slice(), self.rates.state.as_mut_slice()), |i, (p, state)| {
            *p = eos.pressure(density[i]);
            if clip {
                *p = p.max(T::zero());
            }
            let (position, velocity, density) = (position[i], velocity[i], density[i]);
            *state = State { position, velocity, density, share: *p / density };
        });
    }

    /// Neighbourhood of fluid particles among themselves.
    pub(crate) fn view<'a>(&'a self, rows: &'a Rows) -> RowView<'a, T, D, K, P> {
        RowView {
            rows,
            points: &self.particles.position,
            targets: &self.particles.position,
            kernel: self.kernel,
            radius: self.reference.radius,
            domain: self.domain,
        }
    }

    /// Neighbourhood of fluid particles among the boundary points.
    pub(crate) fn boundary_view(&self) -> RowView<'_, T, D, K, P> {
        RowView { targets: &self.boundary.position, ..self.view(&self.search.boundary) }
    }

    pub(crate) fn wall_pair(&self) -> WallPair<T, D> {
        WallPair {
            gravity: self.config.gravity,
            rho0: self.config.density,
            compressibility: T::one()
                / (self.config.density * self.config.sound_speed * self.config.sound_speed),
            clip: self.config.tension == Tension::Clip,
            guard: Guard::new(&self.config, self.reference.gradient_factor::<D>()),
        }
    }

    /// The parameters.
    pub fn config(&self) -> &FluidConfig<T, D> {
        &self.config
    }

    /// The weight of the sums over neighbours.
    pub fn kernel(&self) -> &K {
        &self.kernel
    }

    /// The particles, in their present order.
    pub fn particles(&self) -> &FluidParticles<T, D> {
        &self.particles
    }

    /// The particles, to set initial velocities or densities. Their number must stay.
    pub fn particles_mut(&mut self) -> &mut FluidParticles<T, D> {
        &mut self.particles
    }

    /// Walls and structures as the fluid sees them.
    pub fn boundary(&self) -> &Boundary<T, D> {
        &self.boundary
    }

    /// Walls and structures, to move them. The number of points must stay.
    pub fn boundary_mut(&mut self) -> &mut Boundary<T, D> {
        &mut self.boundary
    }

    /// Reference lattice values.
    pub fn reference(&self) -> &ReferenceDensity<T> {
        &self.reference
    }

    /// Sum of weights over `n0` of each particle \[-\], as last measured by
    /// [`measure_packing`](Self::measure_packing); empty before that. It goes with its particle into another order, and is zero for one
    /// that has entered since.
    pub fn packing(&self) -> &[T] {
        &self.rates.packing
    }

    /// Accelerations \[m/s^2\] of the last step.
    pub fn acceleration(&self) -> &[Vector<T, D>] {
        &self.rates.acceleration
    }

    /// Simulated time \[s\].
    pub fn time(&self) -> T {
        self.time.now()
    }

    /// Steps done.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Number of fluid particles within the effective radius of reactive boundary point `a`.
    pub fn contacts(&self, a: usize) -> usize {
        use mps_kernel::Neighborhood;
        let rows = &self.search.reaction;
        if a >= rows.len() {
            return 0;
        }
        let mut count = 0;
        let view = RowView { points: &self.boundary.position, ..self.view(rows) };
        view.for_each(a, |pair| count += usize::from(pair.weight > T::zero()));
        count
    }

    /// How often the neighbour rows have been rebuilt.
    pub fn rebuilds(&self) -> u64 {
        self.search.rebuilds
    }

    /// Directed fluid-fluid pairs in the present rows, those in the skin included.
    pub fn pairs(&self) -> usize {
        self.search.fluid.pairs()
    }
}
