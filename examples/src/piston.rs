//! A rigid plate on a spring that moves up and down: the simplest structure a fluid can push.

use mps_coupling::{Inertia, Structure, StructureEnergy};
use mps_kernel::Vector;
use mps_neighbors::Parallel;
use std::any::Any;
use std::error::Error;

/// A rigid plate on a spring, in the plane.
#[derive(Clone, Debug)]
pub struct Piston {
    positions: Vec<Vector<f64, 2>>,
    mean: Vec<Vector<f64, 2>>,
    volumes: Vec<f64>,
    spacing: f64,
    /// Mass \[kg/m\].
    pub mass: f64,
    /// Stiffness of the spring \[N/m^2\]; 0 for none.
    pub stiffness: f64,
    /// Displacement from the rest of the spring \[m\].
    pub y: f64,
    /// Velocity \[m/s\].
    pub v: f64,
    /// Whether it tells the scene its mass ([`Structure::inertia`]).
    pub tells_mass: bool,
}

impl Piston {
    /// Of points `spacing` \[m\] apart, at rest, on no spring.
    pub fn new(positions: Vec<Vector<f64, 2>>, spacing: f64, mass: f64) -> Self {
        let len = positions.len();
        Self {
            positions,
            mean: vec![Vector::zeros(); len],
            volumes: vec![spacing * spacing; len],
            spacing,
            mass,
            stiffness: 0.0,
            y: 0.0,
            v: 0.0,
            tells_mass: false,
        }
    }
}

impl Structure<f64, 2> for Piston {
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
        if self.tells_mass { Inertia::Rigid(self.mass) } else { Inertia::Unknown }
    }

    fn advance(
        &mut self,
        _: &Parallel,
        force: &[Vector<f64, 2>],
        _: &Vector<f64, 2>,
        dt: f64,
        _: usize,
    ) -> Result<(), Box<dyn Error + Send + Sync>> {
        let push: f64 = force.iter().map(|f| f.y).sum();
        self.v += dt * (push - self.stiffness * self.y) / self.mass;
        self.y += dt * self.v;
        let moved = Vector::from([0.0, dt * self.v]);
        self.positions.iter_mut().for_each(|r| *r += moved);
        self.mean.fill(moved / dt);
        Ok(())
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn energy(&self, _: &Parallel, _: &Vector<f64, 2>) -> StructureEnergy<f64> {
        let (kinetic, strain) = (0.5 * self.mass * self.v * self.v, 0.5 * self.stiffness * self.y * self.y);
        StructureEnergy { kinetic, strain, potential: 0.0 }
    }
}
