//! A plate that waves: one mode of motion, whose points move across it as `q cos(k x)`.

use mps_coupling::{Inertia, Structure, StructureEnergy};
use mps_kernel::Vector;
use mps_neighbors::Parallel;
use std::any::Any;
use std::error::Error;

/// A plate along the first axis with one mode, in the plane.
#[derive(Clone, Debug)]
pub struct Waving {
    rest: Vec<Vector<f64, 2>>,
    positions: Vec<Vector<f64, 2>>,
    mean: Vec<Vector<f64, 2>>,
    volumes: Vec<f64>,
    masses: Vec<f64>,
    spacing: f64,
    /// Wave number \[1/m\].
    k: f64,
    /// Mass of the mode \[kg/m\]: of the points, each with the square of its share.
    mass: f64,
    /// Stiffness of the mode \[N/m^2\].
    stiffness: f64,
    /// Amplitude \[m\].
    pub q: f64,
    /// Its velocity \[m/s\].
    pub v: f64,
}

impl Waving {
    /// Of points `spacing` \[m\] apart with the density of the plate \[kg/m^3\], flat and at rest, for the wave number \[1/m\]. The stiffness is
    /// per mass of the mode \[1/s^2\]: the square of its frequency without a fluid.
    pub fn new(rest: Vec<Vector<f64, 2>>, spacing: f64, density: f64, k: f64, stiffness: f64) -> Self {
        let (len, volume) = (rest.len(), spacing * spacing);
        let mass: f64 = rest.iter().map(|r| density * volume * (k * r.x).cos().powi(2)).sum();
        Self {
            positions: rest.clone(),
            rest,
            mean: vec![Vector::zeros(); len],
            volumes: vec![volume; len],
            masses: vec![density * volume; len],
            spacing,
            k,
            mass,
            stiffness: stiffness * mass,
            q: 0.0,
            v: 0.0,
        }
    }
}

impl Structure<f64, 2> for Waving {
    fn positions(&self) -> &[Vector<f64, 2>] {
        &self.positions
    }

    fn mean_velocities(&self) -> &[Vector<f64, 2>] {
        &self.mean
    }

    fn volumes(&self) -> &[f64] {
        &self.volumes
    }

    fn spacing(&self) -> f64 {
        self.spacing
    }

    fn max_step(&self, _: &Parallel) -> f64 {
        0.2 * (self.mass / self.stiffness).sqrt()
    }

    fn inertia(&self) -> Inertia<'_, f64> {
        Inertia::Points(&self.masses)
    }

    fn advance(
        &mut self,
        _: &Parallel,
        force: &[Vector<f64, 2>],
        _: &Vector<f64, 2>,
        dt: f64,
        _: usize,
    ) -> Result<(), Box<dyn Error + Send + Sync>> {
        let share = |x: f64| (self.k * x).cos();
        let push: f64 = force.iter().zip(&self.rest).map(|(f, r)| f.y * share(r.x)).sum();
        self.v += dt * (push - self.stiffness * self.q) / self.mass;
        self.q += dt * self.v;
        for ((place, mean), rest) in self.positions.iter_mut().zip(&mut self.mean).zip(&self.rest) {
            let y = rest.y + self.q * share(rest.x);
            mean.y = (y - place.y) / dt;
            place.y = y;
        }
        Ok(())
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn energy(&self, _: &Parallel, _: &Vector<f64, 2>) -> StructureEnergy<f64> {
        let (kinetic, strain) = (0.5 * self.mass * self.v * self.v, 0.5 * self.stiffness * self.q * self.q);
        StructureEnergy { kinetic, strain, potential: 0.0 }
    }
}
