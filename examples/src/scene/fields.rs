//! Fields for ParaView, pictures and the film.

use super::field_files::{FieldFiles, principal_strains};
use super::slice::{Slice, pick};
use super::{World, vector};
use crate::Failure;
use mps_io::scene_file::{Corners, SceneFile};
use mps_io::{ColorMap, FieldPicture, Film, View};
use mps_kernel::{Kernel, Real, Transfer, Vector};
use mps_neighbors::Parallel;
use std::path::{Path, PathBuf};

/// Width of the pictures \[pixels\].
const WIDTH: u32 = 1100;
const GREY: [u8; 3] = [150, 150, 150];
const DARK: [u8; 3] = [60, 60, 60];
/// Frames of the film in a second.
const RATE: u16 = 20;

/// Writes the state of a scene in all forms.
pub(super) struct Fields {
    dir: PathBuf,
    title: String,
    files: FieldFiles,
    /// Number of elastic bodies.
    solids: usize,
    film: Option<Film>,
    view: View,
    slice: Slice,
    pressure_scale: f64,
    strain_scale: f64,
    /// Time between pictures \[s\].
    picture_interval: f64,
}

/// In milliseconds, or, where pictures are closer than one of them, in the largest of the smaller units that tells them apart.
fn picture_name(time: f64, interval: f64) -> String {
    let fine = [("us", 1e6), ("ns", 1e9), ("ps", 1e12)];
    if interval <= 0.0 || interval >= 1e-3 {
        return format!("picture_{:06.0}ms.png", time * 1e3);
    }
    let (unit, share) = fine.into_iter().find(|(_, share)| interval * share >= 1.0).unwrap_or(("fs", 1e15));
    format!("picture_{:09.0}{unit}.png", time * share)
}

impl Fields {
    pub(super) fn new<T: Real, const D: usize, K: Kernel<T>>(
        dir: &Path,
        scene: &SceneFile,
        world: &World<T, D, K>,
    ) -> Result<Self, Failure> {
        let output = &scene.output;
        let (view, slice) = shown(scene, world);
        Ok(Self {
            dir: dir.to_path_buf(),
            title: scene.title.clone(),
            files: FieldFiles::new(&dir.join("fields"), scene, world)?,
            solids: scene.solids.len(),
            film: None,
            view,
            slice,
            pressure_scale: output.pressure_scale.unwrap_or_else(|| pressure_scale(scene, world)),
            strain_scale: output.strain_scale.unwrap_or(0.1),
            picture_interval: output.intervals(scene.end_time)[3],
        })
    }

    /// Saves how far the collections and the film are, or goes back to where they were.
    pub(super) fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self {
            dir,
            title: _,
            files,
            solids: _,
            film,
            view: _,
            slice: _,
            pressure_scale: _,
            strain_scale: _,
            picture_interval: _,
        } = self;
        files.transfer(transfer);
        let mut marks = film.as_ref().map(Film::marks).unwrap_or_default();
        transfer.array("film", &mut marks);
        if transfer.is_restoring() && transfer.is_good() {
            // No frames, no film yet.
            let resumed = (marks[1] > 0).then(|| Film::resume(film_in(dir), RATE, marks)).transpose();
            match resumed {
                Ok(resumed) => *film = resumed,
                Err(error) => transfer.refuse(error),
            }
        }
    }

    /// Forces the film to the disk.
    pub(super) fn sync(&self) -> Result<(), Failure> {
        Ok(self.film.as_ref().map_or(Ok(()), Film::sync)?)
    }

    /// One frame for ParaView.
    pub(super) fn write<T: Real, const D: usize, K: Kernel<T>>(
        &mut self,
        world: &mut World<T, D, K>,
        parallel: &Parallel,
    ) -> Result<(), Failure> {
        self.files.write(world, parallel)
    }

    /// One frame of `film.png` if `frame`, and a picture of its own if `picture`.
    pub(super) fn draw<T: Real, const D: usize, K: Kernel<T>>(
        &mut self,
        world: &World<T, D, K>,
        [frame, picture]: [bool; 2],
    ) -> Result<(), Failure> {
        let time = world.time();
        let mut drawn = FieldPicture::new(WIDTH, self.view).title(&self.title).time(time);
        let seen = |positions: &[Vector<T, D>], spacing: T| self.slice.of(positions, spacing.to_double());
        if let Some(fluid) = world.fluid() {
            let (boundary, particles) = (fluid.boundary(), fluid.particles());
            let radius = 0.6 * fluid.config().spacing.to_double();
            let kilo = T::of(1e-3);
            let pressure: Vec<T> = particles.pressure.iter().map(|&p| p * kilo).collect();
            let range = (0.0, 1e-3 * self.pressure_scale);
            for body in world.fixed() {
                let (radius, seen) =
                    (0.6 * body.spacing().to_double(), seen(body.positions(), body.spacing()));
                drawn = drawn.plain(&pick(body.positions(), &seen), radius, DARK);
            }
            let (walls, spacing) = (&boundary.position[..boundary.reactive().start], fluid.config().spacing);
            let water = seen(&particles.position, spacing);
            drawn = drawn.plain(&pick(walls, &seen(walls, spacing)), radius, GREY).layer(
                &pick(&particles.position, &water),
                radius,
                &pick(&pressure, &water),
                range,
                ColorMap::Viridis,
                "fluid: p [kPa]",
            );
        }
        for k in 0..self.solids {
            let Some(solid) = world.solid(k) else { continue };
            let radius = 0.6 * solid.spacing().max().to_double();
            let label =
                if k == 0 { "solids: largest strain [–]".to_owned() } else { format!("solid {}", k + 1) };
            let shown = seen(solid.positions(), solid.spacing().max());
            drawn = drawn.layer(
                &pick(solid.positions(), &shown),
                radius,
                &pick(&principal_strains(world, k), &shown),
                (0.0, self.strain_scale),
                ColorMap::Plasma,
                &label,
            );
        }
        let image = drawn.render()?;
        if picture {
            image.write_png(self.dir.join(picture_name(time, self.picture_interval)))?;
        }
        if frame {
            let film = match &mut self.film {
                Some(film) => film,
                None => self.film.insert(Film::create(film_in(&self.dir), RATE)?),
            };
            film.push(&image)?;
        }
        Ok(())
    }
}

fn film_in(dir: &Path) -> PathBuf {
    dir.join("film.png")
}

/// What the scene asks for, or everything with a small margin; in three dimensions of the plane in the middle.
pub(super) fn shown<T: Real, const D: usize, K: Kernel<T>>(
    scene: &SceneFile,
    world: &World<T, D, K>,
) -> (View, Slice) {
    let (lower, upper, margin) = match &scene.output.view {
        Some(Corners { lower, upper }) => (vector(lower), vector(upper), 0.0),
        None => {
            let (lower, upper) = extent(scene, world);
            (lower, upper, 0.05 * (upper[0] - lower[0]).max(upper[1] - lower[1]))
        }
    };
    let [low, high] = [lower, upper].map(|corner: Vector<f64, 3>| [corner[0], corner[1]]);
    let view = View::new(low.map(|x| x - margin), high.map(|x| x + margin));
    (view, Slice { z: 0.5 * (lower[2] + upper[2]) })
}

/// The corners of the box around all points of a scene \[m\].
fn extent<T: Real, const D: usize, K: Kernel<T>>(
    scene: &SceneFile,
    world: &World<T, D, K>,
) -> (Vector<f64, 3>, Vector<f64, 3>) {
    let fluid = world.fluid().into_iter();
    let wet = fluid.flat_map(|fluid| fluid.particles().position.iter().chain(&fluid.boundary().position));
    let solid = (0..scene.solids.len()).filter_map(|k| world.solid(k)).flat_map(|solid| solid.positions());
    let (mut lower, mut upper) = (Vector::repeat(f64::INFINITY), Vector::repeat(f64::NEG_INFINITY));
    for r in wet.chain(solid) {
        let r: &Vector<T, D> = r;
        for (axis, x) in r.iter().enumerate().take(3) {
            lower[axis] = lower[axis].min(x.to_double());
            upper[axis] = upper[axis].max(x.to_double());
        }
    }
    (lower, upper)
}

fn pressure_scale<T: Real, const D: usize, K: Kernel<T>>(scene: &SceneFile, world: &World<T, D, K>) -> f64 {
    let (Some(fluid), Some(description)) = (world.fluid(), &scene.fluid) else { return 1.0 };
    let largest = fluid.particles().pressure.iter().map(|p| p.to_double()).fold(0.0, f64::max);
    let speed = 0.1 * description.sound();
    if largest > 0.0 { largest } else { 0.5 * description.density * speed * speed }
}

#[cfg(test)]
mod tests {
    use super::picture_name;

    #[test]
    fn pictures_have_names_of_their_own_however_close_they_are() {
        assert_eq!(picture_name(0.3, 0.05), "picture_000300ms.png");
        let names = [0.0, 4e-4, 8e-4].map(|time| picture_name(time, 4e-4));
        assert_eq!(names[1], "picture_000000400us.png");
        assert!(names[0] != names[1] && names[1] != names[2]);
        for interval in [1e-7, 4e-10, 3e-13] {
            let mut names: Vec<_> =
                (0..11).map(|k| picture_name(interval * f64::from(k), interval)).collect();
            names.dedup();
            assert_eq!(names.len(), 11, "{names:?}");
        }
        assert_eq!(picture_name(3e-7, 1e-7), "picture_000000300ns.png");
    }
}
