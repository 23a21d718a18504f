//! What is stepped: a fluid with walls and bodies, or bodies alone.

mod dry;
mod wet;

use dry::Dry;
use wet::Wet;

use super::bodies::body;
use super::layout::Layout;
use super::water::{Water, slip, water};
use super::{Law, Viscous, vector};
use crate::Failure;
use mps_coupling::{ElasticBody, Scene, Structure, StructureEnergy};
use mps_fluid::{FluidEnergy, Limit};
use mps_io::scene_file::SceneFile;
use mps_kernel::{Kernel, Real, Transfer};
use mps_neighbors::Parallel;
use mps_solid::Solid;
use mps_solid::materials::Ambient;

/// What the elastic bodies of a scene are made of.
pub(super) type Rubber<T> = Ambient<Law<T>, T>;

/// An elastic body of a scene.
pub(super) type Elastic<T, const D: usize> = ElasticBody<T, D, Rubber<T>>;

/// A scene that can be stepped.
pub enum World<T: Real, const D: usize, K: Kernel<T>> {
    /// With fluid.
    Wet(Box<Wet<T, D, K>>),
    /// Bodies alone.
    Dry(Dry<T, D>),
}

impl<T: Real, const D: usize, K: Kernel<T>> World<T, D, K> {
    /// Builds what a scene describes.
    ///
    /// # Errors
    /// If a part refuses its numbers.
    pub fn new(
        scene: &SceneFile,
        layout: &Layout<D>,
        weight: K,
        parallel: &Parallel,
    ) -> Result<Self, Failure> {
        let background = scene.fluid.as_ref().map_or(0.0, |fluid| fluid.numerics.background_pressure);
        let bodies =
            scene.solids.iter().map(|solid| Ok(ElasticBody::new(body(solid, background, parallel)?)));
        let bodies = bodies.collect::<Result<Vec<Elastic<T, D>>, Failure>>()?;
        let Some(fluid) = &scene.fluid else {
            let [interval, ..] = scene.output.intervals(scene.end_time);
            return Ok(Self::Dry(Dry::new(bodies, vector(&scene.gravity), interval, parallel)));
        };
        let (fluid, movers) = water(scene, fluid, layout, weight)?;
        let mut wet = Scene::new(fluid);
        for (body, solid) in bodies.into_iter().zip(&scene.solids) {
            wet.add_structure(parallel, Box::new(body), slip(solid.slip))?;
        }
        // Behind the elastic ones, whose numbers are those of the file.
        for (points, fixed) in layout.fixed.iter().zip(&scene.fixed) {
            wet.add_structure(parallel, Box::new(points.body()), slip(fixed.slip))?;
        }
        let (elastic, cfl) = (scene.solids.len(), wet.fluid().config().cfl);
        let walls = layout.walls_len();
        Ok(Self::Wet(Box::new(Wet { scene: wet, movers, walls, elastic, last_dt: 0.0, cfl })))
    }

    /// One step of the fluid, or of bodies alone one interval of the table of probes; returns the length of a step
    /// \[s\].
    ///
    /// # Errors
    /// If fluid or body cannot go on.
    pub fn step(&mut self, parallel: &Parallel) -> Result<f64, Failure> {
        match self {
            Self::Wet(wet) => wet.step(parallel),
            Self::Dry(dry) => dry.step(parallel),
        }
    }

    /// Begins a step of the fluid and leaves it there, to be looked at; nothing for bodies alone.
    ///
    /// # Errors
    /// If the fluid cannot go on.
    pub fn begin(&mut self, parallel: &Parallel) -> Result<(), Failure> {
        if let Self::Wet(wet) = self {
            wet.show_motions();
            wet.scene.fluid_mut().begin_step(parallel)?;
        }
        Ok(())
    }

    /// From the next step on, what regularisation changes is remembered.
    pub fn remember_changes(&mut self) {
        if let Self::Wet(wet) = self {
            wet.scene.fluid_mut().remember_changes();
        }
    }

    /// Halves the length of steps this often, with so many sub-steps of the bodies at least; 0 and 1 for the usual pace.
    ///
    /// # Errors
    /// If the Courant number becomes too small.
    pub fn slow_down(&mut self, halvings: u32, substeps: usize) -> Result<(), Failure> {
        match self {
            Self::Wet(wet) => {
                let share = T::of(0.5_f64.powi(halvings as i32));
                // Half of the step it takes, which may be shorter than the one that is asked for.
                let stable = wet.scene.fluid().stable_courant_number();
                let cfl = if halvings == 0 { wet.cfl } else { wet.cfl.min(stable) };
                wet.scene.fluid_mut().set_courant_number(cfl * share)?;
                wet.scene.min_substeps = substeps.max(1);
            }
            Self::Dry(dry) => dry.halvings = halvings,
        }
        Ok(())
    }

    /// Saves the state between two steps, or restores it into a world of the same scene.
    pub fn transfer(&mut self, parallel: &Parallel, transfer: &mut Transfer<'_>) {
        match self {
            Self::Wet(wet) => transfer.within("wet", |transfer| wet.transfer(parallel, transfer)),
            Self::Dry(dry) => transfer.within("dry", |transfer| dry.transfer(transfer)),
        }
    }

    /// Simulated time \[s\].
    pub fn time(&self) -> f64 {
        match self {
            Self::Wet(wet) => wet.scene.fluid().time().to_double(),
            Self::Dry(dry) => dry.intervals as f64 * dry.interval,
        }
    }

    /// Steps done; of bodies alone the most sub-steps of any.
    pub fn steps(&self) -> u64 {
        match self {
            Self::Wet(wet) => wet.scene.fluid().steps(),
            Self::Dry(dry) => dry.steps,
        }
    }

    /// Calls of [`step`](Self::step) that have led to the present state.
    pub fn count(&self) -> u64 {
        match self {
            Self::Wet(wet) => wet.scene.fluid().steps(),
            Self::Dry(dry) => dry.intervals,
        }
    }

    /// What the length of the last step of the fluid followed from.
    pub fn limit(&self) -> Option<Limit> {
        self.fluid().map(|fluid| fluid.limit())
    }

    /// Sub-steps of the bodies in the last step.
    pub fn substeps(&self) -> usize {
        match self {
            Self::Wet(wet) => wet.scene.substeps(),
            Self::Dry(_) => 1,
        }
    }

    /// The fluid, if there is any.
    pub fn fluid(&self) -> Option<&Water<T, D, K>> {
        match self {
            Self::Wet(wet) => Some(wet.scene.fluid()),
            Self::Dry(_) => None,
        }
    }

    /// Fluid with bodies, if there is a fluid.
    pub fn coupled(&self) -> Option<&Scene<T, D, K, Viscous<T>>> {
        match self {
            Self::Wet(wet) => Some(&wet.scene),
            Self::Dry(_) => None,
        }
    }

    /// As [`coupled`](Self::coupled), to measure what is measured on request.
    pub fn coupled_mut(&mut self) -> Option<&mut Scene<T, D, K, Viscous<T>>> {
        match self {
            Self::Wet(wet) => Some(&mut wet.scene),
            Self::Dry(_) => None,
        }
    }

    /// Body number `k`.
    pub fn solid(&self, k: usize) -> Option<&Solid<T, D, Rubber<T>>> {
        match self {
            Self::Wet(wet) => {
                wet.scene.structure(k)?.as_any().downcast_ref::<Elastic<T, D>>().map(Elastic::solid)
            }
            Self::Dry(dry) => dry.bodies.get(k).map(Elastic::solid),
        }
    }

    /// The rigid bodies at rest, behind the elastic ones.
    pub fn fixed(&self) -> impl Iterator<Item = &dyn Structure<T, D>> {
        let wet = match self {
            Self::Wet(wet) => Some(wet),
            Self::Dry(_) => None,
        };
        wet.into_iter().flat_map(|wet| (wet.elastic..).map_while(|k| wet.scene.structure(k)))
    }

    /// Numbers of the points of walls that stand still, and of those that move.
    pub(super) fn wall_points(&self) -> [Vec<u32>; 2] {
        match self {
            Self::Wet(wet) => wet.wall_points(),
            Self::Dry(_) => [Vec::new(), Vec::new()],
        }
    }

    /// Energies of fluid and bodies.
    pub fn energy(&self, parallel: &Parallel) -> (FluidEnergy<T>, StructureEnergy<T>) {
        match self {
            Self::Wet(wet) => wet.scene.energy(parallel),
            Self::Dry(dry) => (FluidEnergy::default(), dry.energy(parallel)),
        }
    }
}
