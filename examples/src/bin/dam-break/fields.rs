//! Fields for ParaView, snapshots and the film.

use crate::JET;
use crate::setup::{DamBreak, HEIGHT, PRESSURE, TANK};
use mps_examples::Failure;
use mps_fluid::surface::Surface;
use mps_io::{ColorMap, FieldOptions, FieldPicture, FieldWriter, Film, Image, PointCloud, View};
use mps_kernel::{Kernel, Real};
use mps_neighbors::Parallel;
use std::path::{Path, PathBuf};

/// Width of the pictures \[pixels\].
const WIDTH: u32 = 1100;
/// Height of the pictures \[m\]: the jet up the wall.
const SEEN: f64 = 2.0 * HEIGHT;
/// The walls are drawn this wide \[m\].
const MARGIN: f64 = 0.03;

/// Writes the state of the water in all forms.
pub(crate) struct Fields {
    dir: PathBuf,
    water: FieldWriter,
    film: Film,
    title: String,
    surface: Vec<Surface>,
}

impl Fields {
    pub(crate) fn new<T: Real, K: Kernel<T>>(dir: &Path, dam: &DamBreak<T, K>) -> Result<Self, Failure> {
        let fields = dir.join("fields");
        let walls = &dam.fluid().boundary().position;
        FieldWriter::new(&fields, "walls", FieldOptions::default())?.write(0.0, &PointCloud::new(walls))?;
        Ok(Self {
            dir: dir.to_path_buf(),
            water: FieldWriter::new(&fields, "water", FieldOptions::default())?,
            film: Film::create(dir.join("film.png"), 20)?,
            title: format!("Dam break, l₀ = {} mm", dam.fluid().config().spacing.to_double() * 1e3),
            surface: Vec::new(),
        })
    }

    /// One frame of water.pvd.
    pub(crate) fn write<T: Real, K: Kernel<T>>(
        &mut self,
        dam: &mut DamBreak<T, K>,
        parallel: &Parallel,
    ) -> Result<(), Failure> {
        let time = dam.fluid().time().to_double();
        dam.fluid_mut().classify_surface(parallel, &mut self.surface)?;
        let fluid = dam.fluid();
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
        Ok(())
    }

    /// One frame of film.png.
    pub(crate) fn frame<T: Real, K: Kernel<T>>(&mut self, dam: &DamBreak<T, K>) -> Result<(), Failure> {
        let image = self.picture(dam, [-MARGIN, -MARGIN], [TANK + MARGIN, SEEN])?;
        self.film.push(&image)?;
        Ok(())
    }

    /// A picture of its own at `moment`, over `sqrt(H/g)`; of the returning jet also a closer one.
    pub(crate) fn snapshot<T: Real, K: Kernel<T>>(
        &mut self,
        dam: &DamBreak<T, K>,
        moment: f64,
    ) -> Result<(), Failure> {
        let image = self.picture(dam, [-MARGIN, -MARGIN], [TANK + MARGIN, SEEN])?;
        image.write_png(self.dir.join(format!("snapshot_t{moment:.1}.png")))?;
        if moment == JET {
            let image = self.picture(dam, [TANK - 2.0 * HEIGHT, -MARGIN], [TANK + MARGIN, 1.2 * HEIGHT])?;
            image.write_png(self.dir.join(format!("jet_t{moment:.1}.png")))?;
        }
        Ok(())
    }

    fn picture<T: Real, K: Kernel<T>>(
        &self,
        dam: &DamBreak<T, K>,
        lower: [f64; 2],
        upper: [f64; 2],
    ) -> Result<Image, Failure> {
        let fluid = dam.fluid();
        let radius = 0.6 * fluid.config().spacing.to_double();
        let particles = fluid.particles();
        let scale = T::of(1.0 / PRESSURE);
        let pressure: Vec<T> = particles.pressure.iter().map(|&p| p * scale).collect();
        // The present boundary: a lifted gate moves.
        Ok(FieldPicture::new(WIDTH, View::new(lower, upper))
            .title(&self.title)
            .time(fluid.time().to_double())
            .plain(&fluid.boundary().position, radius, [150, 150, 150])
            .layer(&particles.position, radius, &pressure, (0.0, 1.0), ColorMap::Viridis, "p/(ρ g H) [–]")
            .render()?)
    }
}
