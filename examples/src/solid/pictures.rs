//! Fields of a body for ParaView, a film and pictures, coloured by the stress along the body.

use crate::{Due, Failure, Moments};
use mps_io::{ColorMap, FieldOptions, FieldPicture, FieldWriter, Film, Image, PointCloud, View};
use mps_kernel::tensor::determinant;
use mps_kernel::{Real, Tensor, Vector};
use mps_solid::{ConstitutiveModel, Solid};
use std::path::{Path, PathBuf};

/// Width of the pictures \[pixels\].
const WIDTH: u32 = 1100;

/// What pictures of a body show, and when.
#[derive(Clone, Debug)]
pub struct Look {
    /// Title of the pictures.
    pub title: String,
    /// What is seen.
    pub view: View,
    /// A line drawn besides the body \[m\]: what holds it.
    pub outline: Vec<[f64; 2]>,
    /// Largest stress along the body on the scale of colours \[kPa\].
    pub stress: f64,
    /// Between two frames \[s\].
    pub frame: f64,
    /// Name and time \[s\] of pictures of their own, in the order of time.
    pub stills: Vec<(&'static str, f64)>,
}

/// Writes the state of a body in all forms.
pub struct Pictures {
    dir: PathBuf,
    look: Look,
    fields: FieldWriter,
    film: Film,
    frame: Due,
    moments: Moments,
    names: std::vec::IntoIter<&'static str>,
}

impl Pictures {
    /// Writes to `dir`.
    ///
    /// # Errors
    /// If the files cannot be created.
    pub fn new(dir: &Path, look: Look) -> Result<Self, Failure> {
        let (names, times): (Vec<_>, Vec<_>) = look.stills.iter().copied().unzip();
        Ok(Self {
            dir: dir.to_path_buf(),
            fields: FieldWriter::new(dir.join("fields"), "body", FieldOptions::default())?,
            film: Film::create(dir.join("film.png"), 20)?,
            frame: Due::every(look.frame),
            moments: Moments::at(times),
            names: names.into_iter(),
            look,
        })
    }

    /// Writes what is due at `time` \[s\].
    ///
    /// # Errors
    /// If something cannot be written.
    pub fn look<T: Real, M: ConstitutiveModel<T, 2>>(
        &mut self,
        solid: &Solid<T, 2, M>,
        time: f64,
        last: bool,
    ) -> Result<(), Failure> {
        if self.frame.is_due(time) || last {
            self.write(solid, time)?;
            let image = self.picture(solid, time)?;
            self.film.push(&image)?;
        }
        while self.moments.due(time).is_some() {
            let name = self.names.next().unwrap_or("still");
            self.picture(solid, time)?.write_png(self.dir.join(format!("stress_{name}.png")))?;
        }
        Ok(())
    }

    /// Fields and a picture of the present state.
    ///
    /// # Errors
    /// If they cannot be written.
    pub fn keep<T: Real, M: ConstitutiveModel<T, 2>>(
        &mut self,
        solid: &Solid<T, 2, M>,
        time: f64,
        name: &str,
    ) -> Result<(), Failure> {
        self.write(solid, time)?;
        self.picture(solid, time)?.write_png(self.dir.join(format!("stress_{name}.png")))?;
        Ok(())
    }

    fn write<T: Real, M: ConstitutiveModel<T, 2>>(
        &mut self,
        solid: &Solid<T, 2, M>,
        time: f64,
    ) -> Result<(), Failure> {
        let reference = solid.particles().reference_positions();
        let moved: Vec<_> = solid.positions().iter().zip(reference).map(|(x, x0)| x - x0).collect();
        let stress: Vec<_> = (0..solid.len()).map(|i| cauchy_stress(solid, i)).collect();
        self.fields.write(
            time,
            &PointCloud::new(solid.positions())
                .vector("displacement", &moved)
                .vector("velocity", solid.velocities())
                .tensor("Cauchy stress", &stress)
                .scalar("stress along the body", &along(solid, T::one()))
                .integer("id", solid.particles().ids()),
        )?;
        Ok(())
    }

    fn picture<T: Real, M: ConstitutiveModel<T, 2>>(
        &self,
        solid: &Solid<T, 2, M>,
        time: f64,
    ) -> Result<Image, Failure> {
        let Look { title, view, outline, stress, .. } = &self.look;
        let values = along(solid, T::of(1e-3));
        let radius = 0.6 * solid.spacing().max().to_double();
        Ok(FieldPicture::new(WIDTH, *view)
            .title(title)
            .time(time)
            .line(outline, [90, 90, 90])
            .layer(
                solid.positions(),
                radius,
                &values,
                (-stress, *stress),
                ColorMap::BlueRed,
                "stress along the body [kPa]",
            )
            .render()?)
    }
}

/// Cauchy stress `P F^T/det F` of a particle \[Pa\], in the plane.
fn cauchy_stress<T: Real, M: ConstitutiveModel<T, 2>>(solid: &Solid<T, 2, M>, i: usize) -> Tensor<T, 2> {
    let f = &solid.particles().deformations()[i];
    let mut history = solid.history()[i];
    solid.material().first_piola(f, &mut history, T::zero()) * f.transpose() / determinant(f)
}

/// Cauchy stress on a cut across the body, along what was the first axis, times `unit`.
fn along<T: Real, M: ConstitutiveModel<T, 2>>(solid: &Solid<T, 2, M>, unit: T) -> Vec<T> {
    let stress = |i: usize| {
        let along: Vector<T, 2> = solid.particles().deformations()[i].column(0).normalize();
        along.dot(&(cauchy_stress(solid, i) * along)) * unit
    };
    (0..solid.len()).map(stress).collect()
}
