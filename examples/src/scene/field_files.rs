//! Fields for ParaView: of fluid, walls and bodies, as far as the scene asks for them.

use super::World;
use crate::Failure;
use mps_fluid::surface::Surface;
use mps_io::scene_file::{Field, FieldForm, FieldPrecision, Output, Region, SceneFile};
use mps_io::{FieldFormat, FieldOptions, FieldWriter, PointCloud};
use mps_kernel::tensor::{green_lagrange, largest_eigenvalue};
use mps_kernel::{Kernel, Real, Transfer, Vector};
use mps_neighbors::Parallel;
use std::path::Path;

/// Writes what ParaView reads.
pub(super) struct FieldFiles {
    water: FieldWriter,
    /// Of the walls that move, with the numbers of their points.
    moving: Option<(FieldWriter, Vec<u32>)>,
    solids: Vec<FieldWriter>,
    of_fluid: Vec<Field>,
    of_bodies: Vec<Field>,
    region: Option<Region>,
    surface: Vec<Surface>,
}

/// How a scene wants its files.
fn options(output: &Output) -> FieldOptions {
    FieldOptions {
        single_precision: output.field_precision.unwrap_or_default() == FieldPrecision::F32,
        format: match output.field_form.unwrap_or_default() {
            FieldForm::Vtu => FieldFormat::Vtu,
            FieldForm::Vtp => FieldFormat::Vtp,
            FieldForm::Vtkhdf => FieldFormat::VtkHdf,
        },
        ..FieldOptions::default()
    }
}

impl FieldFiles {
    /// In `dir`, where walls that stand still and fixed bodies, which do not change, are written at once.
    pub(super) fn new<T: Real, const D: usize, K: Kernel<T>>(
        dir: &Path,
        scene: &SceneFile,
        world: &World<T, D, K>,
    ) -> Result<Self, Failure> {
        let output = &scene.output;
        let writer = |name: &str| FieldWriter::new(dir, name, options(output));
        let region = output.field_region.as_ref();
        let [still, moving] = world.wall_points();
        if let Some(fluid) = world.fluid() {
            let points = &fluid.boundary().position;
            let shown = of_these(region, points, &still);
            writer("walls")?.write(0.0, &PointCloud::new(points).only(Some(&shown)))?;
        }
        for (body, described) in world.fixed().zip(&scene.fixed) {
            let (points, mut file) = (body.positions(), writer(&format!("fixed {}", described.name))?);
            file.write(0.0, &PointCloud::new(points).only(inside(region, points).as_deref()))?;
        }
        let moving = if moving.is_empty() { None } else { Some((writer("moving walls")?, moving)) };
        let solids = scene.solids.iter().map(|solid| writer(&format!("solid {}", solid.name)));
        Ok(Self {
            water: writer("water")?,
            moving,
            solids: solids.collect::<Result<_, _>>()?,
            of_fluid: output.chosen(&Field::OF_FLUIDS),
            of_bodies: output.chosen(&Field::OF_BODIES),
            region: output.field_region.clone(),
            surface: Vec::new(),
        })
    }

    /// Saves how far the collections are, or goes back to where they were.
    pub(super) fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { water, moving, solids, of_fluid: _, of_bodies: _, region: _, surface: _ } = self;
        transfer.within("water", |transfer| water.transfer(transfer));
        if let Some((writer, _)) = moving {
            transfer.within("moving walls", |transfer| writer.transfer(transfer));
        }
        solids.iter_mut().for_each(|writer| writer.transfer(transfer));
    }

    /// One frame of the water, of the walls that move, and of each body.
    pub(super) fn write<T: Real, const D: usize, K: Kernel<T>>(
        &mut self,
        world: &mut World<T, D, K>,
        parallel: &Parallel,
    ) -> Result<(), Failure> {
        self.measure(world, parallel)?;
        let time = world.time();
        if let Some(fluid) = world.fluid() {
            let particles = fluid.particles();
            let inside = inside(self.region.as_ref(), &particles.position);
            let surface: Vec<u32> = self.surface.iter().map(|&s| s as u32).collect();
            let mut cloud = PointCloud::new(&particles.position).only(inside.as_deref());
            for field in &self.of_fluid {
                let name = field.name();
                cloud = match field {
                    Field::Velocity => cloud.vector(name, &particles.velocity),
                    Field::Pressure => cloud.scalar(name, &particles.pressure),
                    Field::DensityRatio => cloud.scalar(name, &particles.density),
                    Field::Packing => cloud.scalar(name, fluid.packing()),
                    Field::Surface => cloud.integer(name, &surface),
                    Field::Id => cloud.integer(name, &particles.id),
                    Field::Displacement | Field::PrincipalStrain | Field::ForceOfTheFluid => cloud,
                };
            }
            self.water.write(time, &cloud)?;
            if let Some((writer, moving)) = &mut self.moving {
                let points = &fluid.boundary().position;
                let shown = of_these(self.region.as_ref(), points, moving);
                writer.write(time, &PointCloud::new(points).only(Some(&shown)))?;
            }
        }
        for (k, writer) in self.solids.iter_mut().enumerate() {
            let Some(solid) = world.solid(k) else { continue };
            let forces = world.coupled().and_then(|scene| scene.forces(k));
            let inside = inside(self.region.as_ref(), solid.positions());
            let has = |field: Field| self.of_bodies.contains(&field);
            let strain = if has(Field::PrincipalStrain) { principal_strains(world, k) } else { Vec::new() };
            let reference = solid.particles().reference_positions();
            let moved = solid.positions().iter().zip(reference).map(|(r, r0)| r - r0);
            let displacement: Vec<_> = if has(Field::Displacement) { moved.collect() } else { Vec::new() };
            let mut cloud = PointCloud::new(solid.positions()).only(inside.as_deref());
            for field in &self.of_bodies {
                let name = field.name();
                cloud = match (field, forces) {
                    (Field::Displacement, _) => cloud.vector(name, &displacement),
                    (Field::Velocity, _) => cloud.vector(name, solid.velocities()),
                    (Field::PrincipalStrain, _) => cloud.scalar(name, &strain),
                    (Field::ForceOfTheFluid, Some(forces)) => cloud.vector(name, forces),
                    _ => cloud,
                };
            }
            writer.write(time, &cloud)?;
        }
        Ok(())
    }

    /// What the fluid measures on request, if it is written.
    fn measure<T: Real, const D: usize, K: Kernel<T>>(
        &mut self,
        world: &mut World<T, D, K>,
        parallel: &Parallel,
    ) -> Result<(), Failure> {
        let has = |field: Field| self.of_fluid.contains(&field);
        let Some(scene) = world.coupled_mut() else { return Ok(()) };
        if has(Field::Surface) {
            scene.update_interfaces(parallel);
            scene.fluid_mut().classify_surface(parallel, &mut self.surface)?;
        } else if has(Field::Packing) {
            scene.fluid_mut().measure_packing(parallel)?;
        }
        Ok(())
    }
}

/// Numbers of the points in the region; `None` without a region.
fn inside<T: Real, const D: usize>(region: Option<&Region>, points: &[Vector<T, D>]) -> Option<Vec<u32>> {
    region.map(|region| (0_u32..).zip(points).filter(|(_, r)| is_in(region, r)).map(|(k, _)| k).collect())
}

/// Those of the points with these numbers that are in the region, all without a region.
fn of_these<T: Real, const D: usize>(
    region: Option<&Region>,
    points: &[Vector<T, D>],
    numbers: &[u32],
) -> Vec<u32> {
    let shown = |k: &u32| region.is_none_or(|region| is_in(region, &points[*k as usize]));
    numbers.iter().copied().filter(shown).collect()
}

fn is_in<T: Real, const D: usize>(region: &Region, r: &Vector<T, D>) -> bool {
    region.contains(&<[f64; D]>::from(r.map(Real::to_double)), 0.0)
}

/// Largest principal value of the Green-Lagrange strain of every particle.
pub(super) fn principal_strains<T: Real, const D: usize, K: Kernel<T>>(
    world: &World<T, D, K>,
    k: usize,
) -> Vec<T> {
    let Some(solid) = world.solid(k) else { return Vec::new() };
    solid.particles().deformations().iter().map(|f| largest_eigenvalue(&green_lagrange(f))).collect()
}

/// Bytes of a particle of the fluid, of a body, and of a point of a wall that moves in a frame, uncompressed.
pub(super) fn particle_bytes(output: &Output) -> [usize; 3] {
    let real = output.field_precision.unwrap_or_default().bytes();
    let place = 3 * real;
    [&Field::OF_FLUIDS[..], &Field::OF_BODIES[..], &[]]
        .map(|fields| place + output.chosen(fields).iter().map(|field| field.bytes(real)).sum::<usize>())
}
