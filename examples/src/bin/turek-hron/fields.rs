//! Fields for ParaView, snapshots and the film.

use crate::geometry::HEIGHT;
use crate::setup::{CYLINDER, Channel, FLAG, Settings};
use mps_examples::Failure;
use mps_io::{ColorMap, FieldOptions, FieldPicture, FieldWriter, Film, PointCloud, View};
use mps_kernel::{Real, Tensor};
use mps_neighbors::Parallel;
use std::path::{Path, PathBuf};

/// Width of the pictures \[pixels\].
const WIDTH: u32 = 1400;
/// How much of the channel they show \[m\].
const SHOWN: f64 = 1.5;

/// Writes the state of the scene in all forms.
pub(crate) struct Fields<T: Real> {
    dir: PathBuf,
    water: FieldWriter,
    flag: FieldWriter,
    film: Option<Film>,
    title: String,
    /// Vorticity at the ends of the colours \[1/s\].
    scale: f64,
    gradient: Vec<Tensor<T, 2>>,
}

impl<T: Real> Fields<T> {
    pub(crate) fn new(dir: &Path, settings: &Settings, scene: &Channel<T>) -> Result<Self, Failure> {
        let fields = dir.join("fields");
        let boundary = scene.fluid().boundary();
        let walls = &boundary.position[..boundary.reactive().start];
        FieldWriter::new(&fields, "walls", FieldOptions::default())?.write(0.0, &PointCloud::new(walls))?;
        if let Some(cylinder) = scene.structure(CYLINDER) {
            let cloud = PointCloud::new(cylinder.positions());
            FieldWriter::new(&fields, "cylinder", FieldOptions::default())?.write(0.0, &cloud)?;
        }
        Ok(Self {
            dir: dir.to_path_buf(),
            water: FieldWriter::new(&fields, "water", FieldOptions::default())?,
            flag: FieldWriter::new(&fields, "flag", FieldOptions::default())?,
            film: None,
            title: format!("{}: {} mm", settings.test.name().to_uppercase(), settings.spacing * 1e3),
            scale: 50.0 * settings.test.inflow(),
            gradient: Vec::new(),
        })
    }

    /// One frame of water.pvd and flag.pvd.
    pub(crate) fn write(&mut self, scene: &mut Channel<T>, parallel: &Parallel) -> Result<(), Failure> {
        let time = scene.fluid().time().to_double();
        scene.fluid_mut().measure_packing(parallel)?;
        let vorticity = self.vorticity(scene, parallel);
        let fluid = scene.fluid();
        let particles = fluid.particles();
        self.water.write(
            time,
            &PointCloud::new(&particles.position)
                .vector("velocity", &particles.velocity)
                .scalar("pressure", &particles.pressure)
                .scalar("density ratio", &particles.density)
                .scalar("packing", fluid.packing())
                .scalar("vorticity", &vorticity)
                .integer("id", &particles.id),
        )?;
        if let (Some(flag), Some(forces)) = (scene.structure(FLAG), scene.forces(FLAG)) {
            let cloud = PointCloud::new(flag.positions())
                .vector("velocity", flag.mean_velocities())
                .vector("force of the fluid", forces);
            self.flag.write(time, &cloud)?;
        }
        Ok(())
    }

    /// One frame of film.png, and a picture of its own if `snapshot`.
    pub(crate) fn draw(
        &mut self,
        scene: &Channel<T>,
        parallel: &Parallel,
        snapshot: bool,
    ) -> Result<(), Failure> {
        let time = scene.fluid().time().to_double();
        let l0 = scene.fluid().config().spacing.to_double();
        let vorticity = self.vorticity(scene, parallel);
        let boundary = scene.fluid().boundary();
        let mut picture = FieldPicture::new(WIDTH, View::new([-0.02, -0.02], [SHOWN, HEIGHT + 0.02]))
            .title(&self.title)
            .time(time)
            .plain(&boundary.position[..boundary.reactive().start], 0.6 * l0, [150, 150, 150])
            .layer(
                &scene.fluid().particles().position,
                0.6 * l0,
                &vorticity,
                (-self.scale, self.scale),
                ColorMap::Viridis,
                "vorticity [1/s]",
            );
        for body in [CYLINDER, FLAG] {
            if let Some(body) = scene.structure(body) {
                picture = picture.plain(body.positions(), 0.6 * body.spacing().to_double(), [60, 60, 60]);
            }
        }
        let image = picture.render()?;
        if snapshot {
            image.write_png(self.dir.join(format!("snapshot_{:06.0}ms.png", time * 1e3)))?;
        }
        let film = match &mut self.film {
            Some(film) => film,
            None => self.film.insert(Film::create(self.dir.join("film.png"), 20)?),
        };
        film.push(&image)?;
        Ok(())
    }

    fn vorticity(&mut self, scene: &Channel<T>, parallel: &Parallel) -> Vec<T> {
        scene.fluid().velocity_gradient(parallel, &mut self.gradient);
        self.gradient.iter().map(|g| g[(1, 0)] - g[(0, 1)]).collect()
    }
}
