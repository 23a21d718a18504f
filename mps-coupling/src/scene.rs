//! The nested time loop: a fluid and the structures it pushes.

use crate::budget::SubStep;
use crate::contact::{Contacts, Touch};
use crate::guard::{check_limit, check_masses, check_new, check_points};
use crate::overlap::check_water;
use crate::{Budget, CouplingError, Handed, Interface, Structure, StructureEnergy};
use core::ops::Range;
use mps_fluid::{Fluid, FluidEnergy, Push, Slip, Viscosity};
use mps_kernel::weights::Rational;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Domain, Open, Parallel};

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
    /// Sum of the mean velocities of the points the fluid sees, over the sub-steps so far \[m/s\].
    pub(crate) swept: Vec<Vector<T, D>>,
}

impl<T: Real, const D: usize> Body<T, D> {
    /// Forces of the fluid on the points in the present sub-step.
    fn gather<K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>>(&mut self, fluid: &Fluid<T, D, K, V, P>) {
        for (a, &i) in self.range.clone().zip(&self.interface.visible) {
            self.force[i as usize] = fluid.force_on(a);
        }
    }

    /// Adds the mean velocities of the last sub-step.
    fn sweep(&mut self) {
        let velocities = self.structure.mean_velocities();
        for (sum, &i) in self.swept.iter_mut().zip(&self.interface.visible) {
            *sum += velocities[i as usize];
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

/// A fluid with structures, advanced in one nested loop.
///
/// The partitioned scheme is sequential and sub-cycled (paper, sections 2.2.5 and 2.2.8), with the
/// order arranged so that the exchange is exact. The fluid finds its forces; the structures take
/// their sub-steps and compress the fluid next to them as they move; the fluid receives the mean of
/// what they felt, pair by pair, and closes its continuity equation with their *mean* velocity over
/// the step (the velocity-consistent grouping). Their acceleration does not enter the pressure they
/// show: the pressure answers their motion sub-step by sub-step, and an acceleration that lags by a
/// step is an added mass with a delay, which was measured to drive the gate unstable. Impulse lost by one
/// side is gained by the other to round-off, and compression gained by the fluid is work done by the structure.
///
/// Contact is not modelled: between structures, and between a structure and a wall, nothing acts but the fluid. Where none is left between them
/// the run ends with an error ([`refuse_contacts`](Self::refuse_contacts)).
pub struct Scene<
    T: Real,
    const D: usize,
    K: Kernel<T> = Rational,
    V: Viscosity<T, D> = (),
    P: Domain<T, D> = Open,
> {
    pub(crate) fluid: Fluid<T, D, K, V, P>,
    pub(crate) bodies: Vec<Body<T, D>>,
    pub(crate) budget: Budget<T, D>,
    pub(crate) substeps: usize,
    /// A step has failed after somebody had moved.
    pub(crate) broken: bool,
    pub(crate) contacts: Contacts<T, D>,
    /// Whether a step fails when a structure has come nearer to a wall or to another structure than three quarters of their spacing (the mean of
    /// both), after which they would pass through each other: [`CouplingError::Contact`]. Looked for on the occasion of new neighbour rows, without the
    /// images of periodic domains. What was near when a structure was added may stay near. Default true; false for whoever keeps them apart by forces of
    /// his own, or does not mind.
    pub refuse_contacts: bool,
    /// The two sides of the interface are compared every so many steps; 0 never. Default 100.
    pub audit_interval: u64,
    /// Sub-steps of the structures in one fluid step at least. Default 1. More are taken where a structure's own limit or the fluid at its
    /// surface ([`interface_border`](Self::interface_border)) asks for them.
    pub min_substeps: usize,
    /// Sub-steps of a structure in one fluid step beyond which the scene is refused. Default 2000.
    pub max_substeps: usize,
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Scene<T, D, K, V, P> {
    /// A scene without structures yet.
    pub fn new(fluid: Fluid<T, D, K, V, P>) -> Self {
        Self {
            fluid,
            bodies: Vec::new(),
            budget: Budget::default(),
            substeps: 0,
            broken: false,
            contacts: Contacts::default(),
            refuse_contacts: true,
            min_substeps: 1,
            audit_interval: 100,
            max_substeps: 2000,
        }
    }

    /// Adds a structure: registers its surface and shows its points to the fluid as one more wall.
    ///
    /// The law of the wall ([`Slip::Law`]) is held over the step, which is right for rigid and slow bodies; what bends is better
    /// off without ([`Slip::None`] follows the sub-steps).
    ///
    /// # Errors
    /// If the fields of the structure differ in length, a position or velocity is not finite, a volume or mass not positive, the spacing does
    /// not belong to the positions, particles of the fluid are inside the structure, or the scene has already begun.
    pub fn add_structure(
        &mut self,
        parallel: &Parallel,
        structure: Box<dyn Structure<T, D>>,
        slip: Slip,
    ) -> Result<usize, CouplingError> {
        let index = self.bodies.len();
        if self.fluid.steps() > 0 {
            return Err(CouplingError::TooLate { steps: self.fluid.steps() });
        }
        check_new(index, &*structure)?;
        let (positions, volumes) = (structure.positions(), structure.volumes());
        let radius = self.fluid.reference().radius;
        let interface = Interface::register(parallel, positions, &structure.spacings(), radius)?;
        let l0 = self.fluid.config().spacing;
        check_water(parallel, index, &*structure, &self.fluid.particles().position, l0)?;
        let volume = self.fluid.config().particle_volume();
        let shown = |i: &u32| *i as usize;
        let points: Vec<_> = interface.visible.iter().map(|i| positions[shown(i)]).collect();
        let relative = interface.visible.iter().map(|i| volumes[shown(i)] / volume);
        self.contacts.add(parallel, index, self.fluid.boundary(), &points, relative.clone(), l0)?;
        let range = self.fluid.boundary_mut().add_structure(&points, relative, slip);
        let force = vec![Vector::zeros(); positions.len()];
        let start = positions.to_vec();
        let swept = vec![Vector::zeros(); interface.visible.len()];
        self.bodies.push(Body { structure, interface, range, force, start, swept });
        self.budget.handed.push(Handed::default());
        Ok(index)
    }

    /// One step of the fluid, at most `longest` \[s\], with its sub-steps of the structures.
    /// Returns its length \[s\].
    ///
    /// Whoever steps to given times has to leave out what is left by rounding: velocities are displacements over steps, and in a
    /// step of 1e-16 s those are nothing but rounding.
    ///
    /// # Errors
    /// If `longest` is not greater than zero: nothing has changed then. If the fluid or a structure cannot go on, or a structure is about to pass
    /// through a wall or another one ([`refuse_contacts`](Self::refuse_contacts)): fluid and structures stand at different times then, to be
    /// looked at, and every further step is refused until a saved state is restored ([`transfer`](Self::transfer)).
    pub fn step(&mut self, parallel: &Parallel, longest: T) -> Result<T, CouplingError> {
        // Asked this way NaN is refused as well.
        let is_a_step = longest > T::zero();
        if !is_a_step {
            return Err(CouplingError::Step { longest: longest.to_double() });
        }
        if self.broken {
            return Err(CouplingError::Broken { time: self.fluid.time().to_double() });
        }
        self.broken = true;
        let dt = self.whole_step(parallel, longest)?;
        self.broken = false;
        Ok(dt)
    }

    fn whole_step(&mut self, parallel: &Parallel, longest: T) -> Result<T, CouplingError> {
        let rebuilds = self.fluid.rebuilds();
        let dt = self.fluid.begin_step(parallel)?.min(longest);
        if self.refuse_contacts && self.fluid.rebuilds() != rebuilds {
            self.look_for_contacts(parallel)?;
        }
        if self.audit_interval > 0 && self.fluid.steps().is_multiple_of(self.audit_interval) {
            self.audit(parallel);
        }
        let center = self.budget.center;
        let at_start = self.budget.fluid.map(|_| self.fluid.push_by_structures(parallel, &center));
        self.advance_structures(parallel, dt)?;
        if let (Some(fluid), Some(at_start)) = (&mut self.budget.fluid, at_start) {
            *fluid += (at_start + self.fluid.push_since(&center)).to_double() * dt.to_double();
        }
        self.fluid.finish_step(parallel, dt);
        for body in &self.bodies {
            let boundary = self.fluid.boundary_mut();
            let positions = body.structure.positions();
            for (a, &i) in body.range.clone().zip(&body.interface.visible) {
                boundary.position[a] = positions[i as usize];
            }
        }
        Ok(dt)
    }

    fn look_for_contacts(&mut self, parallel: &Parallel) -> Result<(), CouplingError> {
        let Some(touch) = self.contacts.search(parallel, self.fluid.boundary())? else { return Ok(()) };
        let Touch { index, other, place, distance } = touch;
        let place = place.iter().map(|x| x.to_double()).collect();
        let (distance, time) = (distance.to_double(), self.fluid.time().to_double());
        Err(CouplingError::Contact { index, other, place, distance, time })
    }

    /// The structures' part of a step: `m = ceil(dt / limit)` sub-steps (eq. 48), the same number for
    /// all, in each of which they feel the pressure that their own motion has raised so far.
    fn advance_structures(&mut self, parallel: &Parallel, dt: T) -> Result<(), CouplingError> {
        if self.bodies.is_empty() {
            return Ok(());
        }
        let time = self.fluid.time().to_double();
        // Somebody may have had hands on them since the last step.
        for (index, body) in self.bodies.iter().enumerate() {
            check_points(index, body, time)?;
            check_masses(index, &*body.structure)?;
        }
        self.substeps = self.substeps_for(parallel, dt)?;
        let sub_dt = dt / T::of(self.substeps as f64);
        let gravity = self.fluid.config().gravity;
        for body in &mut self.bodies {
            body.start.copy_from_slice(body.structure.positions());
            body.swept.fill(Vector::zeros());
        }
        // Those of the last sub-step, where the forces were found with the mean over the last step.
        for body in &self.bodies {
            body.show_velocities(&mut self.fluid);
        }
        for _ in 0..self.substeps {
            self.fluid.follow_shear();
            for (index, body) in self.bodies.iter_mut().enumerate() {
                body.gather(&self.fluid);
                body.structure
                    .advance(parallel, &body.force, &gravity, sub_dt, 1)
                    .map_err(|source| CouplingError::Structure { index, time, source })?;
                check_points(index, body, time)?;
                let step = SubStep {
                    force: &body.force,
                    velocity: body.structure.mean_velocities(),
                    position: body.structure.positions(),
                    start: &body.start,
                    dt: sub_dt,
                };
                self.budget.handed[index].book(&self.budget.center, &step);
                body.sweep();
            }
            for body in &self.bodies {
                body.show_velocities(&mut self.fluid);
            }
            self.fluid.compress_interface(parallel, sub_dt);
        }
        // Not the way over the step, which in single precision is a few units of the last place of a position.
        let share = T::one() / T::of(self.substeps as f64);
        let boundary = self.fluid.boundary_mut();
        for body in &self.bodies {
            for (a, sum) in body.range.clone().zip(&body.swept) {
                boundary.velocity[a] = sum * share;
            }
        }
        Ok(())
    }

    fn substeps_for(&self, parallel: &Parallel, dt: T) -> Result<usize, CouplingError> {
        let mut most = self.min_substeps.max(1) as f64;
        for (index, body) in self.bodies.iter().enumerate() {
            let (own, shared) = (body.structure.max_step(parallel), self.longest_substep(body));
            check_limit(index, own)?;
            // Not `min`, which would hide a limit that is no number.
            let limit = if shared < own || shared.partial_cmp(&shared).is_none() { shared } else { own };
            let substeps = (dt / limit).to_double().ceil();
            if substeps.is_nan() || substeps > self.max_substeps as f64 {
                let (limit, dt) = (limit.to_double(), dt.to_double());
                return Err(CouplingError::SubSteps { index, substeps, limit, dt });
            }
            most = most.max(substeps);
        }
        Ok(most as usize)
    }

    fn audit(&mut self, parallel: &Parallel) {
        let reactive = self.fluid.boundary().reactive();
        if reactive.is_empty() {
            return;
        }
        let on_fluid = self.fluid.push_by_structures(parallel, &self.budget.center);
        self.budget.audit(&self.fluid.boundary().force[reactive], on_fluid.force);
    }

    /// Refreshes normals and wetted marks of all structures, for output and probes.
    pub fn update_interfaces(&mut self, parallel: &Parallel) {
        // After a step that failed a structure may show anything.
        for body in self.bodies.iter_mut().filter(|body| body.structure.positions().len() == body.force.len())
        {
            body.interface.update_normals(parallel, body.structure.positions());
            let (fluid, first) = (&self.fluid, body.range.start);
            body.interface.update_wetted(|k| fluid.contacts(first + k));
        }
    }

    /// The fluid.
    pub fn fluid(&self) -> &Fluid<T, D, K, V, P> {
        &self.fluid
    }

    /// The fluid, to set initial values.
    pub fn fluid_mut(&mut self) -> &mut Fluid<T, D, K, V, P> {
        &mut self.fluid
    }

    /// Structure number `index`.
    pub fn structure(&self, index: usize) -> Option<&dyn Structure<T, D>> {
        self.bodies.get(index).map(|body| &*body.structure)
    }

    /// The same, between steps, to change its supports or to have its stability measured anew: what an
    /// [`ElasticBody`](crate::ElasticBody) holds is found by `(structure as &mut dyn Any).downcast_mut()`. The number of its points and, beyond
    /// what it moves in a sub-step, their places must stay.
    pub fn structure_mut(&mut self, index: usize) -> Option<&mut dyn Structure<T, D>> {
        self.bodies.get_mut(index).map(|body| &mut *body.structure)
    }

    /// Surface, normals and wetted points of structure number `index`.
    pub fn interface(&self, index: usize) -> Option<&Interface<T, D>> {
        self.bodies.get(index).map(|body| &body.interface)
    }

    /// Forces of the fluid on the points of structure number `index` in the last sub-step \[N\]. What it has been handed in a step is the
    /// difference of [`Budget::handed`] before and after it.
    pub fn forces(&self, index: usize) -> Option<&[Vector<T, D>]> {
        self.bodies.get(index).map(|body| body.force.as_slice())
    }

    /// Sub-steps the structures took in the last step.
    pub fn substeps(&self) -> usize {
        self.substeps
    }

    /// Begins the books anew, with moments about `center` \[m\], and from now on lets the fluid book what it receives as well
    /// ([`Budget::closure`]), which costs another visit of its pairs with structures in every step. Belongs between steps.
    pub fn keep_books(&mut self, center: Vector<T, D>) {
        let Budget { handed, residual, audits, .. } = &self.budget;
        let handed = vec![Handed::default(); handed.len()];
        let (residual, audits) = (*residual, *audits);
        self.budget = Budget { center, handed, fluid: Some(Push::default()), residual, audits };
    }

    /// What has been handed over so far.
    pub fn budget(&self) -> &Budget<T, D> {
        &self.budget
    }

    /// Energies of the fluid and of all structures together.
    pub fn energy(&self, parallel: &Parallel) -> (FluidEnergy<T>, StructureEnergy<T>) {
        let gravity = self.fluid.config().gravity;
        let mut sum = StructureEnergy::default();
        for body in &self.bodies {
            let energy = body.structure.energy(parallel, &gravity);
            sum.kinetic += energy.kinetic;
            sum.strain += energy.strain;
            sum.potential += energy.potential;
        }
        (self.fluid.energy(parallel), sum)
    }
}
