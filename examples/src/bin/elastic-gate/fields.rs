//! Fields for ParaView, snapshots and the film.

use crate::observe::gate_positions;
use crate::setup::{GRAVITY, Gate, GateScene, RESERVOIR_WIDTH, WALL_HEIGHT, WATER_DEPTH};
use mps_examples::Failure;
use mps_fluid::surface::Surface;
use mps_io::{ColorMap, FieldOptions, FieldPicture, FieldWriter, Film, PointCloud, View};
use mps_kernel::tensor::{green_lagrange, largest_eigenvalue};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::Parallel;
use std::path::{Path, PathBuf};

/// Width of the pictures \[pixels\].
const WIDTH: u32 = 1100;

/// Writes the state of the scene in all forms.
pub(crate) struct Fields<T: Real> {
    dir: PathBuf,
    water: FieldWriter,
    gate: FieldWriter,
    film: Option<Film>,
    title: String,
    walls: Vec<Vector<T, 2>>,
    reference: Vec<Vector<T, 2>>,
    surface: Vec<Surface>,
}

impl<T: Real> Fields<T> {
    pub(crate) fn new<K: Kernel<T>>(
        dir: &Path,
        title: String,
        scene: &GateScene<T, K>,
    ) -> Result<Self, Failure> {
        let fields = dir.join("fields");
        let walls = scene.fluid().boundary().position[..scene.fluid().boundary().reactive().start].to_vec();
        FieldWriter::new(&fields, "walls", FieldOptions::default())?.write(0.0, &PointCloud::new(&walls))?;
        Ok(Self {
            dir: dir.to_path_buf(),
            water: FieldWriter::new(&fields, "water", FieldOptions::default())?,
            gate: FieldWriter::new(&fields, "gate", FieldOptions::default())?,
            film: None,
            title,
            walls,
            reference: gate_positions(scene).to_vec(),
            surface: Vec::new(),
        })
    }

    /// One frame of water.pvd and gate.pvd.
    pub(crate) fn write<K: Kernel<T>>(
        &mut self,
        scene: &mut GateScene<T, K>,
        parallel: &Parallel,
    ) -> Result<(), Failure> {
        scene.update_interfaces(parallel);
        let time = scene.fluid().time().to_double();
        scene.fluid_mut().classify_surface(parallel, &mut self.surface)?;
        let fluid = scene.fluid();
        let surface: Vec<u32> = self.surface.iter().map(|&s| s as u32).collect();
        let particles = fluid.particles();
        self.water.write(
            time,
            &PointCloud::new(&particles.position)
                .vector("velocity", &particles.velocity)
                .scalar("pressure", &particles.pressure)
                .scalar("density ratio", &particles.density)
                .scalar("packing", fluid.packing())
                .integer("surface", &surface)
                .integer("id", &particles.id),
        )?;
        if let (Some(gate), Some(interface), Some(forces)) =
            (gate(scene), scene.interface(0), scene.forces(0))
        {
            let displacement: Vec<_> =
                gate.solid().positions().iter().zip(&self.reference).map(|(r, r0)| r - r0).collect();
            let wetted: Vec<u32> = interface.wetted.iter().map(|&w| u32::from(w)).collect();
            self.gate.write(
                time,
                &PointCloud::new(gate.solid().positions())
                    .vector("displacement", &displacement)
                    .vector("velocity", gate.solid().velocities())
                    .vector("normal", &interface.normal)
                    .vector("force of the fluid", forces)
                    .scalar("principal strain", &principal_strain(gate))
                    .integer("wetted", &wetted),
            )?;
        }
        Ok(())
    }

    /// One frame of film.png, and a picture of its own if `snapshot`.
    pub(crate) fn draw<K: Kernel<T>>(
        &mut self,
        scene: &GateScene<T, K>,
        snapshot: bool,
    ) -> Result<(), Failure> {
        let Some(gate) = gate(scene) else { return Ok(()) };
        let time = scene.fluid().time().to_double();
        let l0 = scene.fluid().config().spacing.to_double();
        let particles = scene.fluid().particles();
        let scale = T::of(1.0 / (1000.0 * GRAVITY * WATER_DEPTH));
        let pressure: Vec<T> = particles.pressure.iter().map(|&p| p * scale).collect();
        let margin = 0.006;
        let view = View::new([-margin, -margin], [2.6 * RESERVOIR_WIDTH, WALL_HEIGHT - 3.0 * margin]);
        let solid_radius = 0.6 * gate.solid().spacing().max().to_double();
        let image = FieldPicture::new(WIDTH, view)
            .title(&self.title)
            .time(time)
            .plain(&self.walls, 0.6 * l0, [150, 150, 150])
            .layer(
                &particles.position,
                0.6 * l0,
                &pressure,
                (0.0, 1.0),
                ColorMap::Viridis,
                "water: p/(ρ g H) [–]",
            )
            .layer(
                gate.solid().positions(),
                solid_radius,
                &principal_strain(gate),
                (0.0, 0.15),
                ColorMap::Plasma,
                "gate: largest strain [–]",
            )
            .render()?;
        if snapshot {
            let name = format!("snapshot_{:03.0}ms.png", time * 1e3);
            image.write_png(self.dir.join(name))?;
        }
        let film = match &mut self.film {
            Some(film) => film,
            None => self.film.insert(Film::create(self.dir.join("film.png"), 20)?),
        };
        film.push(&image)?;
        Ok(())
    }
}

fn gate<T: Real, K: Kernel<T>>(scene: &GateScene<T, K>) -> Option<&Gate<T>> {
    scene.structure(0)?.as_any().downcast_ref()
}

/// Largest principal value of the Green-Lagrange strain of every particle.
fn principal_strain<T: Real>(gate: &Gate<T>) -> Vec<T> {
    gate.solid().particles().deformations().iter().map(|f| largest_eigenvalue(&green_lagrange(f))).collect()
}
